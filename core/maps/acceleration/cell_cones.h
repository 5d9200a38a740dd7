// Cell cones: for each 2 x 2 bilinear cells, how far a ray above them may leap in any direction without touching the surface.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/maps/baked_map.h"
#include "core/state/parameters.h"

namespace relievo {

// Cells along each side of the four nested nodes that a texel describes: node n of cell (i, j) holds the cells whose indices, divided by
// kCellConeSpans[n] and rounded down, equal those of (i, j), as far as the grid reaches.
inline constexpr int kCellConeSpans[] = {2, 8, 32, 128};

// One level of half the field's size, rounded up: texel (x, y) is that of the cells (2x, 2y) to (2x + 1, 2y + 1). 4 channels U16; channel n
// describes node n: code = 256 c + k.
//   cap   = lowest + c (highest - lowest) / 255          never below any point of the bilinear surface over the node
//   steep = steepest (k / 255)^2                         height per tile (uv): for p over the node and q anywhere,
//                                                         h(q) <= cap + steep |q - p|
// scale = (lowest, highest - lowest, steepest, highest); both bounds hold for what a float decodes (both are rounded up).
// Not clamped: a level field has steep 0. Under repeat q runs over all tiles; under clamp the border texels go on outwards for ever.
// Definition, proof and search: resources/help/cell-cones.md. Stops early when cancelled.
BakedMap bakeCellCones(const HeightField& field, const Parameters& parameters, const Progress& progress);

} // namespace relievo
