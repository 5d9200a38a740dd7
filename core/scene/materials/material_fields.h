// What a material file of an engine says, flattened, and the readers of each format.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace relievo {

// Values by the engine's own names of properties: "heightmap_scale" is "4", members and list entries follow a dot ("uv1_scale.0",
// "_Color.r"). A texture's value is its file as the material names it. "$type" and "$name" are the material's own.
using MaterialFields = std::map<std::string, std::string, std::less<>>;

// Godot's text resources. $type: "StandardMaterial3D", "ORMMaterial3D", "SpatialMaterial".
Expected<MaterialFields> readGodotMaterial(std::string_view text, const std::filesystem::path& file);
// Unity's materials, which are YAML; textures are found by the .meta files around. $type: the shader's GUID, or its fileID where it is
// built in.
Expected<MaterialFields> readUnityMaterial(std::string_view text, const std::filesystem::path& file);
// Babylon.js (a serialised material, or the first of a scene's that has a height map), PlayCanvas (a material asset or its data) and O3DE
// (.material). $type: "babylon", "playcanvas", "o3de".
Expected<MaterialFields> readJsonMaterial(std::string_view text, const std::filesystem::path& file);
// MaterialX 1.38 and 1.39. Inputs of the first surface shader and displacement by name; what nodes on the way to the picture do stands
// beside: "base_color.times.0", "displacement.minus", "place.tiling", "place.turn", "place.offset.0", "place.wrap". $type: "materialx".
Expected<MaterialFields> readMaterialX(std::string_view text, const std::filesystem::path& file);

} // namespace relievo
