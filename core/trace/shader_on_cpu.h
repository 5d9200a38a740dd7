// The text of the techniques' shader files, run on the CPU: the same search as the GPU's, with every fetch counted.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/maps/acceleration/acceleration_map.h"
#include "core/state/parameters.h"
#include "core/trace/ray.h"
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace relievo {

// What a search reads: the height field (its wrap mode counts) and the acceleration map of its technique's row.
struct SearchMaps {
    std::optional<HeightField> height;
    std::shared_ptr<const AccelerationMap> acceleration;
};
// The maps of technique `key` on a field, baked or from the cache. `field` may be null for techniques whose row names no maps.
// Errors: unknown technique, a height map that is wanted and missing, those of the bake.
Expected<SearchMaps> searchMaps(
    std::string_view key, const Parameters& parameters, const HeightField* field, const Progress& progress = {});

// Runs technique `key` (a row of kTechniques; "reference" is ExactSearch) on each ray, on all threads of TBB, on the base level.
// A ray that is not finite gives {false, 1, (0, 0), 0} (resources/help/command-line.md, "Rays and hits"); a miss gives uv + duv.
// Errors: unknown technique, maps that are wanted and missing, cancelled.
Expected<std::vector<SearchHit>> traceRays(std::string_view key, const Parameters& parameters, const SearchMaps& maps,
    std::span<const SearchRay> rays, const Progress& progress = {});
// The same with the maps made first.
Expected<std::vector<SearchHit>> traceRays(std::string_view key, const Parameters& parameters, const HeightField* field,
    std::span<const SearchRay> rays, const Progress& progress = {});

// The float text of the error view's exact walk (shaders/search/exact_walk.glsl), for its test against exactHit.
float exactDepthInFloat(const HeightField& field, const SearchRay& ray);

// The heat map of shaders/output/heat.glsl: colour (display values) of x in [0, 1]. For legends.
glm::vec3 heatColor(float x);

} // namespace relievo
