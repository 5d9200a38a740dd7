// Where a ray first meets the bilinear surface of one cell, in double precision.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

// 1 / slope, so that t = (wall - start) * inverseSlope(slope) is where a ray crosses a wall; a slope of next to nothing crosses none.
inline double inverseSlope(double slope)
{
    return std::abs(slope) > 1e-300 ? 1. / slope : (slope < 0. ? -1e300 : 1e300);
}

// f(t) = c + b t + a t^2: ray height minus surface height, with t counted from the cell's entry. The smallest root in
// [0, length], or kNever. f(0) <= 0 means that the ray is inside already.
inline double firstRoot(double a, double b, double c, double length)
{
    if (c <= 0.)
        return 0.;
    const auto inCell = [&](double t) { return t >= 0. && t <= length; };
    const double discriminant = b * b - 4. * a * c;
    double root = kNever;
    if (discriminant >= 0.) {
        const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b)); // no cancellation
        if (q != 0. && inCell(c / q))
            root = c / q;
        if (a != 0. && inCell(q / a))
            root = std::min(root, q / a);
    }
    if (root == kNever && c + length * (b + length * a) <= 0.)
        return length; // the root lies within rounding of the wall
    return root;
}

// The ray enters the cell of corners k at (u, v) in [0, 1]^2, at height `above`, moves by (slopeX, slopeY) cells for each unit of t and
// sinks by 1. The t after the entry where it first meets the surface, at most `length`, or kNever.
inline double cellRoot(const HeightField::Corners& k, double u, double v, double slopeX, double slopeY, double above, double length)
{
    const double kx = double(k.h10) - k.h00, ky = double(k.h01) - k.h00, kxy = double(k.h11) - k.h10 - k.h01 + k.h00;
    return firstRoot(-kxy * slopeX * slopeY, -1. - kx * slopeX - ky * slopeY - kxy * (u * slopeY + v * slopeX),
        above - (k.h00 + kx * u + ky * v + kxy * u * v), length);
}

} // namespace relievo
