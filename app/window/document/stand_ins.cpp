// Defaults for files that have moved.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/stand_ins.h"
#include "core/gltf/pictures.h"
#include <QFileInfo>
#include <algorithm>

namespace relievo {
namespace {
bool isThere(const MapSlot& slot)
{
    return slot.file.starts_with("sample:") || pictureMayExist(slot.file);
}

// The material of slots whose files have all moved: empty, and it says which.
std::shared_ptr<const Material> movedAway(const MapSlots& slots)
{
    Material material;
    material.slots = slots;
    for (const MapKindRow& kind : kMapKinds)
        if (const MapSlot& slot = slots[std::size_t(kind.kind)]; !slot.empty())
            material.warnings.push_back(
                {"map-missing", slot.file + ": the " + std::string(kind.label) + " map is not there. Locate or clear it."});
    return std::make_shared<const Material>(std::move(material));
}

QDateTime changeOf(const std::string& file)
{
    return QFileInfo(QString::fromStdString(file)).lastModified();
}

bool isBack(const std::optional<StandIn>& standIn, const std::string& file)
{
    return standIn && changeOf(file) != standIn->changed;
}

// Whether `slot` was told to be missing and is there now.
bool isBack(const Material& material, const MapSlot& slot)
{
    return !slot.empty() && std::ranges::any_of(material.warnings, [&](const Warning& warning) {
        return warning.code == "map-missing" && isAbout(warning, slot.file);
    }) && pictureMayExist(slot.file);
}

// As if what is there again had never been looked for.
void forgetWhatIsBack(Shown& shown)
{
    Resources& resources = shown.resources;
    if (isBack(shown.mesh, resources.meshName))
        resources.meshName.clear();
    if (isBack(shown.environment, resources.environmentName))
        resources.environmentName.clear();
    if (!resources.material
        || std::ranges::none_of(resources.material->slots, [&](const MapSlot& slot) { return isBack(*resources.material, slot); }))
        return;
    Material others = *resources.material;
    for (MapSlot& slot : others.slots)
        if (isBack(*resources.material, slot))
            slot = {};
    resources.material = std::make_shared<const Material>(std::move(others));
}

// Loads `name` by open(name), or `instead` when that fails, unless `loaded` is what was loaded for it already.
template <class Value, class Open>
Expected<void> load(std::shared_ptr<const Value>& loaded, std::string& loadedName, std::optional<StandIn>& standIn, const std::string& name,
    const char* instead, const Open& open)
{
    if (loaded && loadedName == name)
        return {};
    const QDateTime changed = changeOf(name);
    Expected<Value> value = open(name);
    if (!value && isCancelled(value.error()))
        return tl::unexpected(value.error());
    standIn = value ? std::optional<StandIn>() : StandIn{value.error(), changed};
    if (!value)
        value = open(instead);
    if (!value)
        return tl::unexpected(value.error());
    loaded = std::make_shared<const Value>(std::move(*value));
    loadedName = name;
    return {};
}

std::string sentence(const StandIn& standIn, const std::string& file, const std::string& kind, const std::string& instead)
{
    return standIn.changed.isValid()
        ? file + ": the " + kind + " cannot be read (" + standIn.why.what + "), so " + instead + "; mend it, or choose another one."
        : file + ": the " + kind + " is not there, so " + instead + "; put it back, or choose another one.";
}
} // namespace

bool isAbout(const Warning& warning, const std::string& file)
{
    return warning.text.starts_with(file + ": ") || warning.text.find('(' + file + ')') != std::string::npos;
}

Expected<Shown> loadWhatIsThere(const State& state, const DecodedImages& images, Shown shown, const Progress& progress)
{
    forgetWhatIsBack(shown);
    Resources& loaded = shown.resources;
    const bool onlyMaps = loaded.mesh && loaded.meshName == state.mesh && loaded.environment && loaded.environmentName == state.environment;
    if (const auto mesh = load(loaded.mesh, loaded.meshName, shown.mesh, state.mesh, "plane",
            [&](const std::string& name) { return openMesh(name, progress.part(0.f, 0.2f)); });
        !mesh)
        return tl::unexpected(mesh.error());
    if (const auto environment = load(loaded.environment, loaded.environmentName, shown.environment, state.environment, "studio",
            [&](const std::string& name) { return openEnvironment(name, progress.part(0.2f, 0.3f)); });
        !environment)
        return tl::unexpected(environment.error());
    if (state.slots != MapSlots{} && std::ranges::none_of(state.slots, isThere))
        loaded.material = movedAway(state.slots);
    auto resources = loadResources(state, images, loaded, progress.part(onlyMaps ? 0.f : 0.3f, 1.f));
    if (!resources)
        return tl::unexpected(resources.error());
    shown.resources = std::move(*resources);
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

bool isBack(const Shown& shown)
{
    const Resources& loaded = shown.resources;
    return isBack(shown.mesh, loaded.meshName) || isBack(shown.environment, loaded.environmentName)
        || (loaded.material
            && std::ranges::any_of(loaded.material->slots, [&](const MapSlot& slot) { return isBack(*loaded.material, slot); }));
}

} // namespace relievo
