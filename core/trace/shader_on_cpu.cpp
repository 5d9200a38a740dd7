// GLSL on the CPU: each technique's file is included in the body of a struct whose members are the uniforms and samplers.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/shader_on_cpu.h"
#include "core/maps/maps.h"
#include "core/state/techniques.h"
#include "core/trace/exact_search.h"
#include "core/trace/machine.h"
#include "core/trace/recorded_steps.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace relievo::glsl {
#define RELIEVO_TECHNIQUE_BEGIN(file, name) struct Technique_##name : Machine {
#define RELIEVO_TECHNIQUE_END(file, name)                                                                                                  \
    }                                                                                                                                      \
    ;
#include "cpu_techniques.inc"
#undef RELIEVO_TECHNIQUE_BEGIN
#undef RELIEVO_TECHNIQUE_END

struct ExactWalk : Machine {
#include "shaders/search/exact_walk.glsl"
};
struct Heat {
#include "shaders/output/heat.glsl"
};
} // namespace relievo::glsl

namespace relievo {

namespace {

struct SearchRow {
    std::string_view file;
    TextSearch search;
};

template <class Technique>
CountedHit run(const Parameters& parameters, const SearchMaps& maps, glsl::Ray ray, glsl::vec3 bend, StepRecorder* recorder)
{
    Technique technique;
    static_cast<Parameters&>(technique) = parameters;
    technique.curve = bend;
    technique.recorder = recorder;
    technique.boundMap = maps.acceleration.get();
    if (maps.acceleration) {
        const Image& image = maps.acceleration->levels.front();
        technique.boundBytes = image.channels * int(bytesOf(image.type));
    }
    if (maps.height) {
        technique.heightBytes = maps.height->storedBits() <= 16 ? 2 : 4;
        technique.heightMap = &*maps.height;
        technique.wrap = maps.height->wrap();
    }
    const glsl::Hit hit = technique.trace(ray);
    return {hit, technique.bytes, technique.gaveUp};
}

// The generated list again, now as a table.
const SearchRow kSearches[] = {
#define RELIEVO_TECHNIQUE_ROW(file, name) {file, run<glsl::Technique_##name>},
#include "cpu_techniques_rows.inc"
#undef RELIEVO_TECHNIQUE_ROW
};

SearchHit searched(
    TextSearch search, const Parameters& parameters, const SearchMaps& maps, const SearchRay& ray, StepRecorder* recorder = nullptr)
{
    if (!isFiniteInFloat(ray))
        return {};
    const auto [hit, bytes, gaveUp]
        = search(parameters, maps, {inFloat(ray.uv), inFloat(ray.duv), float(ray.cosView), float(ray.end)}, glm::vec3(ray.bend), recorder);
    if (gaveUp)
        return unfinished(ray, hit.fetches, bytes);
    return {hit.found, hit.t, glm::dvec2(hit.uv), hit.fetches, bytes};
}

struct Search {
    TextSearch text = nullptr;
    std::optional<ExactSearch> exact = {}; // of the reference, which has no text
};
Expected<Search> searchOf(std::string_view key, const SearchMaps& maps)
{
    const TechniqueRow* row = findTechnique(key);
    if (!row)
        return failure(ErrorCode::NotFound, std::string(key), "there is no such technique", "relievo describe techniques lists them");
    if (row->isOfObjects)
        return failure(std::string(key), "this technique searches relief objects, not height maps", "Take another one");
    if ((!maps.height && row->needsHeights()) || (!maps.acceleration && !row->accelerationMap.empty()))
        return failure(std::string(key), "this technique needs maps that are not there", "Make them by searchMaps");
    if (row->key == "reference")
        return Search{nullptr, ExactSearch(*maps.height)};
    const TextSearch text = textSearch(row->file);
    if (!text)
        return failure(std::string(key), "this technique has no shader text", "Reinstall Relievo");
    return Search{text};
}

} // namespace

TextSearch textSearch(std::string_view file)
{
    const auto found = std::ranges::find(kSearches, file, &SearchRow::file);
    return found == std::end(kSearches) ? nullptr : found->search;
}

Expected<SearchMaps> searchMaps(std::string_view key, const Parameters& parameters, const HeightField* field, const Progress& progress)
{
    const TechniqueRow* row = findTechnique(key);
    if (!row)
        return failure(ErrorCode::NotFound, std::string(key), "there is no such technique", "relievo describe techniques lists them");
    if (!field && row->needsHeights())
        return failure(std::string(key), "this technique needs a height map and there is none", "Add one, or use flat or bump");
    SearchMaps maps;
    if (field)
        maps.height = *field;
    if (row->accelerationMap.empty())
        return maps;
    auto bound = makeAccelerationMap(row->accelerationMap, *field, parameters, false, progress);
    if (!bound)
        return tl::unexpected(bound.error());
    maps.acceleration = std::move(*bound);
    return maps;
}

Expected<std::vector<SearchHit>> traceRays(
    std::string_view key, const Parameters& parameters, const HeightField* field, std::span<const SearchRay> rays, const Progress& progress)
{
    const auto maps = searchMaps(key, parameters, field, progress);
    if (!maps)
        return tl::unexpected(maps.error());
    return traceRays(key, parameters, *maps, rays, progress);
}

Expected<std::vector<SearchHit>> traceRays(
    std::string_view key, const Parameters& parameters, const SearchMaps& maps, std::span<const SearchRay> rays, const Progress& progress)
{
    const auto technique = searchOf(key, maps);
    if (!technique)
        return tl::unexpected(technique.error());
    std::vector<SearchHit> hits(rays.size());
    std::atomic<std::size_t> done = 0;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), 256), [&](const auto& range) {
        if (progress.cancelled())
            return;
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            hits[i] = technique->exact ? technique->exact->hit(rays[i]) : searched(technique->text, parameters, maps, rays[i]);
        progress.at(float(done += range.size()) / float(rays.size()));
    });
    if (progress.cancelled())
        return cancelled(std::string(key));
    return hits;
}

Expected<RecordedSearch> recordSearch(std::string_view key, const Parameters& parameters, const SearchMaps& maps, const SearchRay& ray)
{
    const auto technique = searchOf(key, maps);
    if (!technique)
        return tl::unexpected(technique.error());
    StepRecorder recorder(ray);
    RecordedSearch recorded;
    if (technique->exact) {
        recorded.hit = technique->exact->hit(ray);
        recorder.step(StepKind::Cell, float(recorded.hit.t), recorded.hit.fetches);
    } else {
        recorded.hit = searched(technique->text, parameters, maps, ray, &recorder);
    }
    recorded.steps = std::move(recorder).finish(recorded.hit, maps.height ? &*maps.height : nullptr);
    return recorded;
}

float exactDepthInFloat(const HeightField& field, const SearchRay& ray)
{
    glsl::ExactWalk walk;
    walk.heightMap = &field;
    return walk.exactDepth({glm::vec2(ray.uv), glm::vec2(ray.duv), float(ray.cosView), 1.f});
}

glm::vec3 heatColor(float x)
{
    return glsl::Heat().heat(x);
}

} // namespace relievo
