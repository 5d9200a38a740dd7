// Mean curvature by central differences.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/surface/curvature.h"
#include "core/maps/float_image.h"
#include <atomic>
#include <cmath>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {
double meanCurvature(const HeightField& field, double depth, int x, int y)
{
    const auto z = [&](int dx, int dy) { return depth * double(field.texel(x + dx, y + dy)); };
    const double u = field.width(), v = field.height(); // texels a tile
    const double zu = (z(1, 0) - z(-1, 0)) * u / 2., zv = (z(0, 1) - z(0, -1)) * v / 2.;
    const double zuu = (z(1, 0) - 2. * z(0, 0) + z(-1, 0)) * u * u, zvv = (z(0, 1) - 2. * z(0, 0) + z(0, -1)) * v * v;
    const double zuv = (z(1, 1) - z(-1, 1) - z(1, -1) + z(-1, -1)) * u * v / 4.;
    return -((1. + zv * zv) * zuu - 2. * zu * zv * zuv + (1. + zu * zu) * zvv) / (2. * std::pow(1. + zu * zu + zv * zv, 1.5));
}
} // namespace

BakedMap bakeCurvature(const HeightField& field, const Parameters& parameters, const Progress& progress)
{
    BakedMap map = oneLevel(floatImage(field.width(), field.height(), 1));
    std::atomic<int> done = 0;
    tbb::parallel_for(0, field.height(), [&](int y) {
        if (progress.cancelled())
            return;
        float* row = floats(map.levels[0]).data() + std::size_t(y) * std::size_t(field.width());
        for (int x = 0; x < field.width(); ++x) {
            const double curvature = meanCurvature(field, double(parameters.depth), x, y);
            row[x] = float(0.5 + 0.5 * curvature / (std::abs(curvature) + double(kCurvatureHalf)));
        }
        progress.at(float(++done) / float(field.height()));
    });
    return map;
}

} // namespace relievo
