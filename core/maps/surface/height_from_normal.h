// A height map from a normal map alone.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/image/image.h"
#include "core/maps/baked_map.h"

namespace relievo {

// The surface whose slopes are nearest to those of the normals in the sense of least squares (Frankot and Chellappa 1988), with the
// slopes taken as central differences, as normalFromHeight makes them; by Fourier transform, or by sine and cosine transforms under
// clamp (the surface is mirrored at its borders). Detail finer than four texels, which central differences nearly miss, is damped.
// normals: 3 channels, n / 2 + 1/2, OpenGL style; slopes above 32 are cut there, values that are no number count as flat, and so do
// x and y within one step of the middle in 8 and 16 bits, where no code is exactly 0.
// Heights fill [0, 1]; depthInTiles: the distance from 0 to 1 that gives the normals their strength (0 and all heights 1 for flat ones).
// Stops early when cancelled.
HeightField heightFromNormals(const Image& normals, Wrap wrap, float& depthInTiles, const Progress& progress = {});

// The row of kBakedMaps: one channel.
BakedMap bakeHeightFromNormals(const Image& normals, Wrap wrap, float& depthInTiles, const Progress& progress);

} // namespace relievo
