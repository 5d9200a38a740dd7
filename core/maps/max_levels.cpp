// Maxima of 2 x 2 nodes, level by level.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/max_levels.h"
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
    for (std::size_t l = 1; l < pyramid.levels.size(); ++l) {
        const MaxLevels::Level fine = pyramid.levels[l - 1], coarse = pyramid.levels[l];
        tbb::parallel_for(0, coarse.height, [&](int j) {
            const float* row0 = pyramid.values.data() + fine.offset + std::size_t(2 * j) * std::size_t(fine.width);
            const float* row1 = 2 * j + 1 < fine.height ? row0 + fine.width : row0;
            float* out = pyramid.values.data() + coarse.offset + std::size_t(j) * std::size_t(coarse.width);
            for (int i = 0; i < coarse.width; ++i) {
                const int a = 2 * i, b = std::min(2 * i + 1, fine.width - 1);
                out[i] = std::max(std::max(row0[a], row0[b]), std::max(row1[a], row1[b]));
            }
        });
    }
}

} // namespace relievo
