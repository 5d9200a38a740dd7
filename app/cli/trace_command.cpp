// relievo trace: a technique's search on given rays.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "app/cli/rays_csv.h"
#include "core/ground/file.h"
#include "core/shader_text/program_text.h"
#include "core/shader_text/shader_files.h"
#include "core/state/techniques.h"
#include "core/trace/shader_on_cpu.h"
#include "render/windowless.h"
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

namespace relievo::cli {

namespace {

struct TraceOptions {
    Common common;
    StateOptions state;
    std::string rays, out, device = "cpu";
};

// The CPU runs the text that was compiled in; a changed folder would silently not count.
void warnOfOtherTexts(Warnings& warnings)
{
    const char* folder = std::getenv("RELIEVO_SHADERS");
    if (!folder || !*folder)
        return;
    const ShaderReader read = folderReader(folder);
    for (const ShaderFile& file : embeddedShaders())
        if (const auto text = read(file.name); text && *text != file.text) {
            warnings.push_back({"shaders-differ",
                std::string(file.name)
                    + " in RELIEVO_SHADERS differs from the text that --device cpu runs; rebuild Relievo or use --device gl"});
            return;
        }
}

Expected<std::vector<SearchHit>> run(const TraceOptions& options, std::string_view technique, const Parameters& parameters,
    const HeightField* field, std::span<const SearchRay> rays, const Progress& progress)
{
    if (options.device == "cpu")
        return traceRays(technique, parameters, field, rays, progress);
    const auto context = WindowlessContext::create();
    if (!context)
        return tl::unexpected(context.error());
    return traceRaysOnGpu(technique, parameters, field, rays);
}

struct Traced {
    Warnings warnings;
    std::size_t rays = 0, found = 0, unfinished = 0;
    double fetches = 0;
};

Result<Traced> trace(const TraceOptions& options)
{
    const Progress progress = shownProgress(options.common);
    const auto heights = openHeights(options.state, progress.part(0.f, 0.4f));
    if (!heights)
        return tl::unexpected(heights.error());
    const Parameters& parameters = heights->parameters;
    Traced traced{heights->warnings};
    const auto rays = readRays(options.rays, parameters.depth);
    if (!rays)
        return problem(rays.error());
    traced.warnings.insert(traced.warnings.end(), rays->warnings.begin(), rays->warnings.end());
    const bool isExact = heights->technique == "reference"; // in double precision
    const auto odd
        = std::ranges::count_if(rays->rays, [&](const SearchRay& ray) { return isExact ? !isFinite(ray) : !isFiniteInFloat(ray); });
    if (odd > 0)
        traced.warnings.push_back({"rays-not-finite",
            options.rays + ": " + std::to_string(odd) + " of " + std::to_string(rays->rays.size())
                + " rays are not finite, and their answer is 0,1,0,0,0. Mend what wrote them."});
    if (options.device == "cpu")
        warnOfOtherTexts(traced.warnings);
    const auto hits
        = run(options, heights->technique, parameters, heights->field ? &*heights->field : nullptr, rays->rays, progress.part(0.4f, 1.f));
    if (!hits)
        return problem(hits.error());
    if (const auto written = writeAtomically(options.out, hitsText(*hits)); !written)
        return problem(written.error());
    progress.at(1.f);
    traced.rays = hits->size();
    for (const SearchHit& hit : *hits)
        traced.found += hit.found, traced.unfinished += hit.isUnfinished, traced.fetches += hit.fetches;
    if (traced.unfinished > 0)
        traced.warnings.push_back({"rays-unfinished",
            options.rays + ": " + std::to_string(traced.unfinished) + " of " + std::to_string(traced.rays)
                + " rays were not finished (hit is -1): they cross more texels than the search may visit. Shorten (du, dv), or use a "
                  "smaller map."});
    return traced;
}

} // namespace

void addTrace(CLI::App& app, int& exitCode)
{
    auto options = std::make_shared<TraceOptions>();
    CLI::App* command = app.add_subcommand("trace", "Runs a technique's search on given rays");
    options->state.addTo(*command);
    options->common.addTo(*command);
    options->state
        .addInput(*command, "--rays", options->rays,
            "CSV with the header u,v,du,dv and optionally ,cosView; (du, dv) is the shift of uv over the full depth")
        ->required()
        ->type_name("IN.csv");
    options->state.addOutput(*command, "-o", options->out, "CSV to write: hit,t,u,v,fetches")->required()->type_name("HITS.csv");
    command->add_option("--device", options->device, "Where the search runs")->check(CLI::IsMember({"cpu", "gl"}))->type_name("cpu|gl");
    command->callback([options, &exitCode] {
        conclude(trace(*options), options->common, exitCode, [&](const auto& traced) {
            return nlohmann::ordered_json{{"file", options->out}, {"rays", traced.rays}, {"found", traced.found},
                {"unfinished", traced.unfinished}, {"meanFetches", traced.rays ? traced.fetches / double(traced.rays) : 0.},
                {"warnings", warningsJson(traced.warnings)}};
        });
    });
}

} // namespace relievo::cli
