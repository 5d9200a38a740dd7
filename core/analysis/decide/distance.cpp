// Shifts on the screen fall with the distance.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/decide/distance.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo {
namespace {
constexpr int kRays = 2000; // an angle
constexpr std::uint32_t kSeed = 1;

double radians(double degrees)
{
    return degrees * std::numbers::pi / 180.;
}

double parallaxOf(std::span<const SearchHit> exact, double midlevel)
{
    double squares = 0., count = 0.;
    for (const SearchHit& hit : exact)
        if (hit.found) {
            squares += (hit.t - (1. - midlevel)) * (hit.t - (1. - midlevel));
            count += 1.;
        }
    return std::sqrt(squares / std::max(count, 1.));
}

// Shifts fall as 1 / distance.
double distanceOf(std::span<const AngleFigures> figures, double depth, const Lens& lens, double pixels, auto shareOf)
{
    double distance = 0.;
    for (const AngleFigures& at : figures)
        distance = std::max(distance, shiftInPixels(shareOf(at), depth, at.angle, lens, 1.) / pixels);
    return distance;
}
} // namespace

Expected<std::vector<AngleFigures>> figuresByAngle(
    const SearchSetting& setting, const HeightField& heights, double midlevel, const Progress& progress)
{
    std::vector<RaySet> sets;
    for (const double angle : kDistanceAngles)
        sets.push_back({bandRays({angle, angle}, double(setting.parameters.depth), kRays, kSeed)});
    auto sweep = RaySweep::create(heights, std::move(sets), false, progress);
    if (!sweep)
        return tl::unexpected(sweep.error());
    const auto rows = sweep->measure(setting, 0, 0, progress);
    if (!rows)
        return tl::unexpected(rows.error());
    std::vector<AngleFigures> figures;
    for (std::size_t i = 0; i < kDistanceAngles.size(); ++i)
        figures.push_back({kDistanceAngles[i], (*rows)[i].errors, parallaxOf(sweep->exact()[i], midlevel)});
    return figures;
}

double Lens::pixels(double metres, double distance) const
{
    return metres * height / (2. * distance * std::tan(0.5 * radians(fov)));
}

double shiftInPixels(double share, double depth, double angle, const Lens& lens, double distance)
{
    return lens.pixels(share * depth * std::sin(radians(angle)), distance);
}

double distanceOfParallax(std::span<const AngleFigures> figures, double depth, const Lens& lens, double pixels)
{
    return distanceOf(figures, depth, lens, pixels, [](const AngleFigures& at) { return at.parallax; });
}

double distanceOfErrors(std::span<const AngleFigures> figures, double depth, const Lens& lens, double pixels)
{
    return distanceOf(figures, depth, lens, pixels, [](const AngleFigures& at) { return at.errors.rmse; });
}

} // namespace relievo
