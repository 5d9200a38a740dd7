// Draws a State: one function from values to a picture, for the window and for windowless contexts alike.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "render/draw_request.h"
#include "render/gl/framebuffer.h"
#include <array>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>

namespace relievo {

struct DrawnFrame; // render/glowing.h

// What a heat view shows, over the pixels that the mesh covers and of which it can tell; in its unit.
struct HeatNumbers {
    double mean = 0, p99 = 0, most = 0; // p99: 99 % of the pixels show less or as much
    std::array<float, 48> histogram{}; // shares of the pixels, in equal steps up to the bright end; the last one holds what is beyond too
};

// Of a view against the exact answer.
struct ErrorNumbers {
    double rmse = 0; // in the view's unit; a share of the relief's depth is at most 1 each
    double wrong = 0; // share of the pixels that are off by more than ViewRow::wrongFrom, or covered by one of the two alone
    double uncertain = 0; // share of the pixels of which the displaced mesh cannot tell: they count in neither
};
struct ViewNumbers {
    HeatNumbers heat;
    ErrorNumbers error; // of views against the exact answer
    glm::vec2 mostAt{0.5f}; // the pixel that shows most, share of the picture from its upper left corner
};

// Averages over the pixels that the mesh covers.
struct Measurement {
    double meanFetches = 0, maxFetches = 0; // texture reads of the search
    double covered = 0; // share of pixels
    std::optional<ViewNumbers> shown = {}; // of heat views, where it was asked for
    double ms = 0; // that the picture took in full resolution; 0: not timed
};

// Holds the uploads and programs of one context; all calls need that context (or one that shares with it) to be current.
class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Draws the passes of a picture (passes.h). Uploads what it reads and was not uploaded yet, builds programs when needed; acceleration
    // maps must be there. On a broken shader the last program that linked is used, and the error is returned after drawing. Alpha is 1 on
    // the mesh and on a plain or environment background, 0 on a transparent one; a glow leaves it. With a glow, rows of a picture have to
    // be drawn in order from below, no other picture between them; they are there when the last one is.
    Expected<void> draw(const DrawRequest& request);

    // Mean texture fetches a covered pixel of this view of the material, from a picture of at most 320 x 200.
    Expected<Measurement> measure(const State& state, std::size_t pane, const Resources& resources, float aspect);

    // The numbers of a heat view: of the request's own pane, camera and size; the target's framebuffer is not used.
    Expected<ViewNumbers> measureView(const DrawRequest& request);

    // True when files under RELIEVO_SHADERS changed since the last draw (cheap; ask it from a timer).
    bool shadersChanged() const;

    // Textures that lie in the context now: a scene pays only for what it turns on.
    int textureCount() const;

private:
    struct Impl;
    Expected<DrawnFrame> drawPasses(const DrawRequest& request); // into the request's target
    Expected<float> meteredExposure(const DrawRequest& request); // what Parameters::autoExposure multiplies light by; 1 without
    std::unique_ptr<Impl> m;
};

} // namespace relievo
