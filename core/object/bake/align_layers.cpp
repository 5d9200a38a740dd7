// All orders of intervals and gaps, by how far they overlap their neighbours.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/bake/align_layers.h"
#include <algorithm>
#include <bit>
#include <iterator>
#include <span>

namespace relievo {

namespace {
using Texel = std::array<Interval, kMostLayers>;

// By how much two intervals overlap; less than nothing by how far they are apart.
int overlap(const Interval& a, const Interval& b)
{
    return a.isSolid() && b.isSolid() ? int(std::min(a.back, b.back)) - int(std::max(a.front, b.front)) : 0;
}

Texel placed(std::span<const Interval> intervals, int layers, unsigned slots)
{
    Texel texel;
    std::size_t next = 0;
    for (int k = 0; k < layers; ++k)
        if (slots >> k & 1u)
            texel[std::size_t(k)] = intervals[next++];
    return texel;
}

// One texel by two of its neighbours; null where the map ends.
void align(Interval* here, int layers, const Interval* a, const Interval* b)
{
    std::vector<Interval> solid;
    std::copy_if(here, here + layers, std::back_inserter(solid), [](const Interval& i) { return i.isSolid(); });
    if (solid.empty() || int(solid.size()) == layers)
        return;
    const auto fitOf = [&](const Interval* texel) {
        int sum = 0;
        for (int k = 0; k < layers; ++k)
            sum += (a ? overlap(texel[k], a[k]) : 0) + (b ? overlap(texel[k], b[k]) : 0);
        return sum;
    };
    int most = fitOf(here);
    for (unsigned slots = 1; slots < 1u << layers; ++slots) {
        if (std::popcount(slots) != int(solid.size()))
            continue;
        const Texel texel = placed(solid, layers, slots);
        if (const int fit = fitOf(texel.data()); fit > most) {
            most = fit;
            std::copy_n(texel.begin(), layers, here);
        }
    }
}
} // namespace

void alignLayers(AxisMap& map)
{
    if (map.layers == 1)
        return;
    const auto at = [&](int x, int y) -> Interval* {
        const bool isIn = x >= 0 && y >= 0 && x < map.width && y < map.height;
        const std::size_t texel = std::size_t(y) * std::size_t(map.width) + std::size_t(x);
        return isIn ? map.intervals.data() + texel * std::size_t(map.layers) : nullptr;
    };
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            align(at(x, y), map.layers, at(x - 1, y), at(x, y - 1));
    for (int y = map.height - 1; y >= 0; --y)
        for (int x = map.width - 1; x >= 0; --x)
            align(at(x, y), map.layers, at(x + 1, y), at(x, y + 1));
}

} // namespace relievo
