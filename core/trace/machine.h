// What shader text reads on the CPU, and the searches that it makes there: each technique's file is included in the body of a struct whose
// members are the uniforms and samplers. Included by the texts' own sources alone.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/trace/recorded_steps.h"
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

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
    mutable int reads = 0; // so far, as hits count fetches
    bool gaveUp = false; // as in shaders/search/contract.glsl
    StepRecorder* recorder = nullptr;

    static constexpr StepKind kLinear = StepKind::Linear, kSecant = StepKind::Secant, kCone = StepKind::Cone, kBox = StepKind::Box,
                              kCell = StepKind::Cell, kBall = StepKind::Ball, kOffset = StepKind::Offset;
    void record(StepKind kind, float to) const
    {
        if (recorder)
            recorder->step(kind, to, reads);
    }
    void recordHalving(float from, float to, float middle) const
    {
        if (recorder)
            recorder->halving(from, to, middle, reads);
    }
    void recordRead(StepKind kind) const
    {
        if (recorder)
            recorder->read(kind, reads);
    }
    void recordShare(float share) const
    {
        if (recorder)
            recorder->share(share);
    }

    static ivec2 textureSize(const HeightField* map, int) { return {map->width(), map->height()}; }
    bool clamped() const { return wrap == Wrap::Clamp; }
    static int searchLevel() { return 0; }
    vec2 searchSize() const { return vec2(boundSize()); }
    ivec2 boundSize() const { return textureSize(heightMap, 0); }
    float heightAt(vec2 uv) const
    {
        bytes += heightBytes;
        ++reads;
        return heightMap->at(uv);
    }
#include "shaders/search/bend_quadric.glsl"
#include "shaders/search/height_on.glsl"
    vec4 cornersAt(vec2 cell) const
    {
        bytes += 4 * heightBytes;
        ++reads;
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
        ++reads;
        return boundMap->levels.front().value(texel.x, texel.y, 0);
    }
    uvec4 cellCodes(ivec2 node) const
    {
        bytes += boundBytes;
        ++reads;
        std::uint16_t codes[4];
        const Image& image = boundMap->levels.front();
        std::memcpy(
            codes, image.data.data() + (std::size_t(node.y) * std::size_t(image.width) + std::size_t(node.x)) * sizeof codes, sizeof codes);
        return {codes[0], codes[1], codes[2], codes[3]};
    }
    vec4 boundAt(vec2 uv) const
    {
        bytes += boundBytes;
        ++reads;
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
        ++reads;
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
} // namespace relievo::glsl

namespace relievo {

struct CountedHit {
    glsl::Hit hit;
    int bytes;
    bool gaveUp;
};
// parameters, maps, ray, bend (SearchRay::bend), what hears of the steps (may be null).
using TextSearch = CountedHit (*)(const Parameters&, const SearchMaps&, glsl::Ray, glm::vec3, StepRecorder*);
TextSearch textSearch(std::string_view file); // of a technique's shader file; nullptr when there is none

} // namespace relievo
