// Interleaved frames by the wall clock: a software rasteriser's timer queries see only part of the work.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure/frame_time.h"
#include "core/state/techniques.h"
#include "core/state/views.h"
#include <algorithm>
#include <chrono>
#include <epoxy/gl.h>
#include <numeric>

namespace relievo {

namespace {
// Steps and switches of a search are uniforms.
bool sameProgram(const TimedFrame& a, const TimedFrame& b)
{
    Parameters same = a.state.parameters;
    for (const ParameterRow& row : kParameters)
        if (row.affects.contains(Affects::Search))
            set(same, row, get(b.state.parameters, row));
    return a.view == b.view && a.state.panes == b.state.panes && same == b.state.parameters;
}

double median(std::vector<double> values)
{
    if (values.empty())
        return 0.;
    std::ranges::sort(values);
    return 0.5 * (values[values.size() / 2] + values[(values.size() - 1) / 2]);
}
} // namespace

Expected<std::vector<double>> frameTimes(Renderer& renderer, Resources& resources, std::span<const TimedFrame> frames, int width,
    int height, const Rounds& rounds, const Progress& progress)
{
    Framebuffer framebuffer;
    framebuffer.resize(width, height);
    const Target target{.framebuffer = framebuffer.handle(), .width = width, .height = height};
    for (const TimedFrame& frame : frames)
        if (const auto made = resources.accelerationMaps.makeFor(frame.state, *resources.material); !made)
            return tl::unexpected(made.error());
    std::vector<std::vector<double>> times(frames.size());
    for (int round = 0; round <= rounds.most; ++round)
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const bool isWarm = i > 0 && sameProgram(frames[i], frames[i - 1]);
            if (round == 0 ? isWarm : !times[i].empty() && std::accumulate(times[i].begin(), times[i].end(), 0.) >= rounds.enough)
                continue;
            if (progress.cancelled())
                return cancelled(frames[i].state.name);
            progress.at(float(std::size_t(round) * frames.size() + i + 1) / float(std::size_t(rounds.most + 1) * frames.size()));
            glFinish();
            const auto start = std::chrono::steady_clock::now();
            if (const auto drawn = renderer.draw({frames[i].state, 0, resources, target, frames[i].view}); !drawn)
                return tl::unexpected(drawn.error());
            glFinish();
            if (round > 0)
                times[i].push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        }
    std::vector<double> medians;
    for (std::vector<double>& each : times)
        medians.push_back(median(std::move(each)));
    return medians;
}

std::string_view timedView(const Resources& resources)
{
    return resources.material && resources.material->map(MapKind::Color) ? knownView("color").key : knownView("depth").key;
}

TimedFrame plainQuad(const State& state)
{
    TimedFrame frame{ofFirstPane(state), knownView("color").key};
    frame.state.panes.front().technique = knownTechnique("flat").key;
    return frame;
}

} // namespace relievo
