// Maximum mip maps: the highest point of the surface above each square of 2^n cells.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/maps/baked_map.h"
#include "core/state/parameters.h"

namespace relievo {

// Tevs, Ihrke and Seidel 2008, Maximum Mipmaps. Texel (i, j) of level 0 is the highest corner of cell (i, j), which lies between the
// texel centres (i, j) and (i + 1, j + 1): a bound of the bilinear surface there. Each further level holds the maxima of 2 x 2; sizes
// are halved rounding up, down to 1 x 1. Unit: height. Under clamp the last column of cells lies between the last texel and itself.
BakedMap bakePyramid(const HeightField& field, const Parameters& parameters, const Progress& progress);

} // namespace relievo
