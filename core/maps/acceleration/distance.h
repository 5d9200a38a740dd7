// Distance volume for sphere tracing: how far each point of the slab is from the relief.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/maps/baked_map.h"
#include "core/state/parameters.h"

namespace relievo {

inline constexpr int kDistanceSize = 128; // most texels a side of the volume
inline constexpr int kDistanceSlices = 32;
// Tiles that one unit of height (or of t) counts in the metric. Any value is right for every `depth`; this one makes voxels of 128 x 128
// x 32 cubes, so that a step is as long sideways as down.
inline constexpr float kDistanceHeightScale = 0.25f;

// Donnelly 2005 (GPU Gems 2, chapter 8). Distance from (u, v, t) to the solid below the bilinear surface, in tiles, in the metric
// dist^2 = du^2 + dv^2 + (kDistanceHeightScale dt)^2; 0 inside. A ray uv + t duv may step by
// dt = distance / sqrt(|duv|^2 + kDistanceHeightScale^2) whatever the State's depth, which is inside duv: no rebake.
// The volume has min(W, 128) x min(H, 128) x 32 voxels, centres at (i + 0.5) / size; slice k, t = (k + 0.5) / 32, first slice nearest the
// top. A voxel holds the distance from its centre, never above the true one: columns of half a voxel are as high as their highest point.
// Between centres an interpolation may exceed the true distance, by at most half the diagonal of a voxel (distances grow no faster than
// the way to a centre, and the mean of the ways to the eight is at most that): Donnelly's steps ignore that, `safeBalls` subtracts it.
// Exact Euclidean transform by lower envelopes of parabolas (Felzenszwalb and Huttenlocher 2012), linear in the voxels.
BakedMap bakeDistance(const HeightField& field, const Parameters& parameters, const Progress& progress);

} // namespace relievo
