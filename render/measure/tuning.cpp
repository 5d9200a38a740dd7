// Settings measured by rays, then judged, by pictures where the metric wants them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure/tuning.h"
#include "render/measure/picture_errors.h"
#include "render/measure/picture_judge.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo {
namespace {
constexpr int kWidth = 400, kHeight = 300; // of the pictures

struct TunedView {
    std::string name;
    State state;
};

// Those that are looked at by the pane's own camera.
std::vector<TunedView> viewsOf(TuneViews views, const State& state, const Resources& resources)
{
    std::vector<TunedView> all = {{"this view", ofFirstPane(state)}};
    all.front().state.parameters.heightMips = false;
    if (views == TuneViews::Seen)
        return all;
    const State seen = all.front().state;
    all.clear();
    const Mesh& mesh = *resources.mesh;
    const std::size_t clip = std::size_t(seen.parameters.clip);
    const bool moves = mesh.deformation && clip < mesh.deformation->clips.size();
    const float length = moves ? mesh.deformation->clips[clip].seconds : 0.f;
    for (int i = 0; i < (views == TuneViews::Clip && !moves ? 1 : kTurns); ++i) {
        TunedView view{{}, seen};
        if (views == TuneViews::Around) {
            view.state.camera.yaw = std::remainder(seen.camera.yaw + 360.f * float(i) / kTurns, 360.f);
            view.name = std::to_string(std::lround(view.state.camera.yaw)) + "\u00b0";
        } else {
            view.state.parameters.time = length * float(i) / kTurns;
            view.name = std::to_string(std::lround(100. * i / kTurns)) + " %";
        }
        all.push_back(std::move(view));
    }
    return all;
}

// The worst of the pictures of a setting.
class WorstPicture {
public:
    WorstPicture(Renderer& renderer, std::vector<State> views, Resources resources)
        : m_renderer(renderer)
        , m_views(std::move(views))
        , m_resources(std::move(resources))
    {
    }

    // At kPictureAngles. A depth that is off by dt shows the texture of a point that lies depth x dt x tan(angle) away, seen at cos(angle).
    Expected<double> pixels(const SearchSetting& setting, double depth)
    {
        double worst = 0.;
        for (std::size_t i = 0; i < m_views.size(); ++i) {
            const auto errors = pictureErrors(m_renderer, withSetting(m_views[i], setting), m_resources, kWidth, kHeight);
            if (!errors)
                return tl::unexpected(errors.error());
            const double slope = std::sin(kPictureAngles[i] * std::numbers::pi / 180.);
            worst = std::max(worst, errors->rmse * depth * slope * kWidth / kTilesAcross);
        }
        return worst;
    }

    Expected<double> flip(const SearchSetting& setting)
    {
        double worst = 0.;
        for (std::size_t i = 0; i < m_views.size(); ++i) {
            if (m_judges.size() <= i) {
                auto judge = PictureJudge::create(m_renderer, m_views[i], m_resources, kWidth, kHeight);
                if (!judge)
                    return tl::unexpected(judge.error());
                m_judges.push_back(std::move(*judge));
            }
            const auto verdict = m_judges[i].judge(setting);
            if (!verdict)
                return tl::unexpected(verdict.error());
            worst = std::max(worst, verdict->flip);
        }
        return worst;
    }

private:
    Renderer& m_renderer;
    std::vector<State> m_views;
    Resources m_resources; // with the acceleration maps of what was judged
    std::vector<PictureJudge> m_judges; // one a view
};

Expected<const Candidate*> judged(
    Tuned& tuned, const State& state, const Resources& resources, const TuneQuestion& question, const Progress& progress)
{
    const auto pick = question.leastError ? chooseLeast : choose;
    const bool byAngles = question.views == TuneViews::Angles;
    if (question.metric == TuneMetric::Depth || (question.metric == TuneMetric::Pixels && !byAngles))
        return pick(tuned.candidates, question.budget, {});
    const auto context = WindowlessContext::create();
    if (!context)
        return tl::unexpected(context.error());
    Renderer renderer;
    std::vector<State> views;
    if (byAngles)
        for (const double angle : kPictureAngles)
            views.push_back(fillingView(state, angle));
    else
        for (const TunedView& view : viewsOf(question.views, state, resources))
            views.push_back(view.state);
    WorstPicture worst(renderer, std::move(views), byAngles ? fillingResources(resources) : resources);
    const double depth = double(effectiveParameters(state, 0).depth);
    double asked = 0.;
    return pick(tuned.candidates, question.budget, [&](std::size_t setting) -> Expected<double> {
        if (progress.cancelled())
            return cancelled(state.name);
        progress.at(float(asked++ / double(tuned.candidates.size())));
        const SearchSetting& of = tuned.settings[setting];
        return question.metric == TuneMetric::Flip ? worst.flip(of) : worst.pixels(of, depth);
    });
}

std::vector<RaySet> raysOf(
    const TuneQuestion& question, const State& state, const Resources& resources, Tuned& tuned, const Progress& progress)
{
    std::vector<RaySet> sets;
    if (question.views == TuneViews::Angles) {
        for (const AngleBand band : kAngleBands) {
            sets.push_back({bandRays(band, double(effectiveParameters(state, 0).depth), question.rays, question.seed)});
            char name[32];
            std::snprintf(name, sizeof name, "%g-%g", band.from, band.to);
            tuned.views.emplace_back(name);
        }
        return sets;
    }
    for (const TunedView& view : viewsOf(question.views, state, resources))
        if (RaySet set = viewRays(view.state, 0, resources, question.grid, progress); !set.rays.empty()) {
            sets.push_back(std::move(set));
            tuned.views.push_back(view.name);
        }
    return sets;
}
} // namespace

Expected<Tuned> tune(const State& state, const Resources& resources, const TuneQuestion& question, const Progress& progress)
{
    if (!resources.material || !resources.material->height)
        return failure(state.name, "the material has no height map to search", "Add one");
    const Parameters parameters = effectiveParameters(state, 0);
    Tuned tuned;
    for (const TechniqueRow* technique : question.techniques.empty() ? *techniquesNamed({}) : question.techniques)
        for (SearchSetting& setting : settingsOf(*technique, parameters, kTuneSteps))
            tuned.settings.push_back(std::move(setting));
    std::vector<RaySet> sets = raysOf(question, state, resources, tuned, progress);
    if (sets.empty())
        return failure(state.name, "nothing of the relief is in view", "Turn the view, or choose others");
    auto sweep = RaySweep::create(resources.material->height->withWrap(parameters.wrap), std::move(sets), false, progress);
    if (!sweep)
        return tl::unexpected(sweep.error());
    const bool byRays = question.metric == TuneMetric::Depth || question.views != TuneViews::Angles;
    const Progress measuring = progress.part(0.f, byRays && question.metric != TuneMetric::Flip ? 1.f : 0.35f);
    for (std::size_t i = 0; i < tuned.settings.size(); ++i) {
        const auto rows = sweep->measure(tuned.settings[i], i, 0, progress);
        if (!rows)
            return tl::unexpected(rows.error());
        tuned.rows.insert(tuned.rows.end(), rows->begin(), rows->end());
        measuring.at(float(i + 1) / float(tuned.settings.size()));
    }
    tuned.candidates = candidatesOf(
        tuned.rows, tuned.settings.size(), question.metric == TuneMetric::Pixels ? &HitErrors::rmsePixels : &HitErrors::rmse);
    const auto chosen = judged(tuned, state, resources, question, progress.part(0.35f, 1.f));
    if (!chosen)
        return tl::unexpected(chosen.error());
    if (*chosen)
        tuned.chosen = std::size_t(*chosen - tuned.candidates.data());
    return tuned;
}

} // namespace relievo
