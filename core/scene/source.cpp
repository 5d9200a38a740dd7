// One way in: projects, texture sets, single images and samples.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/source.h"
#include "core/gltf/pictures.h"
#include "core/ground/file.h"
#include "core/ground/foreign_file.h"
#include "core/ground/name_forms.h"
#include "core/ground/text.h"
#include "core/image/samples/hard_cases.h"
#include "core/image/samples/samples.h"
#include "core/scene/materials/material_file.h"
#include "core/scene/relief_numbers.h"
#include "core/state/presets.h"
#include "core/state/sample_names.h"
#include <algorithm>
#include <charconv>

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
        return failure(ErrorCode::NotFound, "sample:" + std::string(text), "there is no such sample", "There are " + keysOf(kSamples));
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
        return failure(ErrorCode::NotFound, "hard:" + std::string(text), "there is no such hard case", "There are " + keysOf(kHardCases));
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
        return failure(ErrorCode::NotFound, source, "there is no such scene", "There are " + keys);
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

// A relief without heights cannot be drawn.
void drawWithoutHeights(State& state)
{
    if (!state.slots[std::size_t(MapKind::Height)].empty())
        return;
    for (Pane& pane : state.panes)
        if (const TechniqueRow* technique = findTechnique(pane.technique); technique && technique->needsHeights())
            pane.technique = "bump";
}

Expected<Opened> openMaterial(const fs::path& file, const State& base)
{
    auto read = readMaterialFile(file, base);
    if (!read)
        return tl::unexpected(read.error());
    Opened opened{std::move(read->state), {}, std::move(read->warnings)};
    opened.bringsValues = true;
    drawWithoutHeights(opened.state);
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
        return failure(file.string(), "this mesh brings no textures of its own", "Open a texture set, and show it on this mesh");
    Opened opened{base, {}, {}};
    opened.state.mesh = file.string();
    opened.state.slots = material->maps;
    drawWithoutHeights(opened.state);
    opened.bringsValues = material->factors || material->relief;
    if (material->factors)
        takeFactors(opened.state, *material->factors, material->maps);
    if (material->relief)
        takeRelief(opened.state, *material->relief, double(mesh->metresPerUV));
    opened.state.name = file.stem().string();
    return opened;
}
// A relief object has its pictures to itself: there are no maps.
Opened openObject(const fs::path& file, const State& base)
{
    Opened opened{base, {}, {}};
    opened.state.mesh = file.string();
    opened.state.part.clear();
    opened.state.slots = {};
    const std::string name = file.filename().string();
    opened.state.name = name.substr(0, name.size() - kObjectSuffix.size());
    fitTechniques(opened.state);
    return opened;
}
// A texture set of a SOURCE, whole or as far as it has been read.
Opened openedSet(TextureSet set, const fs::path& path, const State& base)
{
    std::error_code code;
    Opened opened{base, std::move(set.images), std::move(set.warnings)};
    opened.coming = set.coming;
    opened.state.slots = set.slots();
    opened.state.name = set.name;
    if (const auto heights = opened.images.find(opened.state.slots[std::size_t(MapKind::Height)].file); heights != opened.images.end())
        takeHeightNumbers(opened.state, heights->second->image, opened.warnings);
    if (fs::is_directory(path, code))
        takeReliefJson(path, opened.state, opened.warnings);
    opened.bringsValues = opened.state.parameters != base.parameters || opened.state.panes != base.panes;
    return opened;
}
} // namespace

bool isBuiltInSource(std::string_view source)
{
    return namesSample(source) || source.starts_with("scene:") || source.starts_with("hard:");
}

bool isMeshFile(const fs::path& file)
{
    constexpr std::array<std::string_view, 6> suffixes = {".gltf", ".glb", ".obj", ".ply", ".stl", ".off"};
    return std::ranges::count(suffixes, lowerSuffix(file)) > 0 || isObjectName(file.string());
}

bool isProjectFile(const fs::path& file)
{
    return lowerSuffix(file) == ".relievo";
}

Expected<Opened> openSource(const std::string& source, const State& base, const Progress& progress, const EarlyOpened& told)
{
    if (namesSample(source))
        return source.starts_with("sample:hard-") ? openHardCase(std::string_view(source).substr(12), base)
                                                  : openSample(std::string_view(source).substr(7), base);
    if (source.starts_with("scene:"))
        return openScene(source, base);
    if (source.starts_with("hard:"))
        return openHardCase(std::string_view(source).substr(5), base);
    std::error_code code;
    const fs::path given = absolutePath(source), path = thatLooksLike(given).value_or(given);
    if (source.empty() || (!fs::exists(path, code) && !pictureMayExist(path)))
        return failure(ErrorCode::NotFound, source.empty() ? "SOURCE" : source, "there is no such file or folder", "Check the path");
    if (isObjectName(path.string()))
        return openObject(path, base);
    if (isMaterialFile(path))
        return openMaterial(path, base);
    if (std::optional<Error> foreign = foreignFile(path))
        return tl::unexpected(std::move(*foreign));
    if (isProjectFile(path)) {
        auto read = readState(base, path);
        if (!read)
            return tl::unexpected(read.error());
        return Opened{std::move(read->state), {}, std::move(read->warnings)};
    }
    if (isMeshFile(path))
        return openMeshMaterial(path, base, progress);
    const auto early = [&](const TextureSet& part) { told(openedSet(part, path, base)); };
    return openTextureSet(path, progress, told ? EarlySet(early) : EarlySet()).map([&](TextureSet&& set) {
        return openedSet(std::move(set), path, base);
    });
}

} // namespace relievo
