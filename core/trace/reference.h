// The exact first hit of a ray with the bilinear surface of a height field, in double precision: what everything is measured against.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include "core/trace/ray.h"

namespace relievo {

// Smallest t in [0, 1] with 1 - h(uv(t)) <= t. There always is one: at t = 1 every point lies at or below the surface.
// Walks the cells between texel centres in order (Amanatides and Woo 1987); in each the surface along the ray is a quadratic,
// solved in closed form. A ray that is not finite: {false, 1, (0, 0), 0}.
// Beyond clamped borders a ray is in one cell that goes on without end. Where the tile repeats, at most kMaxReferenceCells cells are
// visited; a ray that crosses more (a lateral travel of millions of texels) ends there unfinished: {false, 1, uv + duv, cells}.
// raise: the surface is that much higher everywhere (it may leave [0, 1]); where it is lowered, a ray that meets nothing ends at t = 1.
inline constexpr int kMaxReferenceCells = 1 << 22;
SearchHit exactHit(const HeightField& field, const SearchRay& ray, double raise = 0.);

} // namespace relievo
