// Frames at equal accuracy: for each SET and angle the cheapest setting of every technique that is wrong on at most 0.1 % of rays,
// and relief 32+6 whatever its errors, as ratios to cell cones; 800x600, one interleaved run an angle, median of 9.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/settings.h"
#include "core/analysis/sweep.h"
#include "core/scene/source.h"
#include "render/measure/frame_time.h"
#include "render/measure/picture_errors.h"
#include <cstdio>
#include <cstdlib>

using namespace relievo;

namespace {

constexpr double kAllowed = 0.001; // share of wrong first hits
constexpr int kRays = 5000; // at each angle
constexpr int kSteps[] = {8, 16, 32, 64, 128, 512};

struct Timed {
    SearchSetting setting;
    double wrong, fetches;
};

[[noreturn]] void stop(const Error& error)
{
    std::fprintf(stderr, "%s\n", message(error).c_str());
    std::exit(1);
}

template <class T> T orStop(Expected<T> value)
{
    if (!value)
        stop(value.error());
    return std::move(*value);
}

// Settings by technique, the one with the fewest steps first.
SweepPlan planFor(const Opened& opened, const HeightField& heights)
{
    SweepPlan plan;
    for (const TechniqueRow* row : orStop(techniquesNamed({})))
        if (row->displaces)
            for (SearchSetting& setting : settingsOf(*row, opened.state.parameters, kSteps))
                plan.settings.push_back(std::move(setting));
    plan.fields = {{"set", opened.state.name, heights, double(opened.state.parameters.depth)}};
    plan.bands.clear();
    for (const double angle : kPictureAngles)
        plan.bands.push_back({angle, angle});
    plan.rays = kRays;
    return plan;
}

// What is timed at an angle: cell cones first, relief 32+6 second, then the cheapest setting of each other technique that qualifies.
std::vector<Timed> chosen(const SweepPlan& plan, std::span<const SweepRow> rows, std::size_t band)
{
    std::vector<Timed> timed(2);
    for (const SweepRow& row : rows) {
        const Timed one{plan.settings[row.setting], row.errors.wrongShare(), row.errors.meanFetches};
        const TechniqueRow* const technique = one.setting.technique;
        if (row.band != band)
            continue;
        if (technique->key == "cell-cone")
            timed[0] = one;
        else if (one.setting.label == "Relief 32+6")
            timed[1] = one;
        if (technique->key == "cell-cone" || one.wrong > kAllowed)
            continue;
        const auto same = std::find_if(timed.begin() + 2, timed.end(), [&](const Timed& t) { return t.setting.technique == technique; });
        if (same == timed.end())
            timed.push_back(one);
        else if (one.fetches < same->fetches)
            *same = one;
    }
    return timed;
}

void measure(Renderer& renderer, const char* source)
{
    const Opened opened = orStop(openSource(source, State()));
    Resources resources = orStop(loadResources(opened.state, opened.images, {}));
    if (!resources.material || !resources.material->height)
        stop({"there is no height map", source, "Give sets that have one"});
    const SweepPlan plan = planFor(opened, resources.material->height->withWrap(opened.state.parameters.wrap));
    const std::vector<SweepRow> rows = orStop(sweep(plan));
    for (std::size_t band = 0; band < kPictureAngles.size(); ++band) {
        const State view = fillingView(opened.state, kPictureAngles[band]);
        const std::vector<Timed> timed = chosen(plan, rows, band);
        std::vector<TimedFrame> frames;
        for (const Timed& one : timed)
            frames.push_back({withSetting(view, one.setting), std::string(timedView(resources))});
        const std::vector<double> times = orStop(frameTimes(renderer, resources, frames, 800, 600, {9}));
        std::printf("%s, %g degrees: cell cones %.1f ms, %.1f fetches, %.3f %% wrong\n", opened.state.name.c_str(), kPictureAngles[band],
            times[0], timed[0].fetches, 100. * timed[0].wrong);
        for (std::size_t i = 1; i < timed.size(); ++i)
            std::printf("    %5.2f x %-34s %6.1f fetches, %.3f %% wrong\n", times[i] / times[0], timed[i].setting.label.c_str(),
                timed[i].fetches, 100. * timed[i].wrong);
    }
    std::fflush(stdout);
}

} // namespace

int main(int count, char** arguments)
{
    const auto context = WindowlessContext::create();
    if (!context)
        stop(context.error());
    Renderer renderer;
    for (int i = 1; i < count; ++i)
        measure(renderer, arguments[i]);
}
