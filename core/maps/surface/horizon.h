// Horizon maps and sky visibility: how high the relief stands around each texel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/maps/baked_map.h"
#include "core/state/parameters.h"
#include <vector>

namespace relievo {

// Sine of the horizon's elevation over the polygon at each texel centre, in [0, 1], towards azimuth `index` of `count`: the direction
// (cos, sin)(2 pi index / count) in uv (v down), at the State's `depth` (tiles from height 0 to 1):
// tan(elevation) = max over s of depth (h(p + s d) - h(p)) / s, at least 0. The surface is read where the direction crosses lines of
// texels (rows, or columns where those are nearer to it), at least one tile ahead. Scan lines lie a texel apart: those along the axes, and
// along the diagonals of square tiles, pass through the texel centres; elsewhere the horizons of the two nearest lines are interpolated.
// One upper hull a scan line, searched by bisection: Timonen and Westerholm 2010, Scalable Height Field Self-Shadowing.
std::vector<float> horizonSines(const HeightField& field, float depthInTiles, int index, int count, const Progress& progress = {});

// The same as a slope: heights per tile, at least 0; the tangent is the depth times that.
std::vector<float> horizonSlopes(const HeightField& field, int index, int count, const Progress& progress = {});

// 8 or 16 azimuths: F32, four channels, 2 or 4 slices one below the other; azimuth 4 s + c stands in channel c of slice s.
BakedMap bakeHorizon8(const HeightField& field, const Parameters& parameters, const Progress& progress);
BakedMap bakeHorizon16(const HeightField& field, const Parameters& parameters, const Progress& progress);

// The same of slopes s, which know no depth, as s / (s + kHalfSlope): in [0, 1), and nearly linear in the distance to a wall.
inline constexpr float kHalfSlope = 8.f; // heights per tile; shaders/horizon/horizons.glsl has it too
BakedMap bakeHorizonSlopes8(const HeightField& field, const Parameters& parameters, const Progress& progress);
BakedMap bakeHorizonSlopes16(const HeightField& field, const Parameters& parameters, const Progress& progress);

// Ambient occlusion, 1 = open: the cosine-weighted share of the sky that a texel sees above its horizons,
// mean of 1 - sine^2 over 16 azimuths (Max 1988, horizon mapping). One channel.
BakedMap bakeAo(const HeightField& field, const Parameters& parameters, const Progress& progress);

} // namespace relievo
