// Names of glTF extensions that are named in several places, most of them both read and written.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace relievo {

inline constexpr const char* kReliefExtension = "RELIEVO_materials_relief"; // our own
inline constexpr const char* kBumpExtension = "EXT_materials_bump"; // a draft: heights are red, and its factor has no unit
inline constexpr const char* kSpecularGlossinessExtension = "KHR_materials_pbrSpecularGlossiness"; // only read
inline constexpr const char* kDracoExtension = "KHR_draco_mesh_compression"; // only read
inline constexpr const char* kMeshoptExtension = "EXT_meshopt_compression"; // only read
inline constexpr const char* kTransformExtension = "KHR_texture_transform";
inline constexpr const char* kBrighterExtension = "KHR_materials_emissive_strength";

} // namespace relievo
