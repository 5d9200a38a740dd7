// Opening what the user named: projects, texture sets, images, meshes with textures, and what is made by formula.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/sets/texture_set.h"
#include "core/state/state.h"
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace relievo {

// SOURCE (resources/help/command-line.md, "Sources"): "*.relievo", a folder, an image of a set, a single image, "sample:KEY", "scene:KEY"
// (presets.h), "hard:KEY" (hard_cases.h), a mesh file that brings textures, NAME.object.json, or an engine's material
// (materials/material_file.h). The result is `base` with the maps (and for a project everything) replaced. A sample also sets its depth.
struct Opened {
    State state;
    DecodedImages images; // spares loadResources a second decode
    Warnings warnings;
    bool bringsValues = false; // parameters and technique of the State are the file's too, not only the maps
    EnumSet<MapKind> coming = {}; // of a texture set that is told early: maps whose files are still being read
};
using EarlyOpened = std::function<void(const Opened&)>; // hears of a texture set while it is being read, as EarlySet does
Expected<Opened> openSource(const std::string& source, const State& base, const Progress& progress = {}, const EarlyOpened& told = {});

// Whether SOURCE names something made by formula: there is no file behind it.
bool isBuiltInSource(std::string_view source);

// Whether `file` is a mesh by its suffix (gltf glb obj ply stl off object.json), for drag and drop and `info`.
bool isMeshFile(const std::filesystem::path& file);
bool isProjectFile(const std::filesystem::path& file);

} // namespace relievo
