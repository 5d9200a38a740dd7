// Defaults for files that have moved.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/stand_ins.h"
#include "core/gltf/buffers.h"
#include "core/gltf/pictures.h"
#include "core/ground/text.h"
#include "core/scene/scene_mesh.h"
#include "core/state/sample_names.h"
#include <algorithm>
#include <utility>

namespace relievo {
namespace {
bool isThere(const MapSlot& slot)
{
    return namesSample(slot.file) || pictureMayExist(slot.file);
}

bool hasMap(const Material& material, std::size_t kind)
{
    return MapKind(kind) == MapKind::Height ? material.height.has_value() : material.maps[kind] != nullptr;
}

// The material of slots of whose files none is there or can be read: empty, and it says which.
Material withoutMaps(const MapSlots& slots)
{
    Material material;
    material.slots = slots;
    for (const MapKindRow& kind : kMapKinds)
        if (const MapSlot& slot = slots[std::size_t(kind.kind)]; !slot.empty()) {
            const std::string map = slot.file + ": the " + std::string(kind.label) + " map ";
            material.warnings.push_back(isThere(slot) ? Warning{"map-broken", map + "cannot be read. Choose another file, or clear it."}
                                                      : Warning{"map-missing", map + "is not there. Locate or clear it."});
        }
    return material;
}

// Puts the map that `before` has of the slot in the place of the one that could not be read.
void keepMap(Material& material, const Material& before, const MapKindRow& kind)
{
    const std::size_t at = std::size_t(kind.kind);
    const MapSlot& slot = material.slots[at];
    material.height = kind.kind == MapKind::Height ? before.height : material.height;
    material.maps[at] = before.maps[at];
    const std::string map = " the " + lowered(kind.label) + " map", name = std::filesystem::path(slot.file).filename().string();
    std::erase_if(material.warnings, [&](const Warning& told) { // how loading told of this map
        return told.code.starts_with("map-") && isAbout(told, slot.file) && lowered(told.text).find(map) != std::string::npos;
    });
    for (const Warning& told : before.warnings)
        if (!told.code.starts_with("map-") && told.text.starts_with(name + ": ") && !std::ranges::count(material.warnings, told))
            material.warnings.push_back(told);
    material.warnings.push_back(isThere(slot) ? Warning{"map-broken",
                                    name + ":" + map + " cannot be read any more (" + slot.file
                                        + "), so it is shown as it was read before. Save it again, or choose another one."}
                                              : Warning{"map-missing",
                                                  name + ":" + map + " is not there any more (" + slot.file
                                                      + "), so it is shown as it was read before. Put it back, or locate or clear it."});
}

// The maps that the slots name; `shown` is what was before.
Expected<void> loadMaps(Shown& shown, const MapSlots& slots, const DecodedImages& images, const Progress& progress)
{
    std::shared_ptr<const Material>& loaded = shown.resources.material;
    const auto isStale = [&](const MapSlot& slot) { return shown.stale.contains(slot.file); };
    if (loaded && loaded->slots == slots && std::ranges::none_of(slots, isStale))
        return {};
    const Material before = loaded ? *loaded : Material();
    Material sound = before;
    for (MapSlot& slot : sound.slots)
        if (isStale(slot) || isTroubled(before, slot))
            slot = {};
    const bool gone = slots != MapSlots{} && std::ranges::none_of(slots, isThere);
    auto material = gone ? Expected<Material>(withoutMaps(slots)) : loadMaterial(slots, images, &sound, progress);
    const auto isKept = [&](std::size_t at) { return !slots[at].empty() && before.slots[at] == slots[at] && hasMap(before, at); };
    if (!material) {
        const bool any = std::ranges::any_of(kMapKinds, [&](const MapKindRow& kind) { return isKept(std::size_t(kind.kind)); });
        if (isCancelled(material.error()) || !any)
            return tl::unexpected(material.error());
        material = withoutMaps(slots);
    }
    for (const MapKindRow& kind : kMapKinds)
        if (const std::size_t at = std::size_t(kind.kind); isKept(at) && !hasMap(*material, at))
            keepMap(*material, before, kind);
    loaded = std::make_shared<const Material>(std::move(*material));
    return {};
}

// Loads `name` by open(name), unless `loaded` is what was loaded for it already and is not stale. When that fails `loaded` stays as it was
// read before, or else it is made by open(instead).
template <class Value, class Open>
Expected<void> load(std::shared_ptr<const Value>& loaded, std::string& loadedName, std::optional<StandIn>& standIn, const std::string& name,
    bool isStale, const char* instead, const Open& open)
{
    const bool isLoaded = loaded && loadedName == name;
    if (isLoaded && !isStale)
        return {};
    const bool wasRead = isLoaded && (!standIn || standIn->asBefore), isThere = stampOf(name).isThere;
    Expected<Value> value = open(name);
    if (!value && isCancelled(value.error()))
        return tl::unexpected(value.error());
    standIn = value ? std::optional<StandIn>() : StandIn{value.error(), isThere, wasRead};
    if (!value && wasRead)
        return {};
    if (!value)
        value = open(instead);
    if (!value)
        return tl::unexpected(value.error());
    loaded = std::make_shared<const Value>(std::move(*value));
    loadedName = name;
    return {};
}

// How the files are of which `shown` is now, after `before`; `stamps` were taken before anything was read.
void noteFiles(Shown& shown, const Shown& before, const FileStamps& stamps)
{
    const auto isSound = [&](const std::string& name) {
        return (name != shown.resources.meshName || !shown.mesh) && (name != shown.resources.environmentName || !shown.environment)
            && std::ranges::none_of(shown.resources.material->slots,
                [&](const MapSlot& slot) { return slot.file == name && isTroubled(*shown.resources.material, slot); });
    };
    shown.files.clear();
    shown.readAgain.clear();
    shown.stale.clear();
    for (const auto& [name, stamp] : stamps) {
        const auto known = before.files.find(name);
        const bool again = before.stale.contains(name);
        shown.files[name] = known != before.files.end() && !again ? known->second : stamp;
        if (again && known != before.files.end() && known->second.isThere && isSound(name))
            shown.readAgain.insert(name);
    }
}

std::string sentence(const StandIn& standIn, const std::string& file, const std::string& kind, const std::string& instead)
{
    const std::string more = standIn.asBefore ? " any more" : "";
    const std::string so = standIn.asBefore ? "so it is shown as it was read before" : "so " + instead;
    return standIn.isThere
        ? file + ": the " + kind + " cannot be read" + more + " (" + standIn.why.what + "), " + so + "; mend it, or choose another one."
        : file + ": the " + kind + " is not there" + more + ", " + so + "; put it back, or choose another one.";
}
} // namespace

bool isAbout(const Warning& warning, const std::string& file)
{
    return warning.text.starts_with(file + ": ") || warning.text.find('(' + file + ')') != std::string::npos;
}

bool isTroubled(const Material& material, const MapSlot& slot)
{
    return !slot.empty() && std::ranges::any_of(material.warnings, [&](const Warning& warning) {
        return (warning.code == "map-missing" || warning.code == "map-broken") && isAbout(warning, slot.file);
    });
}

Expected<Shown> loadWhatIsThere(const State& state, const DecodedImages& images, Shown shown, const Progress& progress)
{
    const Shown before = shown;
    const FileStamps stamps = stampsOf(state);
    Resources& loaded = shown.resources;
    const auto isStale = [&](const std::filesystem::path& file) { return shown.stale.contains(file.string()); };
    const bool staleMesh = isStale(state.mesh) || std::ranges::any_of(buffersBeside(state.mesh), isStale);
    const bool otherMesh = !loaded.mesh || loaded.meshName != state.mesh || staleMesh;
    const bool otherSky = !loaded.environment || loaded.environmentName != state.environment || shown.stale.contains(state.environment);
    if (const auto mesh = load(loaded.mesh, loaded.meshName, shown.mesh, state.mesh, staleMesh, "plane",
            [&](const std::string& name) { return openSceneMesh(name, progress.part(0.f, 0.2f)); });
        !mesh)
        return tl::unexpected(mesh.error());
    if (const auto environment
        = load(loaded.environment, loaded.environmentName, shown.environment, state.environment, shown.stale.contains(state.environment),
            "studio", [&](const std::string& name) { return openEnvironment(name, progress.part(0.2f, 0.3f)); });
        !environment)
        return tl::unexpected(environment.error());
    const Progress rest = progress.part(otherMesh || otherSky ? 0.3f : 0.f, 1.f);
    if (const auto maps = loadMaps(shown, state.slots, images, rest.part(0.f, 0.7f)); !maps)
        return tl::unexpected(maps.error());
    auto resources
        = loadResources(state, images, loaded, rest.part(shown.resources.material == before.resources.material ? 0.f : 0.7f, 1.f));
    if (!resources)
        return tl::unexpected(resources.error());
    shown.resources = std::move(*resources);
    noteFiles(shown, before, stamps);
    return shown;
}

Warnings warningsOf(const Shown& shown)
{
    Warnings warnings;
    if (shown.mesh)
        warnings.push_back({"mesh-missing", sentence(*shown.mesh, shown.resources.meshName, "mesh", "a plane stands in for it")});
    if (shown.environment)
        warnings.push_back({"environment-missing",
            sentence(*shown.environment, shown.resources.environmentName, "panorama", "the studio stands in for it")});
    return warnings;
}

} // namespace relievo
