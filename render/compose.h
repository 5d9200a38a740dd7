// Two pictures shown in one place: either of them, parted by a line, or their difference; enlarged pixel by pixel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/image/image.h"
#include <glm/vec2.hpp>
#include <memory>

namespace relievo {

struct Composition {
    // Difference: |second - first|; SignedDifference: grey where they agree, brighter where the second is. Of display values, times the
    // gain.
    enum class How { First, Second, Wipe, Difference, SignedDifference };
    How how = How::First;
    glm::vec2 divider{0.5f}; // a point of the wipe's line, share of the place from its upper left corner; the first picture is left of it
    float angle = 0.f; // by which the line is turned, degrees, clockwise from upright
    float lineWidth = 1.f; // pixels
    float gain = 1.f;
    // What is seen of the pictures: 1 / zoom of them along each side from this corner on, shares from the upper left.
    float zoom = 1.f; // 1 or more; from 2 on pixels are shown as squares
    glm::vec2 corner{0.f};
    bool operator==(const Composition&) const = default;
};

// Pixels of a framebuffer, y up from below.
struct ComposedPlace {
    unsigned framebuffer = 0;
    int x = 0, y = 0, width = 0, height = 0;
};

// Which picture of a wipe lies at `at`, a share of the place from its upper left corner; aspect: width / height of the place.
bool isSecondAt(const Composition& composition, glm::vec2 at, float aspect);

// Holds a program of one context; calls need it current.
class Composer {
public:
    Composer();
    ~Composer();
    // first, second: textures of the same extent, row 0 below, left bound to nothing and filtered as this needs it. Afterwards the place's
    // framebuffer is bound, with its whole viewport unknown. Errors: the shader is broken.
    Expected<void> draw(const ComposedPlace& place, unsigned first, unsigned second, const Composition& composition);

    // A picture, RGBA U8, row 0 at the top, as a texture for `draw`; the next one takes its place.
    unsigned upload(const Image& picture);

private:
    struct Impl;
    std::unique_ptr<Impl> m;
};

} // namespace relievo
