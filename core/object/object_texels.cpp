// Bounds of cells, then of four nodes each.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/object_texels.h"
#include <algorithm>
#include <bit>

namespace relievo {

namespace {
void widen(Interval& bounds, const Interval& by)
{
    if (!by.isSolid())
        return;
    if (!bounds.isSolid())
        bounds = by;
    bounds.front = std::min(bounds.front, by.front);
    bounds.back = std::max(bounds.back, by.back);
}

// Of the texels that may say something of the node's cells.
Interval boundsOfCells(const AxisMap& map, int x, int y, int layer)
{
    Interval bounds;
    for (int j = std::max(2 * y - 1, 0); j <= std::min(2 * y + 1, map.height - 1); ++j)
        for (int i = std::max(2 * x - 1, 0); i <= std::min(2 * x + 1, map.width - 1); ++i)
            widen(bounds, map.at(i, j, layer));
    return bounds;
}
} // namespace

ObjectTexels objectTexels(const ReliefObject& object)
{
    ObjectTexels made;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const AxisMap& map = object.axes[axis];
        if (!map.isGiven())
            continue;
        const int top = int(std::bit_width(unsigned(std::max(map.width, map.height))));
        made.axes[axis] = {map.width, map.height, map.layers, top};
        made.levels[axis * ObjectTexels::kLevels] = int(made.texels.size());
        made.texels.insert(made.texels.end(), map.intervals.begin(), map.intervals.end());
        for (int level = 1; level <= top; ++level) {
            const int across = (map.width >> level) + 1, down = (map.height >> level) + 1;
            const int below = made.levels[axis * ObjectTexels::kLevels + std::size_t(level) - 1];
            const int acrossBelow = (map.width >> (level - 1)) + 1, downBelow = (map.height >> (level - 1)) + 1;
            made.levels[axis * ObjectTexels::kLevels + std::size_t(level)] = int(made.texels.size());
            for (int y = 0; y < down; ++y)
                for (int x = 0; x < across; ++x)
                    for (int k = 0; k < map.layers; ++k) {
                        Interval bounds = level == 1 ? boundsOfCells(map, x, y, k) : Interval();
                        for (int j = 2 * y; level > 1 && j <= std::min(2 * y + 1, downBelow - 1); ++j)
                            for (int i = 2 * x; i <= std::min(2 * x + 1, acrossBelow - 1); ++i)
                                widen(bounds, made.texels[std::size_t(below + (j * acrossBelow + i) * map.layers + k)]);
                        made.texels.push_back(bounds);
                    }
        }
    }
    return made;
}

} // namespace relievo
