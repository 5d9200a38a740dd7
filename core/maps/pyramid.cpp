// Cell maxima and their pyramid.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/pyramid.h"
#include "core/maps/float_image.h"
#include "core/maps/max_levels.h"
#include <algorithm>
#include <tbb/parallel_for.h>

namespace relievo {

BakedMap bakePyramid(const HeightField& field, const Parameters&, const Progress& progress)
{
    MaxLevels pyramid = makeMaxLevels(field.width(), field.height());
    tbb::parallel_for(0, field.height(), [&](int j) {
        if (progress.cancelled())
            return;
        float* row = pyramid.values.data() + std::size_t(j) * std::size_t(field.width());
        for (int i = 0; i < field.width(); ++i) {
            const HeightField::Corners c = field.corners(i, j);
            row[i] = std::max(std::max(c.h00, c.h10), std::max(c.h01, c.h11));
        }
    });
    finishMaxLevels(pyramid);
    BakedMap map;
    for (const MaxLevels::Level& level : pyramid.levels) {
        Image image = floatImage(level.width, level.height, 1);
        std::copy_n(pyramid.values.begin() + std::ptrdiff_t(level.offset), image.texelCount(), floats(image).begin());
        map.levels.push_back(std::move(image));
    }
    progress.at(1.f);
    return map;
}

} // namespace relievo
