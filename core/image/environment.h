// Light from all around: an equirectangular picture, prefiltered for rough reflections.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace relievo {

// Level k holds (kEnvironmentWidth >> k) x (half of that) linear RGB radiances, row 0 straight up (+y), u = 0.5 towards -z,
// u growing towards +x. Level 0 is sharp; levels 1 .. kEnvironmentLevels - 2 are what a surface of roughness
// k / (kEnvironmentLevels - 2) reflects; the last level is the irradiance / pi of a matt surface facing that way.
inline constexpr int kEnvironmentWidth = 256;
inline constexpr int kEnvironmentLevels = 6;
struct Environment {
    std::string name;
    std::vector<std::vector<glm::vec3>> levels;
};

// A photographer's studio by formula: a large soft key box above left, a cool fill, a rim strip, a soft grey floor and wall.
// Average radiance about 1. Made at once (under 50 ms).
Environment studioEnvironment();

// nameOrFile: "studio", or an equirectangular .hdr / .exr (or any image).
Expected<Environment> openEnvironment(const std::string& nameOrFile, const Progress& progress = {});

} // namespace relievo
