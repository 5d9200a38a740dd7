// What one picture is to show, and where to.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/scene/exact_distances.h"
#include "core/scene/resources.h"
#include "core/state/camera_view.h"
#include "core/state/state.h"
#include <glm/vec2.hpp>
#include <memory>
#include <string_view>

namespace relievo {

// Where to draw: a framebuffer object of the current context (0 is the default one), the rectangle (0, 0, width, height) of it.
struct Target {
    unsigned framebuffer = 0;
    int width = 0, height = 0; // pixels
    bool linear = false; // float values without exposure, tone curve and sRGB (for EXR); else display values
    float lineWidth = 1.f; // of the wireframe, pixels
    glm::vec2 jitter{0.f}; // shift of the picture in pixels, for averaging several into a smooth one; soft shadows turn with it
    glm::vec2 lens{0.f}; // the point of the camera's lens that sees it, in the unit disc, for averaging several into a depth of field
    int firstRow = 0, rows = 0; // only these pixel rows, counted from below; 0 rows: all of them
    // Of a picture that is drawn in tiles: its size, and where this tile's lower left corner lies in it; 0: the target is the picture.
    int wholeWidth = 0, wholeHeight = 0, left = 0, below = 0;
    bool isPassing = false; // the picture lasts a moment: a mesh of more triangles than pixels may be drawn with fewer
};

constexpr float aspectOf(const Target& target)
{
    const int width = target.wholeWidth > 0 ? target.wholeWidth : target.width;
    const int height = target.wholeHeight > 0 ? target.wholeHeight : target.height;
    return float(width) / float(height > 0 ? height : 1);
}

// A pane of a State with the data behind it, seen by the pane's camera. State and resources must outlive it.
class DrawRequest {
public:
    // view: a key of kViews, instead of the pane's own.
    DrawRequest(const State& state, std::size_t pane, const Resources& resources, const Target& target, std::string_view view = {});

    const State& state() const { return m_state; }
    std::size_t pane() const { return m_pane; }
    const Resources& resources() const { return m_resources; }
    const Target& target() const { return m_target; }
    std::string_view view() const { return m_view; }
    const CameraView& camera() const { return m_camera; } // without jitter, lens and tile

    // The exact answer that a view of errors compares with. One of another camera, size, surface or mesh is not taken: then, and without
    // one, the view measures the search alone. Says whether it was taken.
    bool compareWith(std::shared_ptr<const ExactDistances> exact);
    const std::shared_ptr<const ExactDistances>& exact() const { return m_exact; }

private:
    const State& m_state;
    std::size_t m_pane;
    const Resources& m_resources;
    Target m_target;
    std::string_view m_view;
    CameraView m_camera;
    std::shared_ptr<const ExactDistances> m_exact;
};

} // namespace relievo
