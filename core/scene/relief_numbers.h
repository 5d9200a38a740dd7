// Numbers beside the maps that files carry, taken into a State.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include "core/mesh/mesh.h"
#include "core/state/state.h"
#include <array>
#include <filesystem>
#include <utility>

namespace relievo {

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

// What relief.json says in a folder of exported textures: its values, and which way its own maps are meant, whatever their pixels
// suggest. Returns whether there is such a file of this program. Warnings: "relief-json" tells that values were taken.
bool takeReliefJson(const std::filesystem::path& folder, State& state, Warnings& warnings);

} // namespace relievo
