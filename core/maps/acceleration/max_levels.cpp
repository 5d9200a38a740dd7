// Maxima of 2 x 2 nodes, level by level.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/acceleration/max_levels.h"
#include <algorithm>
#include <tbb/parallel_for.h>

namespace relievo {

MaxLevels makeMaxLevels(int width, int height)
{
    MaxLevels pyramid;
    std::size_t size = 0;
    for (;; width = (width + 1) / 2, height = (height + 1) / 2) {
        pyramid.levels.push_back({width, height, size});
        size += std::size_t(width) * std::size_t(height);
        if (width == 1 && height == 1)
            break;
    }
    pyramid.values.resize(size);
    return pyramid;
}

void finishMaxLevels(MaxLevels& pyramid)
{
    const std::span<float> values = pyramid.values;
    for (std::size_t l = 1; l < pyramid.levels.size(); ++l) {
        const MaxLevels::Level& fine = pyramid.levels[l - 1];
        halveByMaxima(values.subspan(fine.offset), fine.width, fine.height, values.subspan(pyramid.levels[l].offset));
    }
}

void halveByMaxima(std::span<const float> nodes, int width, int height, std::span<float> halved)
{
    const int columns = (width + 1) / 2;
    tbb::parallel_for(0, (height + 1) / 2, [&](int j) {
        const float* row0 = nodes.data() + std::size_t(2 * j) * std::size_t(width);
        const float* row1 = 2 * j + 1 < height ? row0 + width : row0;
        float* out = halved.data() + std::size_t(j) * std::size_t(columns);
        for (int i = 0; i < columns; ++i) {
            const int a = 2 * i, b = std::min(2 * i + 1, width - 1);
            out[i] = std::max(std::max(row0[a], row0[b]), std::max(row1[a], row1[b]));
        }
    });
}

} // namespace relievo
