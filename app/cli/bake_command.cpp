// relievo bake: one row of the maps table, computed from the height map.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "core/image/image_file.h"
#include "core/maps/maps.h"
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

namespace relievo::cli {

namespace {

struct BakeOptions {
    Common common;
    StateOptions state;
    std::string out, map;
    int bits = 16;
};

Result<Scene> bake(const BakeOptions& options)
{
    const MapRow* row = findMap(options.map);
    if (!row)
        return problem({"there is no such map", "--map " + options.map, "relievo describe maps lists them"}, WrongUsage);
    const Progress progress = shownProgress(options.common);
    auto opened = openState(options.state, progress);
    if (!opened)
        return tl::unexpected(opened.error());
    auto material = loadMaterial(opened->state.slots, opened->images, nullptr, progress);
    if (!material)
        return problem(material.error());
    if (!material->height)
        return problem({"the material has no height map to bake from", options.state.source, "Add one by --height FILE"});
    const Parameters parameters = effectiveParameters(opened->state, 0);
    const auto map = bakeMap(*row, material->height->withWrap(parameters.wrap == 1 ? Wrap::Clamp : Wrap::Repeat), parameters, progress);
    if (!map)
        return problem(map.error());
    if (const auto written = writeImage(options.out, storedMap(*row, *map, options.bits).levels.front()); !written)
        return problem(written.error());
    Scene scene{opened->state, {}, opened->warnings};
    scene.warnings.insert(scene.warnings.end(), material->warnings.begin(), material->warnings.end());
    return scene;
}

} // namespace

void addBake(CLI::App& app, int& exitCode)
{
    auto options = std::make_shared<BakeOptions>();
    CLI::App* command = app.add_subcommand("bake", "Computes a map from the height map");
    options->state.addTo(*command);
    options->common.addTo(*command);
    command->add_option("--map", options->map, "What to bake, see relievo describe maps")->required()->type_name("KEY");
    command->add_option("-o", options->out, "Image to write; the suffix names the format")->required()->type_name("OUT");
    command->add_option("--bits", options->bits, "Bits a channel: 8, 16 or 32 (float); 16 when not given")
        ->check(CLI::IsMember({8, 16, 32}))
        ->type_name("8|16|32");
    command->callback([options, &exitCode] {
        const auto baked = bake(*options);
        if (!baked) {
            exitCode = tell(baked.error());
            return;
        }
        tell(baked->warnings, options->common);
        if (options->common.json)
            print(nlohmann::ordered_json{{"file", options->out}, {"map", options->map}, {"warnings", warningsJson(baked->warnings)}});
    });
}

} // namespace relievo::cli
