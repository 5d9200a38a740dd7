// How long pictures take to draw, as ratios of one run.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include "render/windowless.h"
#include <limits>
#include <string>
#include <string_view>

namespace relievo {

struct TimedFrame {
    State state; // its first pane is drawn
    std::string_view view; // key of kViews
};

// How often frames are drawn. One that has taken `enough` in all is not drawn again: a long frame is as steady as the median of short ones.
struct Rounds {
    int most;
    double enough = std::numeric_limits<double>::infinity(); // ms
};

// Milliseconds of each frame: the median of its rounds, each of which draws all frames in turn, after one that warms up what draws by
// another program than the frame before. By the clock between glFinish calls. Needs a current context. Errors: those of Renderer::draw,
// cancelled.
Expected<std::vector<double>> frameTimes(Renderer& renderer, Resources& resources, std::span<const TimedFrame> frames, int width,
    int height, const Rounds& rounds, const Progress& progress = {});

// The view that a search is timed in: "color", or "depth" where no colour map reads the place of the hit, because a driver leaves out a
// search whose result nothing shows.
std::string_view timedView(const Resources& resources);

// The plain textured quad that techniques are compared with: the same view of the State, without any relief and unlit.
TimedFrame plainQuad(const State& state);

} // namespace relievo
