// relievo tune: the cheapest technique and settings within an error budget, and the proof.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measuring.h"
#include "core/analysis/report.h"
#include "core/state/state_json.h"
#include "render/measure/tuning.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

namespace relievo::cli {

namespace {

struct TuneOptions {
    Common common;
    StateOptions state;
    std::string out, metric = "depth";
    std::vector<std::string> techniques;
    double maxError = 0., maxMissed = 100., maxFetches = std::numeric_limits<double>::infinity();
    int rays = 2000;
    std::uint32_t seed = 1;
};

// What was found, and of what.
struct Outcome {
    Subject subject;
    Tuned tuned;
    const Candidate* chosen() const { return tuned.chosen ? &tuned.candidates[*tuned.chosen] : nullptr; }
    const SearchSetting& settingOf(const Candidate& candidate) const { return tuned.settings[candidate.setting]; }
};

Result<Outcome> tuneSubject(const TuneOptions& options)
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
    const TuneMetric metric = std::ranges::find(kTuneMetrics, options.metric, &TuneMetricRow::key)->metric;
    auto tuned = tune(subject->state, subject->resources,
        {.metric = metric,
            .budget = {options.maxError, options.maxMissed / 100., options.maxFetches},
            .techniques = *techniques,
            .rays = options.rays,
            .seed = options.seed},
        progress.part(0.1f, 1.f));
    if (!tuned)
        return problem(tuned.error());
    Outcome outcome{std::move(*subject), std::move(*tuned)};
    if (const Candidate* chosen = outcome.chosen(); chosen && !options.out.empty())
        if (const auto written = writeState(withSetting(outcome.subject.state, outcome.settingOf(*chosen)), options.out); !written)
            return problem(written.error());
    return outcome;
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
std::vector<const Candidate*> shown(const Outcome& outcome)
{
    std::vector<const Candidate*> list;
    const auto seriesOf = [&](const Candidate* candidate) { return outcome.settingOf(*candidate).series; };
    for (const Candidate& candidate : outcome.tuned.candidates) {
        if (outcome.chosen()) {
            list.push_back(&candidate);
            if (&candidate == outcome.chosen())
                break;
            continue;
        }
        const auto same = std::ranges::find(list, seriesOf(&candidate), seriesOf);
        if (same == list.end())
            list.push_back(&candidate);
        else if (isBetter(candidate, **same))
            *same = &candidate;
    }
    return list;
}

void printText(const TuneOptions& options, const Outcome& outcome)
{
    const auto* metric = std::ranges::find(kTuneMetrics, options.metric, &TuneMetricRow::key);
    if (const Candidate* chosen = outcome.chosen()) {
        const SearchSetting& setting = outcome.settingOf(*chosen);
        std::printf("%s (--technique %s", setting.label.c_str(), std::string(setting.technique->key).c_str());
        const std::string parameters = parametersText(setting);
        for (std::size_t at = 0; at < parameters.size();) {
            const std::size_t end = std::min(parameters.find(' ', at), parameters.size());
            std::printf(" --set %s", parameters.substr(at, end - at).c_str());
            at = end + 1;
        }
        std::printf(")\n\n%-12s %12s %6s %12s %10s\n", "angles, deg", "mean fetches", "most", "depth RMSE", "missed, %");
        for (const SweepRow& row : outcome.tuned.rows)
            if (row.setting == chosen->setting) {
                std::printf("%-12s %12s %6d %12s %10s\n", outcome.tuned.views[row.band].c_str(), figure(row.errors.meanFetches).c_str(),
                    row.errors.maxFetches, figure(row.errors.rmse).c_str(), percent(row.errors.share(row.errors.tooDeep)).c_str());
            }
        std::puts("\nWhat was tried, cheapest first:");
    } else {
        std::puts("Nothing is within the budget. The best of each technique:");
    }
    std::printf("%-36s %12s %6s %14s %10s\n", "setting", "mean fetches", "most", "error", "missed, %");
    for (const Candidate* candidate : shown(outcome))
        std::printf("%-36s %12s %6d %14s %10s%s\n", outcome.settingOf(*candidate).label.c_str(), figure(candidate->meanFetches).c_str(),
            candidate->maxFetches, figure(candidate->error).c_str(), percent(candidate->missed).c_str(),
            candidate->within ? "  within" : "");
    std::printf("error: %s, worst view; budget %g\n", std::string(metric->label).c_str(), options.maxError);
}

nlohmann::ordered_json candidateJson(const Outcome& outcome, const Candidate& candidate)
{
    const SearchSetting& setting = outcome.settingOf(candidate);
    return {{"technique", setting.technique->key}, {"setting", setting.label},
        {"parameters", searchJson(*setting.technique, setting.parameters)}, {"meanFetches", candidate.meanFetches},
        {"maxFetches", candidate.maxFetches}, {"error", candidate.error}, {"missedPercent", 100. * candidate.missed},
        {"within", candidate.within}};
}

nlohmann::ordered_json tunedJson(const TuneOptions& options, const Outcome& outcome)
{
    nlohmann::ordered_json json{{"found", outcome.chosen() != nullptr}, {"metric", options.metric}, {"maxError", options.maxError}};
    if (const Candidate* chosen = outcome.chosen()) {
        json.update(candidateJson(outcome, *chosen));
        json["views"] = nlohmann::ordered_json::array();
        for (const SweepRow& row : outcome.tuned.rows)
            if (row.setting == chosen->setting)
                json["views"].push_back({{"fromDegrees", kAngleBands[row.band].from}, {"toDegrees", kAngleBands[row.band].to},
                    {"meanFetches", row.errors.meanFetches}, {"maxFetches", row.errors.maxFetches}, {"rmse", row.errors.rmse},
                    {"missedPercent", 100. * row.errors.share(row.errors.tooDeep)}});
        if (!options.out.empty())
            json["file"] = options.out;
    }
    json["tried"] = nlohmann::ordered_json::array();
    for (const Candidate& candidate : outcome.tuned.candidates)
        json["tried"].push_back(candidateJson(outcome, candidate));
    json["warnings"] = warningsJson(outcome.subject.warnings);
    return json;
}

int run(const TuneOptions& options)
{
    const auto outcome = tuneSubject(options);
    if (!outcome)
        return tell(outcome.error());
    tell(outcome->subject.warnings, options.common);
    if (options.common.json)
        print(tunedJson(options, *outcome));
    else
        printText(options, *outcome);
    if (outcome->chosen())
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
