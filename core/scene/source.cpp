// One way in: projects, texture sets, single images and samples.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/source.h"
#include "core/ground/file.h"
#include "core/ground/text.h"
#include "core/image/samples/hard_cases.h"
#include "core/image/samples/samples.h"
#include "core/scene/relief_numbers.h"
#include "core/state/presets.h"
#include <algorithm>
#include <charconv>
#include <cmath>

namespace relievo {
namespace fs = std::filesystem;

namespace {
template <class Rows> std::string keysOf(const Rows& rows)
{
    std::string keys;
    for (const auto& row : rows)
        keys += (keys.empty() ? "" : ", ") + std::string(row.key);
    return keys;
}

// KEY or KEY@SIZE, as it follows "sample:".
struct SampleName {
    std::string_view key;
    int size; // 0 when it cannot be made
};
SampleName sampleName(std::string_view text, int plainSize)
{
    SampleName name{text.substr(0, text.find('@')), plainSize};
    if (name.key.size() < text.size()) {
        const auto [end, code] = std::from_chars(text.data() + name.key.size() + 1, text.data() + text.size(), name.size);
        name.size = code == std::errc() && end == text.data() + text.size() && name.size <= 8192 ? std::max(name.size, 0) : 0;
    }
    return name;
}
constexpr std::string_view kSizeWrong = "this size cannot be made", kSizesPossible = "1 to 8192 texels are possible";

Expected<Opened> openSample(std::string_view text, const State& base)
{
    const SampleName name = sampleName(text, kSampleSize);
    const SampleRow* sample = findSample(name.key);
    if (!sample)
        return failure("sample:" + std::string(text), "there is no such sample", "There are " + keysOf(kSamples));
    if (name.size == 0)
        return failure("sample:" + std::string(text), std::string(kSizeWrong), std::string(kSizesPossible));
    Opened opened{base, {}, {}};
    opened.state.slots = sampleSlots(name.key, name.size);
    opened.state.name = sample->label;
    opened.state.parameters.depth = sample->depth;
    return opened;
}

Expected<Opened> openHardCase(std::string_view text, const State& base)
{
    const SampleName name = sampleName(text, kHardCaseSize);
    const HardCaseRow* row = findHardCase(name.key);
    if (!row)
        return failure("hard:" + std::string(text), "there is no such hard case", "There are " + keysOf(kHardCases));
    if (name.size == 0)
        return failure("hard:" + std::string(text), std::string(kSizeWrong), std::string(kSizesPossible));
    Opened opened{base, {}, {}};
    opened.state.slots = hardCaseSlots(row->key, name.size);
    opened.state.name = row->label;
    opened.state.parameters.depth = kHardCaseDepth;
    return opened;
}

// "scene:KEY": a preset with a sample of its own.
Expected<Opened> openScene(const std::string& source, const State& base)
{
    const auto row = std::ranges::find(kPresets, std::string_view(source).substr(6), &PresetRow::key);
    if (row == kPresets.end() || row->sample.empty()) {
        std::string keys;
        for (const PresetRow& preset : kPresets)
            if (!preset.sample.empty())
                keys += (keys.empty() ? "" : ", ") + std::string(preset.key);
        return failure(source, "there is no such scene", "There are " + keys);
    }
    auto opened = openSample(row->sample, base);
    if (!opened)
        return opened;
    auto read = readPreset(opened->state, std::string(row->key));
    if (!read)
        return tl::unexpected(read.error());
    opened->state = std::move(read->state);
    opened->state.name = row->label;
    return opened;
}

// A mesh file as SOURCE: the first of its materials that has maps, on all parts. Without heights it is shown as bump.
Expected<Opened> openMeshMaterial(const fs::path& file, const State& base, const Progress& progress)
{
    const auto mesh = openMesh(file.string(), progress);
    if (!mesh)
        return tl::unexpected(mesh.error());
    const auto material = std::ranges::find_if(mesh->materials, [](const MeshMaterial& m) { return m.maps != MapSlots(); });
    if (material == mesh->materials.end())
        return failure(file.string(), "this mesh brings no textures of its own", "Open a texture set and give the mesh by --mesh");
    Opened opened{base, {}, {}};
    opened.state.mesh = file.string();
    opened.state.slots = material->maps;
    if (opened.state.slots[std::size_t(MapKind::Height)].file.empty()) // a relief without heights cannot be drawn
        for (Pane& pane : opened.state.panes)
            if (const TechniqueRow* technique = findTechnique(pane.technique); technique && listHas(technique->maps, "height"))
                pane.technique = "bump";
    opened.bringsValues = material->factors || material->relief;
    if (material->factors)
        takeFactors(opened.state, *material->factors, material->maps);
    if (material->relief)
        takeRelief(opened.state, *material->relief, double(mesh->metresPerUV));
    opened.state.name = file.stem().string();
    return opened;
}
} // namespace

bool isBuiltInSource(std::string_view source)
{
    return source.starts_with("sample:") || source.starts_with("scene:") || source.starts_with("hard:");
}

bool isMeshFile(const fs::path& file)
{
    constexpr std::array<std::string_view, 6> suffixes = {".gltf", ".glb", ".obj", ".ply", ".stl", ".off"};
    return std::ranges::count(suffixes, lowerSuffix(file)) > 0;
}

bool isProjectFile(const fs::path& file)
{
    return lowerSuffix(file) == ".relievo";
}

Expected<Opened> openSource(const std::string& source, const State& base, const Progress& progress)
{
    if (source.starts_with("sample:"))
        return source.starts_with("sample:hard-") ? openHardCase(std::string_view(source).substr(12), base)
                                                  : openSample(std::string_view(source).substr(7), base);
    if (source.starts_with("scene:"))
        return openScene(source, base);
    if (source.starts_with("hard:"))
        return openHardCase(std::string_view(source).substr(5), base);
    std::error_code code;
    const fs::path path = absolutePath(source);
    if (source.empty() || !fs::exists(path, code))
        return failure(source.empty() ? "SOURCE" : source, "there is no such file or folder", "Check the path");
    if (isProjectFile(path)) {
        auto read = readState(base, path);
        if (!read)
            return tl::unexpected(read.error());
        return Opened{std::move(read->state), {}, std::move(read->warnings)};
    }
    if (isMeshFile(path))
        return openMeshMaterial(path, base, progress);
    auto set = openTextureSet(path, progress);
    if (!set)
        return tl::unexpected(set.error());
    Opened opened{base, std::move(set->images), std::move(set->warnings)};
    opened.state.slots = set->slots();
    opened.state.name = set->name;
    if (fs::is_directory(path, code))
        opened.bringsValues = takeReliefJson(path, opened.state, opened.warnings);
    return opened;
}

Pose poseOf(const Mesh& mesh, const Parameters& parameters)
{
    const auto clip = std::size_t(parameters.clip);
    const bool known = mesh.deformation && clip < mesh.deformation->clips.size();
    const float length = known ? mesh.deformation->clips[clip].seconds : 0.f;
    return poseAt(mesh, parameters.clip, length > 0.f ? std::fmod(parameters.time, length) : 0.f);
}

Wrap wrapOf(const Parameters& parameters)
{
    return parameters.wrap == 1 ? Wrap::Clamp : Wrap::Repeat;
}

namespace {

// Makes the bound maps that the panes' techniques search with and that are not there; forgets the others.
Expected<void> loadBounds(const State& state, Resources& resources, const Progress& progress)
{
    std::map<Resources::BoundKey, Resources::Bound> bounds;
    float done = 0.f;
    const float all = float(std::max(missingBounds(state, resources).size(), std::size_t(1)));
    for (std::size_t pane = 0; pane < state.panes.size(); ++pane) {
        const TechniqueRow* technique = findTechnique(state.panes[pane].technique);
        if (!technique || technique->bound.empty() || !resources.material->height)
            continue;
        const bool isThere = boundFor(resources, *technique, effectiveParameters(state, pane)) != nullptr;
        const Progress share = progress.part(done / all, (done + 1.f) / all);
        if (const auto made = makeBound(resources, *technique, effectiveParameters(state, pane), share); !made)
            return made;
        done += isThere ? 0.f : 1.f;
        const Resources::BoundKey key = boundKey(*technique, effectiveParameters(state, pane));
        bounds[key] = resources.bounds[key];
    }
    resources.bounds = std::move(bounds);
    return {};
}

} // namespace

Resources::BoundKey boundKey(const TechniqueRow& technique, const Parameters& parameters)
{
    return {std::string(technique.bound), wrapOf(parameters)};
}

std::shared_ptr<const SearchTexture> boundFor(const Resources& resources, const TechniqueRow& technique, const Parameters& parameters)
{
    const auto found = resources.bounds.find(boundKey(technique, parameters));
    if (found == resources.bounds.end() || !resources.material || !resources.material->height)
        return nullptr;
    const Resources::Bound& bound = found->second;
    const bool fits = bound.heights == resources.material->height->identity() && (bound.allLevels || !parameters.heightMips);
    return fits ? bound.texture : nullptr;
}

Expected<void> makeBound(Resources& resources, const TechniqueRow& technique, const Parameters& parameters, const Progress& progress)
{
    if (technique.bound.empty() || !resources.material->height || boundFor(resources, technique, parameters))
        return {};
    const HeightField field = resources.material->height->withWrap(wrapOf(parameters));
    auto texture = searchTexture(technique.bound, field, parameters, parameters.heightMips, progress);
    if (!texture)
        return tl::unexpected(texture.error());
    resources.bounds[boundKey(technique, parameters)] = {std::move(*texture), field.identity(), parameters.heightMips};
    return {};
}

std::set<Resources::BoundKey> missingBounds(const State& state, const Resources& resources)
{
    std::set<Resources::BoundKey> missing;
    for (std::size_t pane = 0; pane < state.panes.size() && resources.material && resources.material->height; ++pane)
        if (const TechniqueRow* technique = findTechnique(state.panes[pane].technique); technique && !technique->bound.empty())
            if (const Parameters parameters = effectiveParameters(state, pane); !boundFor(resources, *technique, parameters))
                missing.insert(boundKey(*technique, parameters));
    return missing;
}

Expected<Resources> loadResources(const State& state, const DecodedImages& images, const Resources& previous, const Progress& progress)
{
    Resources resources = previous;
    const bool onlyBounds = resources.material && resources.material->slots == state.slots && resources.mesh
        && resources.meshName == state.mesh && resources.environment && resources.environmentName == state.environment;
    if (!resources.material || resources.material->slots != state.slots) {
        auto material = loadMaterial(state.slots, images, previous.material.get(), progress.part(0.f, 0.7f));
        if (!material)
            return tl::unexpected(material.error());
        resources.material = std::make_shared<const Material>(std::move(*material));
    }
    if (!resources.mesh || resources.meshName != state.mesh) {
        auto mesh = openMesh(state.mesh, progress.part(0.7f, 0.8f));
        if (!mesh)
            return tl::unexpected(mesh.error());
        resources.mesh = std::make_shared<const Mesh>(std::move(*mesh));
        resources.meshName = state.mesh;
    }
    if (!resources.environment || resources.environmentName != state.environment) {
        auto environment = openEnvironment(state.environment, progress.part(0.8f, 0.9f));
        if (!environment)
            return tl::unexpected(environment.error());
        resources.environment = std::make_shared<const Environment>(std::move(*environment));
        resources.environmentName = state.environment;
    }
    if (progress.cancelled())
        return failure(state.name, "cancelled");
    if (const auto baked = loadBounds(state, resources, progress.part(onlyBounds ? 0.f : 0.9f, 1.f)); !baked)
        return tl::unexpected(baked.error());
    progress.at(1.f);
    return resources;
}

} // namespace relievo
