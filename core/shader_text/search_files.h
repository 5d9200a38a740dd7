// The shader files that a search reads its maps by.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/shader_text/assembly.h"
#include "core/state/techniques.h"

namespace relievo {

// What reads the maps of a search, by how textures hold them. "": nothing does.
struct Readers {
    std::string_view filtered, volume, corners = "heights/heights_corners.glsl", codes = "bounds/codes_texels.glsl",
                                       nodes = "bounds/node_texels.glsl";
};
inline constexpr Readers kFiltered = {"bounds/bounds_filtered.glsl", "bounds/volume_filtered.glsl"};
inline constexpr Readers kExact = {"bounds/bounds_exact.glsl", "bounds/volume_exact.glsl"};
inline constexpr Readers kExactEs = {"bounds/bounds_exact.glsl", "bounds/volume_exact.glsl", "heights/heights_corners_texels.glsl"};
inline constexpr Readers kPlanes
    = {"bounds/bounds_planes.glsl", "", "heights/corners_planes.glsl", "bounds/codes_planes.glsl", "bounds/node_texels_planes.glsl"};
inline constexpr Readers kGodot = {"bounds/bounds_filtered.glsl", "", "heights/corners_planes.glsl", "bounds/codes_planes.glsl"};

// What the technique reads its acceleration map by.
void accelerationFiles(Assembly& part, const TechniqueRow& technique, const Readers& readers);

// Heights and acceleration maps of the finest level, interpolated by the text.
void exactFiles(Assembly& part, const TechniqueRow& technique, const Readers& readers, std::string_view edges, std::string_view bend);

} // namespace relievo
