// A pyramid of maxima over a grid, finest level first, sizes halved by rounding up.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace relievo {

// Node (i, j) of level l covers the items [i * 2^l, (i + 1) * 2^l) x [j * 2^l, (j + 1) * 2^l) of the grid, as far as it reaches.
struct MaxLevels {
    struct Level {
        int width, height;
        std::size_t offset; // of its first node in `values`
    };
    std::vector<Level> levels; // the last one is 1 x 1
    std::vector<float> values; // all levels, each row by row

    float at(int level, int i, int j) const
    {
        const Level& l = levels[std::size_t(level)];
        return values[l.offset + std::size_t(j) * std::size_t(l.width) + std::size_t(i)];
    }
    int top() const { return int(levels.size()) - 1; }
};

// Room for a grid of width x height (both >= 1) and its pyramid; level 0 is to be filled, then finishMaxLevels computes the rest.
MaxLevels makeMaxLevels(int width, int height);
void finishMaxLevels(MaxLevels& pyramid);

// One level from the one before it, row by row: the maxima of 2 x 2 of width x height nodes, (width + 1) / 2 x (height + 1) / 2 of them.
void halveByMaxima(std::span<const float> nodes, int width, int height, std::span<float> halved);

} // namespace relievo
