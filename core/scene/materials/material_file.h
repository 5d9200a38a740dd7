// Materials as engines keep them, opened: Godot, Unity, Babylon.js, PlayCanvas, O3DE and MaterialX.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/state/state.h"
#include <filesystem>
#include <string>

namespace relievo {

// By its suffix: tres mat material mtlx json babylon.
bool isMaterialFile(const std::filesystem::path& file);

// `base` with the material's maps, the depth that its engine would draw, where zero and deep are, placement, steps and factors. Its
// technique stays. Warnings name pictures that were not found ("map-missing") and say what is not known ("depth-in-metres": no size of a
// UV unit is told, so it is taken as the parameter metresPerUV, or 1 m). Errors: unreadable, no such material, no picture in it.
struct MaterialRead {
    State state;
    Warnings warnings;
};
Expected<MaterialRead> readMaterialFile(const std::filesystem::path& file, const State& base);

} // namespace relievo
