// What rough and matt surfaces reflect of an environment.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/environment/cube.h"

namespace relievo {

// Sides of level 0: a power of two.
inline constexpr int kLeastEnvironmentSide = 64, kMostEnvironmentSide = 512;

// Level 0 is sharp. Each level has half the side of the one before it. The last but one, of 16 texels a side, is what a surface of
// roughness 1 reflects; the last, of 8, the irradiance / pi of a matt surface. Levels between are of the roughnesses of roughnessOfLevel.
// shaders/shading/environment.glsl reads them so.
int levelCount(int side);
float roughnessOfLevel(int level, int side); // of all but the last

// All levels. Rough reflections have view and normal along the lobe (Karis 2013, Real Shading in Unreal Engine 4, "Pre-Filtered Environment
// Map"), by importance sampling from levels as coarse as the samples are far apart (Krivanek and Colbert 2008, Real-time Shading with
// Filtered Importance Sampling).
std::vector<Cube> prefiltered(Cube sharp);

} // namespace relievo
