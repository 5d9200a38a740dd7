// relievo report: speed against error, measured and written as HTML, JSON or CSV.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measuring.h"
#include "core/analysis/report.h"
#include "core/ground/file.h"
#include "core/ground/shown_text.h"
#include "core/ground/text.h"
#include "core/image/files/image_file.h"
#include "core/image/samples/hard_cases.h"
#include "render/measure/far_views.h"
#include "render/measure/frame_time.h"
#include "render/measure/mesh_errors.h"
#include "render/measure/picture_errors.h"
#include "render/measure/picture_judge.h"
#include <charconv>
#include <epoxy/gl.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

namespace relievo::cli {

namespace {

constexpr double kEnough = 100.; // ms of drawing for the time of a frame

struct ReportOptions {
    Common common;
    StateOptions state;
    std::string out;
    std::vector<std::string> more, techniques, angles;
    bool hardCases = false, fast = false, noPictures = false, farViews = false;
    int rays = 5000, size = 0;
    std::uint32_t seed = 1;
};

std::optional<AngleBand> bandOf(const std::string& text)
{
    AngleBand band{};
    const char* const end = text.data() + text.size();
    const auto [dash, first] = std::from_chars(text.data(), end, band.from);
    if (first != std::errc() || dash == end || *dash != '-')
        return std::nullopt;
    const auto [rest, second] = std::from_chars(dash + 1, end, band.to);
    const bool good = second == std::errc() && rest == end && band.from >= 0. && band.from <= band.to && band.to <= 89.99;
    return good ? std::optional(band) : std::nullopt;
}

Result<std::vector<AngleBand>> bandsOf(const std::vector<std::string>& texts)
{
    std::vector<AngleBand> bands;
    for (const std::string& text : texts) {
        const auto band = bandOf(text);
        if (!band)
            return problem(
                {"this is no band of angles", "--angles " + text, "Write FROM-TO in degrees from the normal, 0 to 89.99, such as 60-80"},
                WrongUsage);
        bands.push_back(*band);
    }
    if (bands.empty())
        bands.assign(kAngleBands.begin(), kAngleBands.end());
    return bands;
}

Result<void> check(const ReportOptions& options)
{
    const std::string suffix = lowerSuffix(options.out);
    if (suffix != ".html" && suffix != ".json" && suffix != ".csv")
        return problem({"a report is written as .html, .json or .csv", "-o " + options.out, "Choose one of these suffixes"}, WrongUsage);
    if (options.farViews && options.noPictures)
        return problem({"far views are pictures", "--far-views", "Leave out --no-pictures"}, WrongUsage);
    if (!options.hardCases && options.size > 0)
        return problem(
            {"a material is measured in its own size", "--size", "Use it with --hard-cases, or write sample:NAME@N"}, WrongUsage);
    return {};
}

Result<std::vector<Subject>> subjectsOf(const ReportOptions& options, const Progress& progress)
{
    std::vector<Subject> subjects;
    const bool ownSource = !options.hardCases || !options.state.source.empty();
    const std::size_t count = (ownSource ? 1 : 0) + options.more.size() + (options.hardCases ? kHardCases.size() : 0);
    const float share = 1.f / float(count);
    const auto add = [&](const StateOptions& state, bool pictured) -> Result<void> {
        const float from = share * float(subjects.size());
        auto subject = openSubject(state, pictured && !options.noPictures, progress.part(from, from + share));
        if (!subject)
            return tl::unexpected(subject.error());
        subjects.push_back(std::move(*subject));
        return {};
    };
    StateOptions state = options.state;
    if (ownSource)
        if (const auto added = add(state, true); !added)
            return tl::unexpected(added.error());
    for (const std::string& source : options.more) {
        state.source = source;
        if (const auto added = add(state, true); !added)
            return tl::unexpected(added.error());
    }
    for (const HardCaseRow& row : std::span(kHardCases).first(options.hardCases ? kHardCases.size() : 0)) {
        state.source = "hard:" + std::string(row.key) + '@' + std::to_string(options.size > 0 ? options.size : kHardCaseSize);
        if (const auto added = add(state, row.pictured); !added)
            return tl::unexpected(added.error());
        subjects.back().field.key = row.key;
    }
    return subjects;
}

struct GpuRun {
    Renderer& renderer;
    const ReportOptions& options;
    Report& report;
    Progress progress;
};

// One field at one angle: times of all settings in one interleaved run, then their pictures.
Expected<void> measureAngle(GpuRun& run, const Subject& subject, Resources& resources, std::size_t field, std::size_t angle)
{
    const auto& [renderer, options, report, progress] = run;
    const State view = fillingView(subject.state, report.angles[angle]);
    std::vector<TimedFrame> frames = {plainQuad(view)};
    for (const SearchSetting& setting : report.plan.settings)
        frames.push_back({withSetting(view, setting), timedView(resources)});
    const auto times = frameTimes(renderer, resources, frames, report.pictureWidth, report.pictureHeight, {options.fast ? 3 : 5, kEnough},
        Progress{{}, progress.stop});
    if (!times)
        return tl::unexpected(times.error());
    auto judge = PictureJudge::create(renderer, view, resources, report.pictureWidth, report.pictureHeight);
    if (!judge)
        return tl::unexpected(judge.error());
    for (std::size_t i = 0; i < report.plan.settings.size(); ++i) {
        const auto verdict = judge->judge(report.plan.settings[i]);
        if (!verdict)
            return tl::unexpected(verdict.error());
        const double ms = (*times)[i + 1];
        report.pictures.push_back({i, field, angle, ms, ms / std::max((*times)[0], 1e-6), verdict->psnr, verdict->flip});
    }
    return {};
}

// Without a context the report goes without pictures, and says so.
Expected<void> measurePictures(const ReportOptions& options, const std::vector<Subject>& subjects, Report& report, const Progress& progress)
{
    const auto context = WindowlessContext::create();
    if (!context) {
        report.warnings.push_back({"no-pictures", "There are no times and pictures: " + message(context.error())});
        return {};
    }
    Renderer renderer;
    report.renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    report.angles.assign(kPictureAngles.begin(), kPictureAngles.end());
    report.exactLabel = mostExactSetting(report.plan.settings.front().parameters).label;
    report.pictureWidth = options.fast ? 320 : 800;
    report.pictureHeight = options.fast ? 240 : 600;
    if (!options.state.mesh.empty()) {
        Resources resources = subjects.front().resources;
        auto mesh = measureOnMesh(renderer, subjects.front().state, resources, report.pictureWidth, report.pictureHeight, true,
            report.warnings, progress.part(0.f, 0.2f));
        if (!mesh)
            return tl::unexpected(mesh.error());
        report.mesh = std::move(*mesh);
    }
    const auto pictured = std::ranges::find_if(subjects, [](const Subject& subject) { return subject.resources.mesh != nullptr; });
    if (options.farViews && pictured != subjects.end()) {
        auto far = measureFarViews(renderer, pictured->state, pictured->resources, progress.part(0.2f, 0.3f));
        if (!far)
            return tl::unexpected(far.error());
        report.far = std::move(*far);
    }
    GpuRun run{renderer, options, report, progress.part(0.3f, 1.f)};
    const std::size_t steps = subjects.size() * report.angles.size();
    for (std::size_t field = 0; field < subjects.size(); ++field) {
        Resources resources = subjects[field].resources.mesh ? fillingResources(subjects[field].resources) : Resources();
        for (std::size_t angle = 0; angle < report.angles.size(); ++angle) {
            if (subjects[field].resources.mesh) // of the hard cases only some are pictured
                if (const auto measured = measureAngle(run, subjects[field], resources, field, angle); !measured)
                    return measured;
            run.progress.at(float(field * report.angles.size() + angle + 1) / float(steps));
        }
    }
    return {};
}

Expected<void> addHeats(
    const std::vector<const TechniqueRow*>& techniques, const Subject& subject, bool fast, Report& report, const Progress& progress)
{
    const Parameters parameters = effectiveParameters(subject.state, 0);
    report.heatField = subject.field.label;
    report.heatView.depth = subject.field.depth;
    report.heatView.fetchRange = double(parameters.fetchRange), report.heatView.errorRange = double(parameters.errorRange);
    if (fast)
        report.heatView.width = 200, report.heatView.height = 125;
    float done = 0.f;
    for (const TechniqueRow* technique : techniques) {
        progress.at(done++ / float(techniques.size()));
        if (!technique->needsHeights())
            continue; // nothing is searched
        const SearchSetting setting = plainSetting(*technique, parameters);
        const auto heats = heatPictures(setting, subject.field.heights, report.heatView, Progress{{}, progress.stop});
        if (!heats)
            return tl::unexpected(heats.error());
        auto fetches = encodePng(heats->fetches, true);
        auto error = encodePng(heats->error, true);
        if (!fetches || !error)
            return tl::unexpected(fetches ? error.error() : fetches.error());
        report.heats.push_back({setting.label, std::move(*fetches), std::move(*error), heats->meanFetches, heats->meanError});
    }
    return {};
}

// The engines that are named, or all when no technique is, on every field.
Expected<void> addEngines(const ReportOptions& options, const std::vector<Subject>& subjects, Report& report, const Progress& progress)
{
    for (std::size_t field = 0; field < subjects.size(); ++field) {
        Parameters parameters = effectiveParameters(subjects[field].state, 0);
        parameters.depth = float(subjects[field].field.depth);
        for (const TechniqueRow& technique : kTechniques)
            if (technique.isEngine() && (options.techniques.empty() || std::ranges::count(options.techniques, technique.key) > 0))
                for (const double angle : kEngineAngles) {
                    const auto drawing = drawnBy(technique, parameters, subjects[field].field.heights, angle, Progress{{}, progress.stop});
                    if (!drawing)
                        return tl::unexpected(drawing.error());
                    report.engines.push_back({&technique, field, angle, *drawing});
                }
        progress.at(float(field + 1) / float(subjects.size()));
    }
    return {};
}

// The field that the heat maps show: of the hard cases the one that looks like something.
const Subject& shownSubject(const std::vector<Subject>& subjects)
{
    const auto bricks = std::ranges::find(subjects, "bricks", [](const Subject& s) { return s.field.key; });
    return bricks == subjects.end() ? subjects.front() : *bricks;
}

std::string titleOf(const ReportOptions& options, const std::vector<Subject>& subjects)
{
    const std::size_t sets = subjects.size() - (options.hardCases ? kHardCases.size() : 0);
    const std::string first = sets == 0 ? "" : sets == 1 ? shownName(subjects.front().state.name) : std::to_string(sets) + " materials";
    return !options.hardCases ? first : first.empty() ? "Hard cases" : first + " and hard cases";
}

Result<Report> measure(const ReportOptions& options)
{
    if (const auto good = check(options); !good)
        return tl::unexpected(good.error());
    const auto techniques = techniquesOf(options.techniques);
    const auto bands = bandsOf(options.angles);
    if (!techniques || !bands)
        return tl::unexpected(techniques ? bands.error() : techniques.error());
    const Progress progress = shownProgress(options.common);
    const auto subjects = subjectsOf(options, progress.part(0.f, 0.1f));
    if (!subjects)
        return tl::unexpected(subjects.error());

    Report report;
    report.title = titleOf(options, *subjects);
    report.plan.bands = *bands;
    report.plan.rays = options.rays;
    report.plan.seed = options.seed;
    report.plan.freshMaps = true;
    for (const TechniqueRow* technique : *techniques)
        for (SearchSetting& setting : settingsOf(*technique, effectiveParameters(subjects->front().state, 0), kReportSteps))
            report.plan.settings.push_back(std::move(setting));
    for (const Subject& subject : *subjects) {
        report.plan.fields.push_back(subject.field);
        report.warnings.insert(report.warnings.end(), subject.warnings.begin(), subject.warnings.end());
    }
    auto rows = sweep(report.plan, progress.part(0.1f, options.noPictures ? 0.85f : 0.35f));
    if (!rows)
        return problem(rows.error());
    report.rows = std::move(*rows);
    if (const auto done
        = addEngines(options, *subjects, report, progress.part(options.noPictures ? 0.85f : 0.35f, options.noPictures ? 0.9f : 0.4f));
        !done)
        return problem(done.error());
    if (!options.noPictures)
        if (const auto done = measurePictures(options, *subjects, report, progress.part(0.4f, 0.9f)); !done)
            return problem(done.error());
    if (lowerSuffix(options.out) == ".html")
        if (const auto done = addHeats(*techniques, shownSubject(*subjects), options.fast, report, progress.part(0.9f, 1.f)); !done)
            return problem(done.error());
    progress.at(1.f);
    return report;
}

Result<Report> measureAndWrite(const ReportOptions& options)
{
    auto report = measure(options);
    if (!report)
        return report;
    const std::string suffix = lowerSuffix(options.out);
    const std::string text = suffix == ".html" ? reportHtml(*report) : suffix == ".json" ? reportJson(*report) : reportCsv(*report);
    if (const auto written = writeAtomically(options.out, text); !written)
        return problem(written.error());
    return report;
}

} // namespace

void addReport(CLI::App& app, int& exitCode)
{
    auto options = std::make_shared<ReportOptions>();
    CLI::App* command = app.add_subcommand("report",
        "Speed against error of the techniques: tables, plots, heat maps; with --mesh also relief on it against the displaced mesh");
    options->state.addTo(*command);
    options->common.addTo(*command);
    command->add_flag("--hard-cases", options->hardCases,
        "Measure on the built-in hard height fields, alone or beside SOURCEs; pictures of four of them");
    command->add_option("MORE", options->more, "Further SOURCEs, measured together with the first")->type_name("");
    options->state.addOutput(*command, "-o", options->out, "Report to write: .html, .json or .csv")->required()->type_name("OUT");
    command
        ->add_option("--techniques", options->techniques, "Only these techniques; when not given all, and engines in a table of their own")
        ->type_name("KEY,KEY...")
        ->delimiter(',');
    command
        ->add_option(
            "--angles", options->angles, "Bands of angles between view and normal, degrees; 0-60,60-80,80-88,88-89.9 when not given")
        ->type_name("FROM-TO,...")
        ->delimiter(',');
    command->add_option("--rays", options->rays, "Rays a field and band; 5000 when not given")
        ->check(CLI::Range(1, 1000000))
        ->type_name("N");
    command->add_option("--size", options->size, "Texels a side of the hard cases; 256 when not given")
        ->check(CLI::Range(2, 4096))
        ->type_name("N");
    command->add_option("--seed", options->seed, "Seed of the rays; 1 when not given")->type_name("N");
    command->add_flag("--fast", options->fast, "Smaller pictures and fewer timed frames");
    command->add_flag("--far-views", options->farViews,
        "Also far views: how far their light is off with each setting of the filters, against supersampled pictures of the first SOURCE");
    command->add_flag("--no-pictures", options->noPictures, "Searches on the CPU only: no times of frames, no PSNR and FLIP");
    command->callback([options, &exitCode] {
        conclude(measureAndWrite(*options), options->common, exitCode, [&](const auto& report) {
            return nlohmann::ordered_json{{"file", options->out}, {"settings", report.plan.settings.size()},
                {"fields", report.plan.fields.size()}, {"rays", report.rows.size()}, {"pictures", report.pictures.size()},
                {"warnings", warningsJson(report.warnings)}};
        });
    });
}

} // namespace relievo::cli
