// Bilinear heights in double precision, independent of the searches that are tested by them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include <cmath>

namespace relievo {

inline double heightAt(const HeightField& field, glm::dvec2 uv)
{
    const double x = uv.x * field.width() - 0.5, y = uv.y * field.height() - 0.5;
    const double fx = x - std::floor(x), fy = y - std::floor(y);
    const auto c = field.corners(int(std::floor(x)), int(std::floor(y)));
    return (c.h00 * (1. - fx) + c.h10 * fx) * (1. - fy) + (c.h01 * (1. - fx) + c.h11 * fx) * fy;
}

} // namespace relievo
