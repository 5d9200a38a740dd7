// GLSL on the CPU: each technique's file is included in the body of a struct whose members are the uniforms and samplers.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/shader_on_cpu.h"
#include "core/maps/maps.h"
#include "core/state/techniques.h"
#include "core/trace/exact_search.h"
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
using namespace glm;

struct Ray {
    vec2 uv, duv;
    float cosView, end;
};
struct Hit {
    vec2 uv;
    float t;
    bool found;
    int fetches;
};

// What heights/heights_exact.glsl, bounds/bounds_exact.glsl and the generated declarations are on the GPU.
struct Machine : Parameters {
    const HeightField* heightMap = nullptr;
    const AccelerationMap* boundMap = nullptr;
    int heightBytes = 0, boundBytes = 0; // of a texel as it is uploaded
    mutable int bytes = 0; // fetched so far
    bool gaveUp = false; // as in shaders/search/contract.glsl

    static ivec2 textureSize(const HeightField* map, int) { return {map->width(), map->height()}; }
    bool clamped() const { return wrap == Wrap::Clamp; }
    static int searchLevel() { return 0; }
    vec2 searchSize() const { return vec2(boundSize()); }
    ivec2 boundSize() const { return textureSize(heightMap, 0); }
    float heightAt(vec2 uv) const
    {
        bytes += heightBytes;
        return heightMap->at(uv);
    }
#include "shaders/search/bend_quadric.glsl"
#include "shaders/search/height_on.glsl"
    vec4 cornersAt(vec2 cell) const
    {
        bytes += 4 * heightBytes;
        const HeightField::Corners c = heightMap->corners(int(cell.x), int(cell.y));
        return {c.h00, c.h10, c.h01, c.h11};
    }

    vec4 boundScale() const
    {
        return boundMap->scales.front();
    }
    float boundTexel(ivec2 texel) const
    {
        bytes += boundBytes;
        return boundMap->levels.front().value(texel.x, texel.y, 0);
    }
    uvec4 cellCodes(ivec2 node) const
    {
        bytes += boundBytes;
        std::uint16_t codes[4];
        const Image& image = boundMap->levels.front();
        std::memcpy(
            codes, image.data.data() + (std::size_t(node.y) * std::size_t(image.width) + std::size_t(node.x)) * sizeof codes, sizeof codes);
        return {codes[0], codes[1], codes[2], codes[3]};
    }
    vec4 boundAt(vec2 uv) const
    {
        bytes += boundBytes;
        const Image& image = boundMap->levels.front();
        const Bilinear at(uv, {image.width, image.height}, heightMap->wrap());
        vec4 value(0.f);
        for (int c = 0; c < image.channels; ++c)
            value[c] = at.of([&](ivec2 texel) { return image.value(texel.x, texel.y, c); });
        return value;
    }
    vec3 volumeVoxels() const
    {
        const Image& image = boundMap->levels.front();
        return {float(image.width), float(image.height / boundMap->slices), float(boundMap->slices)};
    }
    float distanceAt(vec3 at) const
    {
        bytes += boundBytes;
        const Image& image = boundMap->levels.front();
        const int rows = image.height / boundMap->slices;
        const Bilinear place({at.x, at.y}, {image.width, rows}, heightMap->wrap());
        const float row = clamp(at.z * float(boundMap->slices) - 0.5f, 0.f, float(boundMap->slices - 1));
        const int slice = int(row), next = std::min(slice + 1, boundMap->slices - 1);
        const float above = place.of([&](ivec2 texel) { return image.value(texel.x, texel.y + rows * slice, 0); });
        const float below = place.of([&](ivec2 texel) { return image.value(texel.x, texel.y + rows * next, 0); });
        return above + (below - above) * (row - float(slice));
    }

private:
    // As bounds/bounds_exact.glsl, operation by operation.
    struct Bilinear {
        ivec2 low, high;
        vec2 f;
        Bilinear(vec2 uv, ivec2 size, Wrap wrap)
        {
            vec2 p = uv * vec2(size) - 0.5f;
            p = vec2(abs(p.x) < 1e30f ? p.x : 0.f, abs(p.y) < 1e30f ? p.y : 0.f);
            const vec2 whole = floor(p);
            f = p - whole;
            const auto index = [&](float at, int n) { return wrapIndex(int(clamp(at, -1e9f, 1e9f)), n, wrap); };
            low = {index(whole.x, size.x), index(whole.y, size.y)};
            high = {index(whole.x + 1.f, size.x), index(whole.y + 1.f, size.y)};
        }
        template <class Value> float of(Value value) const
        {
            const float top = value(low) * (1.f - f.x) + value({high.x, low.y}) * f.x;
            const float bottom = value({low.x, high.y}) * (1.f - f.x) + value(high) * f.x;
            return top * (1.f - f.y) + bottom * f.y;
        }
    };
};

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

struct CountedHit {
    glsl::Hit hit;
    int bytes;
    bool gaveUp;
};
using Search = CountedHit (*)(const Parameters&, const SearchMaps&, glsl::Ray, glsl::vec3);
struct SearchRow {
    std::string_view file;
    Search search;
};

template <class Technique> CountedHit run(const Parameters& parameters, const SearchMaps& maps, glsl::Ray ray, glsl::vec3 bend)
{
    Technique technique;
    static_cast<Parameters&>(technique) = parameters;
    technique.curve = bend;
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

SearchHit searched(Search search, const Parameters& parameters, const SearchMaps& maps, const SearchRay& ray)
{
    if (!isFiniteInFloat(ray))
        return {};
    const auto [hit, bytes, gaveUp]
        = search(parameters, maps, {inFloat(ray.uv), inFloat(ray.duv), float(ray.cosView), 1.f}, glm::vec3(ray.bend));
    if (gaveUp)
        return unfinished(ray, hit.fetches, bytes);
    return {hit.found, hit.t, glm::dvec2(hit.uv), hit.fetches, bytes};
}

} // namespace

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
    const TechniqueRow* row = findTechnique(key);
    if (!row)
        return failure(ErrorCode::NotFound, std::string(key), "there is no such technique", "relievo describe techniques lists them");
    const HeightField* field = maps.height ? &*maps.height : nullptr;
    if ((!field && row->needsHeights()) || (!maps.acceleration && !row->accelerationMap.empty()))
        return failure(std::string(key), "this technique needs maps that are not there", "Make them by searchMaps");
    const auto found = std::ranges::find(kSearches, row->file, &SearchRow::file);
    std::optional<ExactSearch> exact;
    if (row->key == "reference")
        exact.emplace(*field);
    else if (found == std::end(kSearches))
        return failure(std::string(key), "this technique has no shader text", "Reinstall Relievo");

    std::vector<SearchHit> hits(rays.size());
    std::atomic<std::size_t> done = 0;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), 256), [&](const auto& range) {
        if (progress.cancelled())
            return;
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            hits[i] = exact ? exact->hit(rays[i]) : searched(found->search, parameters, maps, rays[i]);
        progress.at(float(done += range.size()) / float(rays.size()));
    });
    if (progress.cancelled())
        return cancelled(std::string(key));
    return hits;
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
