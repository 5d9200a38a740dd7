// relievo inspect: the steps of a technique's search along one ray.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "app/cli/rays_csv.h"
#include "core/analysis/ray_inspection.h"
#include "core/ground/shown_text.h"
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

namespace relievo::cli {

namespace {
using Json = nlohmann::ordered_json;

struct InspectOptions {
    Common common;
    StateOptions state;
    std::string ray;
    bool light = false;
};

// "u,v,du,dv"
Result<SearchRay> rayOf(const std::string& text, double depth)
{
    double values[4];
    const char* at = text.c_str();
    for (int i = 0; i < 4; ++i) {
        char* end = nullptr;
        values[i] = std::strtod(at, &end);
        if (end == at || *end != (i < 3 ? ',' : '\0') || !std::isfinite(values[i]))
            return problem(
                {"this is no ray", "--ray " + shownText(text), "Write four finite numbers u,v,du,dv: 0.5,0.5,0.1,0"}, WrongUsage);
        at = end + 1;
    }
    SearchRay ray{{values[0], values[1]}, {values[2], values[3]}};
    ray.cosView = cosineOf(ray, depth);
    return ray;
}

void show(const RayInspection& inspection)
{
    std::printf("%s: %s at %.6g of the depth, %d fetches; exact: %.6g\n%s\n", inspection.technique.c_str(),
        inspection.hit.found ? "hit" : "no hit", inspection.hit.t, inspection.hit.fetches, inspection.exact, inspection.verdict.c_str());
    std::printf("%4s  %-8s %10s %10s %12s %12s %8s %8s\n", "", "step", "from", "to", "u", "v", "height", "fetches");
    for (std::size_t i = 0; i < inspection.steps.size(); ++i) {
        const SearchStep& step = inspection.steps[i];
        std::printf("%4zu  %-8s %10.6f %10.6f %12.6f %12.6f %8.5f %8d\n", i + 1, std::string(wordOf(step.kind)).c_str(), step.from, step.to,
            step.uv.x, step.uv.y, step.height, step.fetches);
    }
}

Result<void> inspect(const InspectOptions& options)
{
    const Progress progress = shownProgress(options.common);
    const auto input = openHeights(options.state, progress.part(0.f, 0.4f));
    if (!input)
        return tl::unexpected(input.error());
    const auto ray = rayOf(options.ray, double(input->parameters.depth));
    if (!ray)
        return tl::unexpected(ray.error());
    const auto maps = searchMaps(input->technique, input->parameters, input->field ? &*input->field : nullptr, progress.part(0.4f, 1.f));
    if (!maps)
        return problem(maps.error());
    const auto view = inspectRay(input->technique, input->parameters, *maps, *ray);
    if (!view)
        return problem(view.error());
    std::optional<RayInspection> light;
    if (const auto way = options.light ? lightRayTo(*view, input->parameters) : std::nullopt) {
        auto inspected = inspectRay(input->technique, input->parameters, *maps, *way);
        if (!inspected)
            return problem(inspected.error());
        light = std::move(*inspected);
    }
    progress.at(1.f);
    tell(input->warnings, options.common);
    if (options.common.json) {
        Json json = Json::parse(inspectionJson(*view));
        if (options.light)
            json["light"] = light ? Json::parse(inspectionJson(*light)) : Json();
        print(json);
        return {};
    }
    show(*view);
    if (light) {
        std::printf("\nThe light on its way there:\n");
        show(*light);
    } else if (options.light) {
        std::printf("\nNo ray of light comes there through the relief.\n");
    }
    return {};
}
} // namespace

void addInspect(CLI::App& app, int& exitCode)
{
    auto options = std::make_shared<InspectOptions>();
    CLI::App* command = app.add_subcommand("inspect", "Tells every step of a technique's search along one ray");
    options->state.addTo(*command);
    options->common.addTo(*command);
    command->add_option("--ray", options->ray, "u,v,du,dv: where the ray enters, and how far uv moves over the full depth")
        ->required()
        ->type_name("U,V,DU,DV");
    command->add_flag("--light", options->light, "The ray of light to the point that was found, too");
    command->callback([options, &exitCode] {
        if (const auto done = inspect(*options); !done)
            exitCode = tell(done.error());
    });
}

} // namespace relievo::cli
