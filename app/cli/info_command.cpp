// relievo info: what was found in a texture set, a project or a mesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "core/ground/file.h"
#include "core/ground/shown_text.h"
#include "core/scene/materials/material_file.h"
#include "core/scene/relief_numbers.h"
#include "core/state/shapes.h"
#include "core/trace/relief_room.h"
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace relievo::cli {
using Json = nlohmann::ordered_json;

namespace {

struct InfoOptions {
    Common common;
    StateOptions state; // SOURCE and the maps given by hand
};

TextureSet setOf(const Opened& opened, const std::filesystem::path& folder)
{
    TextureSet set = textureSetOf(opened.state.name, opened.state.slots, folder);
    set.warnings.insert(set.warnings.begin(), opened.warnings.begin(), opened.warnings.end());
    return set;
}

// A relief that fills the heights' range, as deep as the default says.
std::optional<Warning> tooDeepAsUsual(const Mesh& mesh)
{
    const Parameters usual;
    const float fits = fittingDepth(usual, mesh.metresPerUV, {reliefRoom(mesh), 0.f, {}, {}});
    if (usual.depth <= fits)
        return {};
    char text[160];
    std::snprintf(text, sizeof text,
        "A relief of the usual depth, %.2g, is deeper than the mesh is thick in places: up to a depth of %.2g it fits.",
        double(usual.depth), double(fits));
    return Warning{"relief-too-deep", text};
}

// One JSON object for all kinds of source; the text for people is made from it.
Result<Json> infoOf(const InfoOptions& options)
{
    const Progress progress = shownProgress(options.common);
    const std::string& source = options.state.source;
    if (options.state.givesMaps()) {
        const auto opened = openState(options.state, progress);
        if (!opened)
            return tl::unexpected(opened.error());
        std::error_code code;
        const bool isFolder = source.empty() || std::filesystem::is_directory(source, code);
        const std::filesystem::path folder = absolutePath(source.empty() ? "." : source);
        return Json::parse(textureSetJson(setOf(*opened, isFolder ? folder : folder.parent_path())));
    }
    if (isMeshFile(source) || std::ranges::count(kShapes, source)) {
        auto mesh = openMesh(source, progress);
        if (!mesh)
            return problem(mesh.error());
        const Warnings faults = inspectMesh(*mesh);
        mesh->warnings.insert(mesh->warnings.end(), faults.begin(), faults.end());
        if (auto warning = tooDeepAsUsual(*mesh))
            mesh->warnings.push_back(std::move(*warning));
        return Json::parse(meshJson(*mesh));
    }
    if (isProjectFile(source) || isBuiltInSource(source) || isMaterialFile(source)) {
        const auto opened = openSource(source, State(), progress);
        if (!opened)
            return problem(opened.error());
        return Json::parse(textureSetJson(setOf(*opened, absolutePath(source).parent_path())));
    }
    auto set = openTextureSet(source, progress);
    if (!set)
        return problem(set.error());
    if (std::optional<Warning> unfinished = unfinishedExport(source))
        set->warnings.push_back(std::move(*unfinished));
    State state; // would be given these numbers
    state.slots = set->slots();
    if (const auto heights = set->images.find(state.slots[std::size_t(MapKind::Height)].file); heights != set->images.end())
        takeHeightNumbers(state, heights->second->image, set->warnings);
    return Json::parse(textureSetJson(*set));
}

const std::string& textOf(const Json& value)
{
    return value.get_ref<const std::string&>();
}

std::string text(const Json& info)
{
    std::string out = shownName(textOf(info["name"])) + '\n';
    if (info.contains("maps"))
        for (const Json& map : info["maps"]) {
            char range[64];
            std::snprintf(range, sizeof range, "%.4g to %.4g", map["min"].get<double>(), map["max"].get<double>());
            out += "  " + map["kind"].get<std::string>() + ": " + shownText(textOf(map["file"])) + " [" + map["channel"].get<std::string>()
                + "], " + map["width"].dump() + " x " + map["height"].dump() + ", " + map["bits"].dump() + " bit, "
                + map["convention"].get<std::string>() + ", values " + range + '\n';
        }
    if (info.contains("vertices")) {
        out += "  " + info["vertices"].dump() + " vertices, " + info["triangles"].dump() + " triangles, "
            + std::to_string(info["parts"].size()) + " parts\n";
        for (const char* key : {"uvs", "normals", "tangents"})
            out += std::string("  ") + key + ": " + (info[key].get<bool>() ? "in the file" : "made") + '\n';
        if (info.contains("materials"))
            for (const Json& material : info["materials"]) {
                out += "  material " + shownName(textOf(material["name"])) + ':';
                for (const auto& [kind, file] : material["maps"].items())
                    out += ' ' + kind + ' ' + shownText(textOf(file));
                out += material["maps"].empty() ? " no maps\n" : "\n";
            }
        for (const Json& clip : info.value("clips", Json::array()))
            out += "  clip " + shownName(textOf(clip["name"])) + ": " + clip["seconds"].dump() + " s\n";
        out += "  bounds (m): " + info["bounds"][0].dump() + " to " + info["bounds"][1].dump() + '\n';
    }
    for (const Json& warning : info["warnings"])
        out += "  warning: " + shownText(textOf(warning["text"])) + '\n';
    return out;
}

} // namespace

void addInfo(CLI::App& app, int& exitCode)
{
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command = app.add_subcommand("info", "What is in a texture set, project or mesh");
    const CLI::Option* source = command->add_option("SOURCE", options->state.source, "Texture set, image, project, or mesh");
    options->state.addMapsTo(*command);
    options->common.addTo(*command);
    command->callback([options, source, &exitCode] {
        const bool given = source->count() > 0 || options->state.givesMaps();
        const Result<Json> info = given
            ? infoOf(*options)
            : Result<Json>(problem({"there is nothing to tell of", "SOURCE", "Name a folder, an image, a project or a mesh"}, WrongUsage));
        if (!info)
            exitCode = tell(info.error());
        else if (options->common.json)
            print(*info);
        else
            std::fputs(text(*info).c_str(), stdout);
    });
}

} // namespace relievo::cli
