// relievo tune: the cheapest technique and settings within an error budget, and the proof.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measuring.h"
#include "core/analysis/report.h"
#include "core/analysis/tune.h"
#include "core/state/state_json.h"
#include "render/measure/picture_errors.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

namespace relievo::cli {

namespace {

constexpr int kWidth = 400, kHeight = 300; // of the pictures of --metric pixels and flip

struct TuneOptions {
    Common common;
    StateOptions state;
    std::string out, metric = "depth";
    std::vector<std::string> techniques;
    double maxError = 0., maxMissed = 100., maxFetches = std::numeric_limits<double>::infinity();
    int rays = 2000;
    std::uint32_t seed = 1;
};

struct MetricRow {
    std::string_view key, label;
};
constexpr MetricRow kMetrics[] = {{"depth", "RMSE of the depth"}, {"pixels", "RMSE of the texture's shift, pixels"}, {"flip", "mean FLIP"}};

struct Tuned {
    Subject subject;
    SweepPlan plan;
    std::vector<SweepRow> rows;
    std::vector<Candidate> candidates; // cheapest first
    const Candidate* chosen = nullptr;
};

// The worst of the pictures at kPictureAngles.
class PictureError {
public:
    PictureError(const Tuned& tuned, std::string_view metric, Renderer& renderer)
        : m_tuned(tuned)
        , m_resources(tuned.subject.resources)
        , m_metric(metric)
        , m_renderer(renderer)
    {
    }

    Expected<double> operator()(std::size_t setting)
    {
        double worst = 0.;
        for (std::size_t i = 0; i < kPictureAngles.size(); ++i) {
            const auto error = m_metric == "flip" ? flip(setting, i) : pixels(setting, i);
            if (!error)
                return error;
            worst = std::max(worst, *error);
        }
        return worst;
    }

private:
    State view(std::size_t angle) const { return fillingView(m_tuned.subject.state, kPictureAngles[angle]); }

    // A depth that is off by dt shows the texture of a point that lies depth x dt x tan(angle) away, seen at cos(angle).
    Expected<double> pixels(std::size_t setting, std::size_t angle)
    {
        const State state = withSetting(view(angle), m_tuned.plan.settings[setting]);
        const auto errors = pictureErrors(m_renderer, state, m_resources, kWidth, kHeight);
        if (!errors)
            return tl::unexpected(errors.error());
        const double slope = std::sin(kPictureAngles[angle] * std::numbers::pi / 180.);
        return errors->rmse * m_tuned.subject.field.depth * slope * kWidth / kTilesAcross;
    }

    Expected<double> flip(std::size_t setting, std::size_t angle)
    {
        while (m_judges.size() <= angle) {
            auto judge = PictureJudge::create(m_renderer, view(m_judges.size()), m_resources, kWidth, kHeight);
            if (!judge)
                return tl::unexpected(judge.error());
            m_judges.push_back(std::move(*judge));
        }
        return m_judges[angle].judge(m_tuned.plan.settings[setting]).map([](const auto& verdict) { return verdict.flip; });
    }

    const Tuned& m_tuned;
    Resources m_resources; // with the acceleration maps of what was judged
    std::string_view m_metric;
    Renderer& m_renderer;
    std::vector<PictureJudge> m_judges; // one an angle
};

Expected<const Candidate*> chooseOne(const TuneOptions& options, Tuned& tuned, const Progress& progress)
{
    const TuneBudget budget{options.maxError, options.maxMissed / 100., options.maxFetches};
    if (options.metric == "depth")
        return choose(tuned.candidates, budget);
    const auto context = WindowlessContext::create();
    if (!context)
        return tl::unexpected(context.error());
    Renderer renderer;
    PictureError error(tuned, options.metric, renderer);
    double asked = 0.;
    return choose(tuned.candidates, budget, [&](std::size_t setting) {
        progress.at(float(asked++ / double(tuned.candidates.size())));
        return error(setting);
    });
}

Result<Tuned> tune(const TuneOptions& options)
{
    if (!options.out.empty() && !isProjectFile(options.out))
        return problem({"a project is written as .relievo", "-o " + options.out, "Give it that suffix"}, WrongUsage);
    for (const auto& [name, value] :
        {std::pair("--max-error", options.maxError), {"--max-missed", options.maxMissed}, {"--max-fetches", options.maxFetches}})
        if (!(value >= 0.))
            return problem({"this is no number of at least 0", name, "Write one"}, WrongUsage);
    const auto techniques = techniquesOf(options.techniques);
    if (!techniques)
        return tl::unexpected(techniques.error());
    const Progress progress = shownProgress(options.common);
    auto subject = openSubject(options.state, options.metric != "depth", progress.part(0.f, 0.1f));
    if (!subject)
        return tl::unexpected(subject.error());
    Tuned tuned{std::move(*subject), {}, {}, {}};
    if (options.metric != "depth")
        tuned.subject.resources = fillingResources(std::move(tuned.subject.resources));
    for (const TechniqueRow* technique : *techniques)
        for (SearchSetting& setting : settingsOf(*technique, effectiveParameters(tuned.subject.state, 0), kTuneSteps))
            tuned.plan.settings.push_back(std::move(setting));
    tuned.plan.fields = {tuned.subject.field};
    tuned.plan.rays = options.rays;
    tuned.plan.seed = options.seed;
    auto rows = sweep(tuned.plan, progress.part(0.1f, options.metric == "depth" ? 1.f : 0.4f));
    if (!rows)
        return problem(rows.error());
    tuned.rows = std::move(*rows);
    tuned.candidates = candidatesOf(tuned.rows, tuned.plan.settings.size());
    const auto chosen = chooseOne(options, tuned, progress.part(0.4f, 1.f));
    if (!chosen)
        return problem(chosen.error());
    tuned.chosen = *chosen;
    if (tuned.chosen && !options.out.empty())
        if (const auto written = writeState(withSetting(tuned.subject.state, tuned.plan.settings[tuned.chosen->setting]), options.out);
            !written)
            return problem(written.error());
    return tuned;
}

std::string percent(double share)
{
    return figure(100. * share);
}

// By error; one that missed too much was not asked for it: those by what they miss.
bool isBetter(const Candidate& a, const Candidate& b)
{
    if (std::isnan(a.error) != std::isnan(b.error))
        return std::isnan(b.error);
    return std::isnan(a.error) ? a.missed < b.missed : a.error < b.error;
}

// The candidates worth printing: those up to the chosen one; when there is none, of each curve the one with the least error.
std::vector<const Candidate*> shown(const Tuned& tuned)
{
    std::vector<const Candidate*> list;
    for (const Candidate& candidate : tuned.candidates) {
        if (tuned.chosen) {
            list.push_back(&candidate);
            if (&candidate == tuned.chosen)
                break;
            continue;
        }
        const std::string& series = tuned.plan.settings[candidate.setting].series;
        const auto same = std::ranges::find(list, series, [&](const Candidate* c) { return tuned.plan.settings[c->setting].series; });
        if (same == list.end())
            list.push_back(&candidate);
        else if (isBetter(candidate, **same))
            *same = &candidate;
    }
    return list;
}

void printText(const TuneOptions& options, const Tuned& tuned)
{
    const auto* metric = std::ranges::find(kMetrics, options.metric, &MetricRow::key);
    if (tuned.chosen) {
        const SearchSetting& setting = tuned.plan.settings[tuned.chosen->setting];
        std::printf("%s (--technique %s", setting.label.c_str(), std::string(setting.technique->key).c_str());
        const std::string parameters = parametersText(setting);
        for (std::size_t at = 0; at < parameters.size();) {
            const std::size_t end = std::min(parameters.find(' ', at), parameters.size());
            std::printf(" --set %s", parameters.substr(at, end - at).c_str());
            at = end + 1;
        }
        std::printf(")\n\n%-12s %12s %6s %12s %10s\n", "angles, deg", "mean fetches", "most", "depth RMSE", "missed, %");
        for (const SweepRow& row : tuned.rows)
            if (row.setting == tuned.chosen->setting) {
                const AngleBand band = tuned.plan.bands[row.band];
                char angles[32];
                std::snprintf(angles, sizeof angles, "%g-%g", band.from, band.to);
                std::printf("%-12s %12s %6d %12s %10s\n", angles, figure(row.errors.meanFetches).c_str(), row.errors.maxFetches,
                    figure(row.errors.rmse).c_str(), percent(row.errors.share(row.errors.tooDeep)).c_str());
            }
        std::puts("\nWhat was tried, cheapest first:");
    } else {
        std::puts("Nothing is within the budget. The best of each technique:");
    }
    std::printf("%-36s %12s %6s %14s %10s\n", "setting", "mean fetches", "most", "error", "missed, %");
    for (const Candidate* candidate : shown(tuned))
        std::printf("%-36s %12s %6d %14s %10s%s\n", tuned.plan.settings[candidate->setting].label.c_str(),
            figure(candidate->meanFetches).c_str(), candidate->maxFetches, figure(candidate->error).c_str(),
            percent(candidate->missed).c_str(), candidate->within ? "  within" : "");
    std::printf("error: %s, worst view; budget %g\n", std::string(metric->label).c_str(), options.maxError);
}

nlohmann::ordered_json candidateJson(const Tuned& tuned, const Candidate& candidate)
{
    const SearchSetting& setting = tuned.plan.settings[candidate.setting];
    return {{"technique", setting.technique->key}, {"setting", setting.label},
        {"parameters", searchJson(*setting.technique, setting.parameters)}, {"meanFetches", candidate.meanFetches},
        {"maxFetches", candidate.maxFetches}, {"error", candidate.error}, {"missedPercent", 100. * candidate.missed},
        {"within", candidate.within}};
}

nlohmann::ordered_json tunedJson(const TuneOptions& options, const Tuned& tuned)
{
    nlohmann::ordered_json json{{"found", tuned.chosen != nullptr}, {"metric", options.metric}, {"maxError", options.maxError}};
    if (tuned.chosen) {
        json.update(candidateJson(tuned, *tuned.chosen));
        json["views"] = nlohmann::ordered_json::array();
        for (const SweepRow& row : tuned.rows)
            if (row.setting == tuned.chosen->setting)
                json["views"].push_back({{"fromDegrees", tuned.plan.bands[row.band].from}, {"toDegrees", tuned.plan.bands[row.band].to},
                    {"meanFetches", row.errors.meanFetches}, {"maxFetches", row.errors.maxFetches}, {"rmse", row.errors.rmse},
                    {"missedPercent", 100. * row.errors.share(row.errors.tooDeep)}});
        if (!options.out.empty())
            json["file"] = options.out;
    }
    json["tried"] = nlohmann::ordered_json::array();
    for (const Candidate& candidate : tuned.candidates)
        json["tried"].push_back(candidateJson(tuned, candidate));
    json["warnings"] = warningsJson(tuned.subject.warnings);
    return json;
}

int run(const TuneOptions& options)
{
    const auto tuned = tune(options);
    if (!tuned)
        return tell(tuned.error());
    tell(tuned->subject.warnings, options.common);
    if (options.common.json)
        print(tunedJson(options, *tuned));
    else
        printText(options, *tuned);
    if (tuned->chosen)
        return Done;
    char budget[48];
    std::snprintf(budget, sizeof budget, "--max-error %g", options.maxError);
    return tell({{"no setting of these techniques is within the budget", budget, "Allow more error, more missed rays or more fetches"},
        MissedTarget});
}

} // namespace

void addTune(CLI::App& app, int& exitCode)
{
    auto options = std::make_shared<TuneOptions>();
    CLI::App* command = app.add_subcommand("tune", "The cheapest technique and settings within an error budget");
    options->state.addTo(*command);
    options->common.addTo(*command);
    command->add_option("--max-error", options->maxError, "Largest error allowed in any view, in the unit of --metric")
        ->required()
        ->type_name("E");
    command
        ->add_option("--metric", options->metric,
            "depth: RMSE of the depth found, share of the relief's depth (when not given); pixels: RMSE of the texture's shift in a 400 "
            "pixels wide picture of a tile, pixels; flip: mean FLIP, 0 to 1")
        ->check(CLI::IsMember({"depth", "pixels", "flip"}))
        ->type_name("depth|pixels|flip");
    command
        ->add_option("--max-missed", options->maxMissed, "Most rays that may go through the first surface in any band of angles, percent")
        ->check(CLI::Range(0., 100.))
        ->type_name("PCT");
    command->add_option("--max-fetches", options->maxFetches, "Most texture fetches a ray, mean of the bands")->type_name("N");
    command->add_option("--techniques", options->techniques, "Only these techniques; when not given all but engines")
        ->type_name("KEY,KEY...")
        ->delimiter(',');
    command->add_option("--rays", options->rays, "Rays in each band of angles; 2000 when not given")
        ->check(CLI::Range(1, 1000000))
        ->type_name("N");
    command->add_option("--seed", options->seed, "Seed of the rays; 1 when not given")->type_name("N");
    options->state.addOutput(*command, "-o", options->out, "Project to write, with what was chosen")->type_name("PROJECT");
    command->callback([options, &exitCode] { exitCode = run(*options); });
}

} // namespace relievo::cli
