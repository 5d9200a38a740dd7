// One ray a pixel, looking up the picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/heat_pictures.h"
#include "core/analysis/ray_sets.h"
#include "core/trace/shader_on_cpu.h"
#include <cmath>
#include <numbers>

namespace relievo {

namespace {

std::vector<SearchRay> raysOf(const HeatView& view)
{
    constexpr double kAway = -0.5 * std::numbers::pi; // towards smaller v: the top of the picture is far
    const double foreshortening = std::cos(view.angle * std::numbers::pi / 180.);
    std::vector<SearchRay> rays;
    rays.reserve(std::size_t(view.width) * std::size_t(view.height));
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x)
            rays.push_back(rayAt(glm::dvec2(x + 0.5, (y + 0.5) / foreshortening) / double(view.width), view.angle, kAway, view.depth));
    return rays;
}

void paint(Image& image, double value, double range)
{
    const glm::vec3 color = heatColor(float(value / range));
    for (int c = 0; c < 3; ++c)
        image.data.push_back(std::byte(std::lround(255.f * color[c])));
}

} // namespace

Expected<HeatPictures> heatPictures(
    const SearchSetting& setting, const HeightField& heights, const HeatView& view, const Progress& progress)
{
    const std::vector<SearchRay> rays = raysOf(view);
    Parameters parameters = setting.parameters;
    parameters.depth = float(view.depth);
    const auto hits = traceRays(setting.technique->key, parameters, &heights, atMesh(*setting.technique, rays), progress);
    if (!hits)
        return tl::unexpected(hits.error());
    const auto exact = traceRays("reference", parameters, &heights, rays, progress);
    if (!exact)
        return tl::unexpected(exact.error());
    HeatPictures pictures{
        {view.width, view.height, 3, PixelType::U8, 8, false, {}}, {view.width, view.height, 3, PixelType::U8, 8, false, {}}, 0., 0.};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double error = std::abs(((*hits)[i].found ? (*hits)[i].t : 1.) - (*exact)[i].t);
        paint(pictures.fetches, (*hits)[i].fetches, view.fetchRange);
        paint(pictures.error, error, view.errorRange);
        pictures.meanFetches += (*hits)[i].fetches;
        pictures.meanError += error;
    }
    pictures.meanFetches /= double(rays.size()), pictures.meanError /= double(rays.size());
    return pictures;
}

} // namespace relievo
