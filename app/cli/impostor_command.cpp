// relievo impostor: a mesh as a relief object, whose maps stand for it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "core/exporters/object_files.h"
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

namespace relievo::cli {

namespace {

struct ImpostorOptions {
    Common common;
    std::string mesh, out;
    ObjectOptions object;
    int sides = int(ObjectSides::Six);
};

Result<Exported> impostor(const ImpostorOptions& options)
{
    const Progress progress = shownProgress(options.common);
    auto mesh = openMesh(options.mesh, progress.part(0.f, 0.15f));
    if (!mesh)
        return problem(mesh.error());
    const auto surface = MeshSurface::load(*mesh, progress.part(0.15f, 0.2f));
    if (!surface)
        return problem(surface.error());
    ObjectJob job{&*surface, options.object, options.out, options.mesh, progress.part(0.2f, 1.f)};
    job.options.sides = ObjectSides(options.sides);
    auto written = writeObject(job);
    if (!written)
        return problem(written.error());
    Warnings& warnings = written->warnings;
    warnings.insert(warnings.begin(), surface->warnings().begin(), surface->warnings().end());
    warnings.insert(warnings.begin(), mesh->warnings.begin(), mesh->warnings.end());
    return std::move(*written);
}

nlohmann::ordered_json toJson(const ImpostorOptions& options, const Exported& written)
{
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const std::filesystem::path& file : written.files)
        files.push_back(file.string());
    return {{"mesh", options.mesh}, {"object", written.files.back().string()}, {"project", written.files.end()[-2].string()},
        {"sides", options.sides}, {"layers", options.object.layers}, {"size", options.object.size}, {"files", files},
        {"warnings", warningsJson(written.warnings)}};
}

} // namespace

void addImpostor(CLI::App& app, int& exitCode)
{
    auto options = std::make_shared<ImpostorOptions>();
    CLI::App* command = app.add_subcommand("impostor", "Bakes a mesh to the maps of a box that stands for it");
    command->footer("Depth, colour, normal and roughness of each side, 16 bits a channel, and NAME.object.json, which names them and the "
                    "box in metres. The object is where all axes agree.");
    command->add_option("MESH", options->mesh, "Mesh file, or a built-in shape")->required();
    options->common.addTo(*command);
    command->add_option("-o", options->out, "Folder to write to; it is made where it is missing")->required()->type_name("FOLDER");
    command
        ->add_option(
            "--sides", options->sides, "1: the front (+z), solid back to the box's end; 2: front and back; 6: all. 6 when not given")
        ->check(CLI::IsMember({1, 2, 6}))
        ->type_name("1|2|6");
    command
        ->add_option(
            "--layers", options->object.layers, "Solid stretches along each axis; 1 when not given. More hold what lies behind other parts")
        ->check(CLI::IsMember({1, 2, 4}))
        ->type_name("1|2|4");
    command->add_option("--size", options->object.size, "Texels along each side of a map, 1 to 8192; 512 when not given")
        ->check(CLI::Range(1, kLargestObjectMap))
        ->type_name("N");
    command
        ->add_option("--supersample", options->object.supersample,
            "Rays along each side of a texel, 1 to 8, 2 when not given: smoother colours, and thin parts are kept")
        ->check(CLI::Range(1, kMostRays))
        ->type_name("S");
    command->callback([options, &exitCode] {
        conclude(impostor(*options), options->common, exitCode, [&](const Exported& written) { return toJson(*options, written); });
    });
}

} // namespace relievo::cli
