// A relief object as shader programs read it: the intervals of its axes and pyramids of bounds over them, in one row of texels.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/relief_object.h"
#include <glm/vec4.hpp>

namespace relievo {

// Level 0 of an axis holds its intervals as AxisMap does. Node (x, y) of level l > 0 is over the cells from x 2^l to (x + 1) 2^l - 1, of
// which there are width + 1 (a cell lies between texel centres; the outermost ones are halves), and holds for each layer the least front
// and the greatest back of what is solid there. Row-major, layers side by side. The topmost level is one node.
struct ObjectTexels {
    static constexpr std::size_t kLevels = 16; // that an axis can have
    std::vector<Interval> texels;
    std::array<glm::ivec4, 3> axes{}; // width, height, layers, topmost level; all 0 where it is not given
    std::array<int, 3 * kLevels> levels{}; // where in `texels` each level of each axis begins
};
ObjectTexels objectTexels(const ReliefObject& object);

} // namespace relievo
