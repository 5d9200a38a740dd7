// The table of export targets and the one function that runs a row.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/scene/resources.h"
#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

namespace relievo {

struct ExportJob {
    const State& state;
    const Resources& resources;
    std::filesystem::path out; // a file, or a folder (made when missing) when the row says so
    int size = 0; // texels of the longest side of written textures; 0 keeps each map's own size
    Progress progress;
    std::vector<std::filesystem::path> alsoRead = {}; // beside what the State names: the project, a preset
};
struct Exported {
    std::vector<std::filesystem::path> files; // what was written
    Warnings warnings; // what the target will get wrong, or what was left out
};

struct ExportRow {
    std::string_view key;
    std::string_view label;
    std::string_view suffix; // ".glb"; "" when `out` is a folder
    Expected<Exported> (*run)(const ExportJob& job);
    std::vector<std::filesystem::path> (*writes)(const ExportJob& job); // the files that `run` makes or replaces
    std::string_view help;
};

// Folders that are missing are made. What the material was opened from is never written over: an error when `file` is one of the State's
// own, of the mesh's pictures or of what else was read.
Expected<void> refuseToOverwriteSources(const ExportJob& job, const std::filesystem::path& file);

Expected<Exported> exportGltf(const ExportJob& job);
Expected<Exported> exportTextures(const ExportJob& job);
Expected<Exported> exportPreset(const ExportJob& job);
std::vector<std::filesystem::path> filesOfGltf(const ExportJob& job);
std::vector<std::filesystem::path> filesOfTextures(const ExportJob& job);
std::vector<std::filesystem::path> filesOfPreset(const ExportJob& job);

inline constexpr auto kExports = std::to_array<ExportRow>({
    {"gltf", "glTF binary", ".glb", exportGltf, filesOfGltf,
        "Mesh and material in one file: base color, normal, packed occlusion-roughness-metallic, height in RELIEVO_materials_relief."},
    {"textures", "Texture folder", "", exportTextures, filesOfTextures,
        "Each map as its own file, height at 16 bits, and relief.json with the physical depth."},
    {"preset", "Relievo preset", ".json", exportPreset, filesOfPreset,
        "The material's parameters without its files, to be laid on other materials."},
});

const ExportRow* findExport(std::string_view key); // nullptr when unknown

} // namespace relievo
