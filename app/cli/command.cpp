// Options of the State, and telling results.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "core/gltf/pictures.h"
#include "core/ground/file.h"
#include "core/ground/shown_text.h"
#include "core/image/files/image_file.h"
#include "core/mesh/animation/pose.h"
#include "core/scene/inputs.h"
#include "core/scene/relief_numbers.h"
#include "core/state/environments.h"
#include "core/state/presets.h"
#include "core/state/shapes.h"
#include "core/state/state_json.h"
#include "core/state/techniques.h"
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <unistd.h>
#include <utility>

namespace relievo::cli {
namespace fs = std::filesystem;

void Common::addTo(CLI::App& command)
{
    command.add_flag("--json", json, "Print the result as one JSON object");
    command.add_flag("--quiet", quiet, "No progress and no warnings");
    command.add_flag("--progress", progress, "Progress on stderr, also when it is no terminal");
}

namespace {
// "FILE|plane|sphere ...".
std::string shapeNames()
{
    std::string names = "FILE";
    for (const std::string_view shape : kShapes)
        names += '|' + std::string(shape);
    return names;
}
std::string environmentNames()
{
    std::string names = "FILE";
    for (const EnvironmentRow& row : kEnvironments)
        names += '|' + std::string(row.key);
    return names;
}
} // namespace

void StateOptions::addTo(CLI::App& command, std::vector<std::string>* sources)
{
    const char* const help = "Project (*.relievo), folder of a texture set, one image of a set, sample:NAME or hard:NAME";
    (sources ? command.add_option("SOURCE", *sources, help) : command.add_option("SOURCE", source, help))->type_name("");
    command.add_option("--preset", preset, "Preset by name or file")->type_name("NAME|FILE");
    command.add_option("--technique", technique, "Search technique, see relievo describe techniques")->type_name("KEY");
    command.add_option("--set", set, "Parameter, repeatable, see relievo describe parameters")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_option("--mesh", mesh, "Mesh file or shape")->type_name(shapeNames());
    command.add_option("--environment", environment, "What lights the scene from around: a panorama (hdr, exr) or a built-in environment")
        ->type_name(environmentNames());
    command.add_option("--camera", camera, "yaw=DEG,pitch=DEG,distance=M,target=X:Y:Z (M),fov=DEG,fill=SHARE, any of them")
        ->type_name("SETTINGS");
    addMapsTo(command);
}

void StateOptions::addMapsTo(CLI::App& command)
{
    CLI::Option* deep = command.add_option("--depth-map", depthMap, "Height map where white is deep")->type_name("FILE");
    for (const MapKindRow& row : kMapKinds) {
        CLI::Option* map = command.add_option("--" + std::string(row.key), maps[std::string(row.key)], std::string(row.label) + " map");
        map->type_name("FILE");
        if (row.kind == MapKind::Height)
            deep->excludes(map);
    }
}

CLI::Option* StateOptions::addOutput(CLI::App& command, const std::string& name, std::string& file, const std::string& help)
{
    outputs.push_back(&file);
    return command.add_option(name, file, help);
}

CLI::Option* StateOptions::addInput(CLI::App& command, const std::string& name, std::string& file, const std::string& help)
{
    inputs.push_back(&file);
    return command.add_option(name, file, help);
}

std::vector<fs::path> StateOptions::filesRead() const
{
    std::vector<fs::path> files = {fileOfPicture(source), fs::path(source) / "relief.json", preset};
    for (const std::string* input : inputs)
        files.emplace_back(*input);
    return files;
}

bool StateOptions::givesMaps() const
{
    return !depthMap.empty() || std::ranges::any_of(maps, [](const auto& map) { return !map.second.empty(); });
}

bool StateOptions::changesState() const
{
    return givesMaps() || !set.empty() || !(preset + technique + mesh + environment + camera).empty();
}

namespace {

// The maps given by hand. A file that is not there or cannot be read is the user's slip, not a map gone missing.
Expected<void> setMaps(const StateOptions& options, Opened& opened)
{
    MapSlots& slots = opened.state.slots;
    const auto assign = [&](MapKind kind, const std::string& file, bool depth) -> Expected<void> {
        if (!pictureMayExist(fileAndChannel(file).first))
            return failure(ErrorCode::NotFound, file, "there is no such file", "Check the path of --" + std::string(row(kind).key));
        MapSlot& slot = slots[std::size_t(kind)] = slotByHand(kind, file, opened.images, opened.warnings);
        auto& image = opened.images[slot.file];
        if (!image) {
            auto read = readImage(slot.file);
            if (!read)
                return tl::unexpected(read.error());
            image = std::make_shared<const ImageRead>(std::move(*read));
        }
        if (kind == MapKind::Height) { // the option says which it is, not the name
            slot.invert = depth;
            takeHeightNumbers(opened.state, image->image, opened.warnings);
        }
        return {};
    };
    for (const auto& [key, file] : options.maps)
        if (!file.empty())
            if (auto done = assign(*findMapKind(key), file, false); !done)
                return done;
    if (!options.depthMap.empty())
        return assign(MapKind::Height, options.depthMap, true);
    return {};
}

Result<void> checkFile(const std::string& file, const std::string& option)
{
    std::error_code code;
    if (!fs::exists(file, code))
        return problem({"there is no such file", file, "Check the path of " + option, ErrorCode::NotFound});
    return {};
}

Result<void> applyOptions(const StateOptions& options, Opened& opened)
{
    State& state = opened.state;
    if (!options.preset.empty()) {
        auto read = readPreset(state, options.preset);
        if (!read)
            return problem(read.error());
        state = std::move(read->state);
        opened.warnings.insert(opened.warnings.end(), read->warnings.begin(), read->warnings.end());
    }
    if (!options.technique.empty()) {
        if (!findTechnique(options.technique))
            return problem(
                {"there is no such technique", "--technique " + options.technique, "relievo describe techniques lists them"}, WrongUsage);
        state.panes.front().technique = options.technique;
    }
    for (const std::string& assignment : options.set)
        if (const auto done = setParameter(state, assignment); !done)
            return problem(done.error(), WrongUsage);
    const bool isShape = isBuiltInMesh(options.mesh), isBuiltIn = isBuiltInEnvironment(options.environment);
    if (!options.mesh.empty()) {
        if (const auto there = isShape ? Result<void>() : checkFile(options.mesh, "--mesh"); !there)
            return there;
        state.mesh = isShape ? options.mesh : absolutePath(options.mesh).string();
        state.part.clear();
    }
    const TechniqueRow* named = findTechnique(options.technique);
    if (named && named->isOfObjects != isObjectName(state.mesh))
        return problem(
            {named->isOfObjects ? "this technique draws relief objects, and the mesh is none"
                                : "this technique cannot draw a relief object",
                "--technique " + options.technique, "relievo describe techniques lists those of relief objects in a group of their own"},
            WrongUsage);
    fitTechniques(state);
    if (!options.environment.empty()) {
        if (const auto there = isBuiltIn ? Result<void>() : checkFile(options.environment, "--environment"); !there)
            return there;
        state.environment = isBuiltIn ? options.environment : absolutePath(options.environment).string();
    }
    Camera camera = cameraOf(state, 0); // of the pane that is drawn
    if (const auto done = setCamera(camera, options.camera); !done)
        return problem(done.error(), WrongUsage);
    setCameraOf(state, 0, camera);
    return {};
}

} // namespace

namespace {
// What is read is not replaced, and no output replaces another.
Result<void> checkOutputs(const StateOptions& options, const std::vector<fs::path>& read)
{
    std::vector<fs::path> outputs;
    for (const std::string* out : options.outputs) {
        if (const auto kept = refuseToReplace(read, *out); !kept)
            return problem(kept.error());
        if (!out->empty() && std::ranges::count(outputs, absolutePath(*out)))
            return problem({"two outputs would be written to this file", *out, "Give each a name of its own"}, WrongUsage);
        outputs.push_back(absolutePath(*out));
    }
    return {};
}

std::vector<fs::path> filesRead(const StateOptions& options, const Opened& opened)
{
    std::vector<fs::path> read = options.filesRead();
    const std::vector<fs::path> named = filesOf(opened.state);
    read.insert(read.end(), named.begin(), named.end());
    for (const auto& [file, image] : opened.images) // also those that were only looked at
        read.push_back(fileOfPicture(file));
    return read;
}

std::vector<fs::path> picturesOf(const Mesh& mesh)
{
    std::vector<fs::path> pictures;
    for (const MeshMaterial& material : mesh.materials) {
        const std::vector<fs::path> files = filesOf(material.maps);
        pictures.insert(pictures.end(), files.begin(), files.end());
    }
    return pictures;
}
} // namespace

Result<Opened> openState(const StateOptions& options, const Progress& progress)
{
    Opened opened;
    std::error_code code;
    if (!options.source.empty()) {
        auto fromSource = openSource(options.source, State(), progress);
        // A folder whose names tell nothing is no trouble where the maps are named.
        const bool named = options.givesMaps() && fs::is_directory(options.source, code);
        if (!fromSource && !(named && fromSource.error().code == ErrorCode::Refused))
            return problem(fromSource.error());
        if (fromSource)
            opened = std::move(*fromSource);
        else
            opened.state.name = absolutePath(options.source).filename().string();
    } else if (!options.givesMaps()) {
        return problem({"there is nothing to open", "SOURCE", "Name a folder, an image, a project or sample:bricks"}, WrongUsage);
    }
    if (const auto done = setMaps(options, opened); !done)
        return problem(done.error());
    if (const auto done = applyOptions(options, opened); !done)
        return tl::unexpected(done.error());
    if (const auto kept = checkOutputs(options, filesRead(options, opened)); !kept)
        return tl::unexpected(kept.error());
    const Warnings doubts = doubtsOf(opened.state);
    opened.warnings.insert(opened.warnings.end(), doubts.begin(), doubts.end());
    return opened;
}

namespace {
// A moment that the mesh does not have.
std::optional<Warning> missingClip(const Scene& scene)
{
    const Mesh& mesh = *scene.resources.mesh;
    const Parameters parameters = effectiveParameters(scene.state, 0);
    const std::size_t clips = mesh.deformation ? mesh.deformation->clips.size() : 0;
    if (std::size_t(parameters.clip) < clips || (parameters.clip == 0 && parameters.time == 0.f))
        return std::nullopt;
    const std::string has = clips == 0 ? "no animation" : clips == 1 ? "one animation, 0" : "animations 0 to " + std::to_string(clips - 1);
    return Warning{"no-clip", mesh.name + " has " + has + "; it is shown at rest."};
}
} // namespace

Result<SearchInput> openHeights(const StateOptions& options, const Progress& progress)
{
    const auto opened = openState(options, progress.part(0.f, 0.5f));
    if (!opened)
        return tl::unexpected(opened.error());
    SearchInput input{opened->state.panes.front().technique, effectiveParameters(opened->state, 0), {}, opened->warnings};
    MapSlots slots; // the search reads heights only
    slots[std::size_t(MapKind::Height)] = opened->state.slots[std::size_t(MapKind::Height)];
    if (slots == MapSlots())
        return input;
    const auto material = loadMaterial(slots, opened->images, nullptr, progress.part(0.5f, 1.f));
    if (!material)
        return problem(material.error());
    input.warnings.insert(input.warnings.end(), material->warnings.begin(), material->warnings.end());
    if (material->height)
        input.field = material->height->withWrap(input.parameters.wrap);
    return input;
}

Result<Scene> openScene(const StateOptions& options, const Progress& progress, bool isDrawn)
{
    auto opened = openState(options, progress.part(0.f, 0.5f));
    if (!opened)
        return tl::unexpected(opened.error());
    State needed = opened->state;
    for (Pane& pane : needed.panes)
        pane.technique = isDrawn ? pane.technique : "flat";
    auto resources = loadResources(needed, opened->images, {}, progress.part(0.5f, 1.f));
    if (!resources)
        return problem(resources.error());
    if (const auto kept = checkOutputs(options, picturesOf(*resources->mesh)); !kept)
        return tl::unexpected(kept.error());
    Scene scene{std::move(opened->state), std::move(*resources), std::move(opened->warnings)};
    const Resources& loaded = scene.resources;
    for (const Warnings* more : {&loaded.material->warnings, &loaded.mesh->warnings, &loaded.environment->warnings})
        scene.warnings.insert(scene.warnings.end(), more->begin(), more->end()); // what stands in both is told once
    for (auto warning : {missingClip(scene), tooDeep(scene.state, scene.resources)})
        if (warning)
            scene.warnings.push_back(std::move(*warning));
    return scene;
}

namespace {
bool progressIsShown = false; // on a line of stderr that has not ended
}

Progress shownProgress(const Common& common)
{
    Progress progress;
    if (common.quiet || !(common.progress || isatty(STDERR_FILENO)))
        return progress;
    struct Told {
        std::mutex mutex;
        int percent = -1;
    };
    progress.report = [told = std::make_shared<Told>()](float share) {
        const int percent = int(share * 100.f);
        const std::scoped_lock lock(told->mutex); // told in the order of the test, too
        if (percent <= told->percent) // never back, whatever the order in which threads tell
            return;
        told->percent = percent;
        std::fprintf(stderr, "\r%3d %%%s", percent, percent == 100 ? "\n" : "");
        progressIsShown = percent != 100;
    };
    return progress;
}

int tell(const CLI::App& app, const CLI::ParseError& error, const std::string& command)
{
    if (error.get_exit_code() == 0)
        return app.exit(error);
    std::string what = error.what();
    while (!what.empty() && (what.back() == '.' || what.back() == '\n' || what.back() == ' '))
        what.pop_back();
    return tell({{what, command, "relievo " + (command.empty() ? command : command + ' ') + "--help lists what there is"}, WrongUsage});
}

int tell(const Problem& problem)
{
    std::fprintf(stderr, "%srelievo: error: %s\n", std::exchange(progressIsShown, false) ? "\n" : "", message(problem.error).c_str());
    return problem.exitCode;
}

namespace {
// A set and the material made of it tell the same of a file.
Warnings once(const Warnings& warnings)
{
    Warnings kept;
    for (const Warning& warning : warnings)
        if (!std::ranges::count(kept, warning))
            kept.push_back(warning);
    return kept;
}
} // namespace

void tell(const Warnings& warnings, const Common& common)
{
    if (!common.quiet)
        for (const Warning& warning : once(warnings))
            std::fprintf(
                stderr, "%srelievo: warning: %s\n", std::exchange(progressIsShown, false) ? "\n" : "", shownText(warning.text).c_str());
}

namespace {
// JSON leaves these as they are, and terminals obey them: DEL, and the second set of control characters.
std::string withoutControls(const std::string& json)
{
    std::string text;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const auto byte = [&json](std::size_t at) { return at < json.size() ? static_cast<unsigned char>(json[at]) : 0; };
        const bool isSecondSet = byte(i) == 0xC2 && byte(i + 1) >= 0x80 && byte(i + 1) < 0xA0;
        if (byte(i) != 0x7F && !isSecondSet) {
            text += json[i];
            continue;
        }
        char escape[8];
        std::snprintf(escape, sizeof escape, "\\u%04x", unsigned(isSecondSet ? byte(++i) : byte(i)));
        text += escape;
    }
    return text;
}
} // namespace

void print(const nlohmann::ordered_json& result)
{
    std::puts(withoutControls(result.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)).c_str());
}

nlohmann::ordered_json warningsJson(const Warnings& warnings)
{
    auto list = nlohmann::ordered_json::array();
    for (const Warning& warning : once(warnings))
        list.push_back({{"code", warning.code}, {"text", warning.text}});
    return list;
}

} // namespace relievo::cli
