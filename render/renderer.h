// Draws a State: one function from values to a picture, for the window and for windowless contexts alike.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/scene/source.h"
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
    bool hasty = false; // the picture lasts a moment: a mesh of more triangles than pixels may be drawn with fewer
    bool mayBake = true; // makes a bound map that the resources lack; a window does not, it would stand still
};

// Averages over the pixels that the mesh covers.
struct Measurement {
    double meanFetches = 0, maxFetches = 0; // texture reads of the search
    double covered = 0; // share of pixels
};

// Holds the uploads and programs of one context; all calls need that context (or one that shares with it) to be current.
class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Draws pane `pane` of the State as `view` (a key of kViews). Uploads what the State uses and was not uploaded yet, builds
    // the program when needed. On a broken shader the last program that linked is used, and the error is returned after drawing.
    // Alpha is 1 on the mesh and on a plain or environment background, 0 on a transparent one.
    Expected<void> draw(const State& state, std::size_t pane, const Resources& resources, std::string_view view, const Target& target);

    // Mean texture fetches a covered pixel of this view of the material, from a picture of at most 320 x 200. mayBake: as of Target.
    Expected<Measurement> measure(const State& state, std::size_t pane, const Resources& resources, float aspect, bool mayBake = true);

    // True when files under RELIEVO_SHADERS changed since the last draw (cheap; ask it from a timer).
    bool shadersChanged() const;

    // Textures that lie in the context now: a scene pays only for what it turns on.
    int textureCount() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m;
};

// An off-screen colour and depth target.
class Framebuffer {
public:
    Framebuffer() = default;
    ~Framebuffer();
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;
    // Keeps what fits; floats: RGBA32F instead of RGBA8. What the driver cannot hold is an error, which drawing into it tells too.
    Expected<void> resize(int width, int height, bool floats = false);
    unsigned handle() const { return m_framebuffer; }
    int width() const { return m_width; }
    int height() const { return m_height; }

private:
    unsigned m_framebuffer = 0, m_color = 0, m_depth = 0;
    int m_width = 0, m_height = 0;
    bool m_floats = false, m_isWhole = false;
};

} // namespace relievo
