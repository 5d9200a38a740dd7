// Cell maxima and their pyramid.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/acceleration/pyramid.h"
#include "core/maps/acceleration/max_levels.h"
#include "core/maps/float_image.h"
#include <algorithm>
#include <tbb/parallel_for.h>

namespace relievo {

BakedMap bakePyramid(const HeightField& field, const Parameters&, const Progress& progress)
{
    const int width = field.width(), height = field.height();
    BakedMap map = oneLevel(floatImage(width, height, 1));
    const std::span<float> cells = floats(map.levels.front());
    tbb::parallel_for(0, height, [&](int j) {
        if (progress.cancelled())
            return;
        const float* row0 = field.texels().data() + std::size_t(j) * std::size_t(width);
        const float* row1 = field.texels().data() + std::size_t(wrapIndex(j + 1, height, field.wrap())) * std::size_t(width);
        float* out = cells.data() + std::size_t(j) * std::size_t(width);
        const auto highest = [&](int i, int next) { return std::max(std::max(row0[i], row0[next]), std::max(row1[i], row1[next])); };
        for (int i = 0; i < width - 1; ++i)
            out[i] = highest(i, i + 1);
        out[width - 1] = highest(width - 1, wrapIndex(width, width, field.wrap()));
    });
    while (map.levels.back().width > 1 || map.levels.back().height > 1) {
        const Image& fine = map.levels.back();
        Image coarse = floatImage((fine.width + 1) / 2, (fine.height + 1) / 2, 1);
        halveByMaxima(floats(fine), fine.width, fine.height, floats(coarse));
        map.levels.push_back(std::move(coarse));
    }
    progress.at(1.f);
    return map;
}

} // namespace relievo
