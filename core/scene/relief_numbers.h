// Numbers beside the maps that files carry, taken into a State.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/image/image.h"
#include "core/mesh/mesh.h"
#include "core/state/state.h"
#include <array>
#include <filesystem>
#include <optional>
#include <utility>

namespace relievo {

// A parameter by its key, clamped to its range; what is no number is left out.
void takeNumber(State& state, std::string_view key, double value);

// What a glTF file says (RELIEVO_materials_relief), as far as it makes sense: numbers are clamped to their range, what is no number and
// techniques that draw no pictures are left out. metresPerUV: of the mesh, whose UV unit is the tile; > 0.
void takeRelief(State& state, const MeshRelief& relief, double metresPerUV);

// A glTF material's factors, clamped to the parameters' ranges. `maps` are the material's: without a colour map its factor is the colour.
void takeFactors(State& state, const MeshFactors& factors, const MapSlots& maps);

// What a height map's own numbers and tags say of its size: the depth of an elevation model, and the midlevel that keeps the zero of signed
// heights on the mesh. Each is told. Nothing is taken from plain maps.
void takeHeightNumbers(State& state, const Image& image, Warnings& warnings);

// relief.json: its plain numbers and the parameters that they are.
inline constexpr auto kReliefNumbers = std::to_array<std::pair<const char*, float Parameters::*>>({
    {"depthInTiles", &Parameters::depth},
    {"midlevel", &Parameters::midlevel},
    {"tiling", &Parameters::tiling},
    {"rotationDegrees", &Parameters::rotation},
    {"normalStrength", &Parameters::normalStrength},
});

// relief.json is in the folder from the first map on, and holds this member until the last one is written.
inline constexpr const char* kUnfinishedExport = "unfinished";
// "export-unfinished" when the export into the folder was ended before all maps were written.
std::optional<Warning> unfinishedExport(const std::filesystem::path& folder);

// What relief.json says in a folder of exported textures: its values, and which way its own maps are meant, whatever their pixels
// suggest. Returns whether there is such a file of this program. Warnings: "relief-json" tells that values
// were taken, "export-unfinished" that they were not.
bool takeReliefJson(const std::filesystem::path& folder, State& state, Warnings& warnings);

} // namespace relievo
