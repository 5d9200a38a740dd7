// The relaxed cone's limit by one bilinear cell, in closed form.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"

namespace relievo {

// Policarpo and Oliveira 2007 (GPU Gems 3, chapter 18), exit points. An apex p lies at height `apex` on the surface. A ray that starts
// above it, at (p, height 1), leaves the surface at q exactly where the tangent plane of the surface at q passes above (p, 1).
// For a bilinear cell h = a + b X + c Y + d X Y, with X, Y counted from p, that plane is a - d X Y high at p, so the exit points are
// the part of the cell with a - d X Y > 1; along each ray through p the ratio |q - p| / (h(q) - apex) grows there, so that the
// smallest lies on the near edges or on the hyperbola a - d X Y = 1.
struct RelaxedCell {
    HeightField::Corners corners; // h10 lies one texel farther from the apex in u, h01 in v
    double x, y; // offset of corner h00 from the apex, texels, >= 0
    double du, dv; // size of a texel, tiles
};

// The smallest ratio (tiles per unit of height) of an exit point of the cell, or a value up to 0.1 % below it; infinity without one.
double relaxedRatio(const RelaxedCell& cell, double apex);

} // namespace relievo
