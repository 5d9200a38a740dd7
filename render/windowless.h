// Pictures without a window: an EGL context without surface, whole pictures, and searches on the GPU.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/image.h"
#include "core/shader_text/program_text.h"
#include "core/trace/ray.h"
#include "render/renderer.h"
#include <memory>
#include <span>
#include <vector>

namespace relievo {

// An OpenGL 4.1 core context that needs no display, current on the calling thread while it lives.
class WindowlessContext {
public:
    // Errors say what was found and what is needed.
    static Expected<WindowlessContext> create();
    WindowlessContext(WindowlessContext&&) noexcept;
    WindowlessContext& operator=(WindowlessContext&&) noexcept;
    ~WindowlessContext();

private:
    struct Impl;
    explicit WindowlessContext(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m;
};

// Shift of the k-th of several averaged pictures, in pixels within [-0.5, 0.5): radical inverses of k + 1 in bases 2 and 3.
glm::vec2 pixelShift(int k);
// Where on the lens the k-th of them is seen from, in the unit disc, evenly: radical inverses in bases 5 and 7.
glm::vec2 lensPoint(int k);

inline constexpr int kMaxPictureSide = 16384; // pixels
inline constexpr int kMaxSamples = 256;

// A picture to be drawn.
struct Still {
    std::string_view view = {}; // key of kViews; "" for the pane's own
    int width = 0, height = 0; // pixels, at most kMaxPictureSide each
    int samples = 1; // pictures with shifted pixel grids and points of the lens that are averaged, 1 to kMaxSamples
    PixelType type = PixelType::U8; // U8, U16: display values, F32: linear ones
    std::shared_ptr<const ExactDistances> exact = {}; // what a view of errors compares with (DrawRequest::compareWith)
    int tile = 4096; // pixels a side of what is drawn at once; a picture with `exact` is drawn as a whole
};
// RGBA, row 0 at the top. Acceleration maps that the pane lacks are made and added to `resources`, which takes time. Needs a current
// context. Errors: sizes that the driver or the memory cannot hold, cancelled.
Expected<Image> drawStill(
    Renderer& renderer, const State& state, std::size_t pane, Resources& resources, const Still& still, const Progress& progress = {});

// The same without progress: U8 display values, or F32 linear values when `linear`.
Expected<Image> drawPicture(Renderer& renderer, const State& state, std::size_t pane, Resources& resources, std::string_view view,
    int width, int height, int samples, bool linear, const std::shared_ptr<const ExactDistances>& exact = nullptr);

// traceRays of core/trace on the GPU: the same text of technique `key` on the field's base level. Needs a current context.
// dialect: the language that the text is compiled as; GLSL ES 3.00 is what WebGL2 runs.
Expected<std::vector<SearchHit>> traceRaysOnGpu(std::string_view key, const Parameters& parameters, const HeightField* field,
    std::span<const SearchRay> rays, Dialect dialect = Dialect::Desktop);

} // namespace relievo
