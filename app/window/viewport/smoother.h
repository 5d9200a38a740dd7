// The mean of several pictures that differ by shifts below a pixel: smooth edges for a picture at rest.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/viewport/pane_layout.h"
#include "render/gl/framebuffer.h"
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace relievo {

// All calls but the plain ones need the context current that draws the pictures. At most 256 pictures.
class Smoother {
public:
    Smoother() = default;
    ~Smoother();
    Smoother(const Smoother&) = delete;
    Smoother& operator=(const Smoother&) = delete;

    void restart() { m_count = m_uploaded = 0; }
    int count() const { return m_count; }
    glm::vec2 nextShift() const; // of the picture to be added next, pixels in [-0.5, 0.5)
    glm::vec2 nextLens() const; // where it is seen from, in the unit disc of the lens
    void add(const Framebuffer& picture); // all of one size since the restart
    unsigned texture(); // the mean, row 0 below
    unsigned framebuffer(); // that reads it
    void copyTo(unsigned framebuffer, const PaneArea& to); // the mean, y up from below; afterwards `framebuffer` is bound

private:
    void upload();
    std::vector<std::uint16_t> m_sums;
    std::vector<std::uint8_t> m_pixels;
    int m_width = 0, m_height = 0, m_count = 0, m_uploaded = 0;
    unsigned m_texture = 0, m_framebuffer = 0;
};

} // namespace relievo
