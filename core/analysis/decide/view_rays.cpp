// From a pane's camera to search rays.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/decide/view_rays.h"
#include "core/scene/picked_ray.h"
#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

namespace relievo {

// A depth that is off by dt shows the texture of a point that lies D dt tan(angle) away on the surface, seen at cos(angle).
RaySet viewRays(const State& state, std::size_t pane, const Resources& resources, const ViewGrid& grid, const Progress& progress)
{
    State exact = state;
    exact.panes[pane].technique = mostExactSetting(effectiveParameters(state, pane)).technique->key;
    const double pixelAtOneMetre = 2. * std::tan(0.5 * glm::radians(double(cameraOf(state, pane).fov))) / grid.height;
    RaySet set;
    for (const auto& picked : pickedRays(exact, pane, resources, grid.pixels, grid.aspect, progress)) {
        if (!picked || picked->isPlain)
            continue;
        const SearchRay& ray = picked->ray;
        set.rays.push_back({glm::dvec2(glm::vec2(ray.uv)), glm::dvec2(glm::vec2(ray.duv)), double(float(ray.cosView))});
        const double sine = std::sqrt(std::max(0., 1. - ray.cosView * ray.cosView));
        set.pixels.push_back(picked->depth * sine / (picked->distance * pixelAtOneMetre));
    }
    return set;
}

HeightField reducedTo(const HeightField& field, int side)
{
    if (std::max(field.width(), field.height()) <= side)
        return field;
    const std::vector<HeightField> levels = heightLevels(field);
    const auto small = std::ranges::find_if(levels, [side](const HeightField& f) { return std::max(f.width(), f.height()) <= side; });
    return small == levels.end() ? levels.back() : *small;
}

} // namespace relievo
