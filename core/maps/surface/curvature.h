// Curvature map: how strongly the relief bends at each texel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/maps/baked_map.h"
#include "core/state/parameters.h"

namespace relievo {

// Mean curvature of the surface z = depth h(u, v), in 1/tile, positive on bumps: with subscripts for derivatives by tiles,
// H = -((1 + zv^2) zuu - 2 zu zv zuv + (1 + zu^2) zvv) / (2 (1 + zu^2 + zv^2)^1.5) (do Carmo 1976, section 3-3), by central differences
// over one texel to each side. Stored as 1/2 + H / (2 (|H| + kCurvatureHalf)): 0.5 is flat, 0 and 1 are only approached (in
// 16 bits they are what |H| of a million and more is rounded to), and +-kCurvatureHalf (a sphere of 1 / 16 tile radius) gives 3/4 and 1/4.
inline constexpr float kCurvatureHalf = 16.f;
BakedMap bakeCurvature(const HeightField& field, const Parameters& parameters, const Progress& progress);

} // namespace relievo
