// Reading files for the window, off its thread.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/load_jobs.h"
#include "app/window/document/starting_scene.h"
#include "core/ground/file.h"
#include "core/image/sets/texture_set.h"
#include "core/scene/maps_to_come.h"
#include "core/scene/source.h"
#include <utility>

namespace relievo {
namespace {
bool hasMap(const Material& material, MapKind kind)
{
    return kind == MapKind::Height ? material.height.has_value() : material.map(kind) != nullptr;
}

// A file that `next` names anew but that could not be read.
std::optional<Error> newFileThatFailed(const State& before, const State& next, const Shown& shown)
{
    if (shown.mesh && next.mesh != before.mesh)
        return shown.mesh->why;
    if (shown.environment && next.environment != before.environment)
        return shown.environment->why;
    const Material& material = *shown.resources.material;
    for (const MapKindRow& row : kMapKinds) {
        const MapSlot& slot = next.slots[std::size_t(row.kind)];
        if (slot.empty() || slot == before.slots[std::size_t(row.kind)] || hasMap(material, row.kind))
            continue;
        for (const Warning& warning : material.warnings)
            if (isAbout(warning, slot.file))
                return Error{warning.text.ends_with('.') ? warning.text.substr(0, warning.text.size() - 1) : warning.text, "", ""};
        return Error{"the map could not be read", slot.file, "Choose another file"};
    }
    return {};
}

// Where a job's turn finds the document and the data.
struct Turn {
    const State& now;
    const Shown& previous;
    const Progress& progress;
    const EarlyLoaded& early;
};

// Loads what loaded.opened.state names.
Expected<Loaded> withFiles(Loaded loaded, const Shown& previous, const Progress& progress)
{
    auto shown = loadWhatIsThere(loaded.opened.state, loaded.opened.images, previous, progress);
    if (!shown)
        return tl::unexpected(shown.error());
    loaded.shown = std::move(*shown);
    loaded.opened.images = {};
    return loaded;
}

// For what is opened: nothing is taken over of files that have changed since, at rest or not.
Shown withoutChanged(Shown shown)
{
    shown.stale.merge(changedSince(shown.files));
    return shown;
}

// Before a SOURCE is read, which reads pictures too.
FileStamps stampsBeside(const QString& source)
{
    if (isBuiltInSource(source.toStdString()))
        return {};
    const std::filesystem::path path = absolutePath(source.toStdString());
    std::error_code code;
    return stampsIn(std::filesystem::is_directory(path, code) ? path : path.parent_path());
}

// Loads what is there of a texture set, tells it with stand-ins, and leaves it in `before`, so that nothing is made twice. Not when it
// would have to wait for acceleration maps.
void tellEarly(Loaded part, Shown& before, const Turn& turn)
{
    const EnumSet<MapKind> coming = part.opened.coming;
    if (!needsOf(part.opened.state).accelerationMaps.empty())
        return;
    auto loaded = withFiles(std::move(part), before, Progress{{}, turn.progress.stop});
    if (!loaded)
        return;
    Shown& shown = loaded->shown;
    before.resources = shown.resources, before.mesh = shown.mesh, before.environment = shown.environment;
    shown.resources.material = withMapsToCome(*shown.resources.material, coming, loaded->opened.state.parameters.depth);
    turn.early(*loaded);
}

Expected<Loaded> loadSource(const QString& source, const State& base, const Turn& turn, bool onlyMaterial = false)
{
    const FileStamps beside = stampsBeside(source);
    Shown before = withoutChanged(turn.previous);
    const auto early = [&](const Opened& part) { tellEarly({.base = base, .opened = part, .shown = {}}, before, turn); };
    auto opened = openSource(source.toStdString(), base, turn.progress.part(0.f, 0.6f), turn.early ? EarlyOpened(early) : EarlyOpened());
    if (!opened)
        return tl::unexpected(opened.error());
    if (onlyMaterial)
        opened->state.mesh = base.mesh, opened->state.part = base.part;
    auto loaded = withFiles({.base = base, .opened = std::move(*opened), .shown = {}}, before, turn.progress.part(0.6f, 1.f));
    if (loaded)
        for (auto& [name, stamp] : loaded->shown.files)
            if (const auto seen = beside.find(name); seen != beside.end())
                stamp = seen->second;
    return loaded;
}

Expected<Loaded> loadFor(const OpenDocument& job, const Turn& turn)
{
    return loadSource(job.source, job.base.value_or(turn.now), turn);
}

Expected<Loaded> loadFor(const OpenState& job, const Turn& turn)
{
    return withFiles({.base = job.state, .opened = {.state = job.state, .images = {}, .warnings = job.warnings}, .shown = {}},
        withoutChanged(turn.previous), turn.progress);
}

bool isLightOrCamera(const ParameterRow& row)
{
    return (row.group >= Group::Light && row.group <= Group::Camera) || row.key == "lightSize";
}

// What the SOURCE is read on.
State groundFor(const OpenInto& job, const State& now)
{
    State ground;
    ground.camera = now.camera;
    ground.environment = now.environment;
    for (const ParameterRow& row : kParameters)
        if (isLightOrCamera(row))
            set(ground.parameters, row, get(now.parameters, row));
    // Before the starting scene's backdrop its shape and outline are the defaults too; a plane would be seen from its edge there.
    if (const State scene = startingScene(); now.parameters.background == scene.parameters.background) {
        ground.mesh = scene.mesh;
        ground.parameters.silhouettes = scene.parameters.silhouettes;
        ground.parameters.background = scene.parameters.background;
        ground.parameters.ground = now.parameters.ground, ground.parameters.groundReflection = now.parameters.groundReflection;
    }
    ground.panes = now.panes;
    for (Pane& pane : ground.panes)
        std::erase_if(pane.overrides, [](const auto& own) {
            const ParameterRow* row = findParameter(own.first);
            return !row || !isLightOrCamera(*row);
        });
    if (job.asStep || job.onlyMaterial)
        ground.mesh = now.mesh, ground.part = now.part;
    return ground;
}

Expected<Loaded> loadFor(const OpenInto& job, const Turn& turn)
{
    return loadSource(job.source, groundFor(job, turn.now), turn, job.onlyMaterial);
}

Expected<Loaded> loadFor(const EditNeeds& job, const Turn& turn)
{
    Loaded loaded{.base = turn.now, .opened = {.state = turn.now, .images = {}, .warnings = {}}, .shown = {}};
    loaded.change = job.look ? job.look(loaded.opened.images, loaded.opened.warnings) : job.change;
    loaded.change(loaded.opened.state);
    auto result = withFiles(std::move(loaded), turn.previous, turn.progress);
    if (result)
        if (const auto error = newFileThatFailed(turn.now, result->opened.state, result->shown))
            return tl::unexpected(*error);
    return result;
}

Expected<Loaded> loadFor(const Follow&, const Turn& turn)
{
    return withFiles(
        {.base = turn.now, .opened = {.state = turn.now, .images = {}, .warnings = {}}, .shown = {}}, turn.previous, turn.progress);
}
} // namespace

bool replacesDocument(const Job& job)
{
    return std::holds_alternative<OpenDocument>(job) || std::holds_alternative<OpenState>(job);
}

bool isOpening(const Job& job)
{
    return replacesDocument(job) || std::holds_alternative<OpenInto>(job);
}

bool isChange(const Job& job)
{
    const auto* into = std::get_if<OpenInto>(&job);
    return std::holds_alternative<EditNeeds>(job) || (into && into->asStep);
}

EditNeeds assignment(const QString& text, MapKind kind, const std::string& file)
{
    const auto put = [kind](const MapSlot& slot) { return [kind, slot](State& state) { state.slots[std::size_t(kind)] = slot; }; };
    if (file.empty())
        return {.text = text, .change = put({})};
    const auto look
        = [put, kind, file](DecodedImages& images, Warnings& warnings) { return put(slotByHand(kind, file, images, warnings)); };
    return {.text = text, .change = put({file}), .look = look};
}

bool isWholeDocument(const QString& source)
{
    return isProjectFile(source.toStdString()) || source.startsWith("scene:");
}

OpenDocument firstDocument(const State& now, const std::optional<Error>& insteadOf)
{
    return {.source = kStartingSource, .before = now, .base = startingScene(), .counted = false, .insteadOf = insteadOf};
}

bool standsInForAnother(const Job& job)
{
    const auto* opening = std::get_if<OpenDocument>(&job);
    return opening && opening->insteadOf;
}

Expected<Loaded> load(const Job& job, const State& now, const Shown& previous, const Progress& progress, const EarlyLoaded& early)
{
    return std::visit([turn = Turn{now, previous, progress, early}](const auto& kind) { return loadFor(kind, turn); }, job);
}

} // namespace relievo
