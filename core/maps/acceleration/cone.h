// Cone maps: how wide an empty cone may stand on each texel of a height field.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/maps/baked_map.h"
#include "core/state/parameters.h"

namespace relievo {

// Common to all: one level, the field's size, F32, scale 1. A ratio is the radius of a cone in tiles (uv) per unit of height (0 to 1),
// its apex at the texel centre at its height, its axis upward. Radii are measured in uv whatever the tile's size in texels, so the
// ratios hold for every `depth`. They never exceed the true ones and are at most 8.1 % below (kConeKeep); they end at kWidestCone,
// where no obstacle limits the cone earlier. Under repeat all images of the tile count. When cancelled the result is no map.

// (height, ratio). Dummer 2006, Cone Step Mapping: no texel centre lies above the cone. Not clamped at 1.
BakedMap bakeCone(const HeightField& field, const Parameters& parameters, const Progress& progress);

// Four ratios: towards +u, -u, +v, -v. GPU Gems 3, chapter 18.1 (quad-directional cone step mapping). Each channel covers the sector of
// 90 degrees centred on its axis (in uv; a diagonal belongs to both neighbours): no texel centre of the sector lies above its cone.
BakedMap bakeConeQuad(const HeightField& field, const Parameters& parameters, const Progress& progress);

// (height, ratio). Policarpo and Oliveira 2007 (GPU Gems 3, chapter 18.4): no ray that starts above the apex at height 1 and stays in the
// cone leaves the surface after it entered it. On the bilinear surface and exact, where the chapter samples (relaxed_cell.h).
BakedMap bakeConeRelaxed(const HeightField& field, const Parameters& parameters, const Progress& progress);

// (height, ratio). Ban, Valasek, Balint and Vad 2024, Robust Cone Step Mapping: only texel centres limit the cone behind which some edge
// of the next cell away from the apex falls away from it; then the smallest ratio of 3 x 3 texels.
BakedMap bakeConeRobust(const HeightField& field, const Parameters& parameters, const Progress& progress);

} // namespace relievo
