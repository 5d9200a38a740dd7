// Seamless noise for the built-in samples: gradient noise, its sums, and jittered cells, all periodic over the tile.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace relievo::pattern {

// A random number in [0, 1) that depends on the three values only.
inline std::uint32_t hashOf(int x, int y, std::uint32_t seed)
{
    std::uint32_t h = std::uint32_t(x) * 0x8da6b343u ^ std::uint32_t(y) * 0xd8163841u ^ seed * 0xcb1ab31fu;
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    return h ^ (h >> 16);
}
inline float randomOf(int x, int y, std::uint32_t seed)
{
    return float(hashOf(x, y, seed) >> 8) * 0x1p-24f;
}
inline float randomOf(std::uint32_t id, std::uint32_t seed)
{
    return randomOf(int(id), 0, seed);
}

inline float smooth(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.f, 1.f);
    return t * t * (3.f - 2.f * t);
}
inline float saturate(float x)
{
    return std::clamp(x, 0.f, 1.f);
}

// Floor without a library call: the x86-64 baseline has no instruction for it.
inline int floorOf(float x)
{
    const int i = int(x);
    return float(i) > x ? i - 1 : i;
}
// Wraps an index that is rarely more than one period away; a division costs more than the noise itself.
inline int wrapped(int i, int period)
{
    if (i < 0)
        i += period;
    if (i >= period)
        i -= period;
    return i < 0 || i >= period ? wrapIndex(i, period, Wrap::Repeat) : i;
}

// Random gradients, looked up instead of hashed: the samples ask for noise some 40 times a texel.
inline constexpr std::size_t kGradientCount = std::size_t(1) << 14;
inline const std::vector<glm::vec2> kGradients = [] {
    std::vector<glm::vec2> gradients(kGradientCount);
    for (std::size_t i = 0; i < kGradientCount; ++i)
        gradients[i] = 2.f * glm::vec2(randomOf(int(i), 1, 17), randomOf(int(i), 2, 17)) - 1.f;
    return gradients;
}();

// Gradient noise at p, repeating after `period` lattice cells each way; about [-1, 1], 0 on average, twice differentiable.
inline float noise(glm::vec2 p, glm::ivec2 period, std::uint32_t seed)
{
    const int x = floorOf(p.x), y = floorOf(p.y);
    const float fx = p.x - float(x), fy = p.y - float(y);
    const int x0 = wrapped(x, period.x), y0 = wrapped(y, period.y);
    const int x1 = x0 + 1 == period.x ? 0 : x0 + 1, y1 = y0 + 1 == period.y ? 0 : y0 + 1;
    const auto rowStart = [&](int row) { return seed * 7919u + std::uint32_t(row) * (std::uint32_t(period.x) | 1u); };
    const auto slope = [](std::uint32_t start, int i, float dx, float dy) {
        const glm::vec2 gradient = kGradients[(start + std::uint32_t(i)) & (kGradientCount - 1)];
        return gradient.x * dx + gradient.y * dy;
    };
    const std::uint32_t above = rowStart(y0), below = rowStart(y1);
    const float u = fx * fx * fx * (fx * (fx * 6.f - 15.f) + 10.f), v = fy * fy * fy * (fy * (fy * 6.f - 15.f) + 10.f);
    const float a = slope(above, x0, fx, fy), b = slope(above, x1, fx - 1.f, fy);
    const float c = slope(below, x0, fx, fy - 1.f), d = slope(below, x1, fx - 1.f, fy - 1.f);
    const float top = a + u * (b - a), bottom = c + u * (d - c);
    return 1.6f * (top + v * (bottom - top));
}

// Sum of octaves over the tile: `cells` lattice cells across it in the first, twice as many in each next one; about [-1, 1].
inline float fractal(glm::vec2 uv, glm::ivec2 cells, int octaves, std::uint32_t seed, float gain = 0.5f)
{
    float sum = 0.f, amplitude = 1.f, total = 0.f;
    for (int i = 0; i < octaves; ++i, amplitude *= gain, cells *= 2) {
        sum += amplitude * noise(uv * glm::vec2(cells), cells, seed + std::uint32_t(i) * 101u);
        total += amplitude;
    }
    return sum / total;
}
inline float fractal(glm::vec2 uv, int cells, int octaves, std::uint32_t seed, float gain = 0.5f)
{
    return fractal(uv, glm::ivec2(cells), octaves, seed, gain);
}

// Jittered cells (Worley 1996): centres of `cells` across the tile; odd rows are shifted by half a cell (cells.y even).
struct CellGrid {
    glm::ivec2 cells;
    float jitter; // [0, 0.6]: then the nearest centre is always among the 3 x 3 around a point
    std::uint32_t seed;

    float shift(int row) const { return (row & 1) ? 0.5f : 0.f; }
    glm::vec2 centre(int i, int j) const
    {
        const std::uint32_t h = hashOf(wrapped(i, cells.x), wrapped(j, cells.y), seed);
        const glm::vec2 random(float(int(h & 0xffffu)) * 0x1p-16f, float(int(h >> 16)) * 0x1p-16f);
        return glm::vec2(float(i) + shift(j), float(j)) + 0.5f + jitter * (random - 0.5f);
    }
    std::uint32_t id(int i, int j) const { return hashOf(wrapped(i, cells.x), wrapped(j, cells.y), seed + 7u); }
};

// Where a point lies among the cells, in units of one cell.
struct CellPoint {
    std::uint32_t id; // of the nearest cell
    glm::vec2 offset; // from the nearest centre to the point
    float border; // distance to the edge with the neighbours, its corners rounded
};

inline CellPoint cellAt(glm::vec2 uv, const CellGrid& grid)
{
    const glm::vec2 p = uv * glm::vec2(grid.cells);
    int bestI = 0, bestJ = 0;
    float nearest = 1e9f;
    for (int j = floorOf(p.y) - 1; j <= floorOf(p.y) + 1; ++j) {
        const int middle = floorOf(p.x - grid.shift(j));
        for (int i = middle - 1; i <= middle + 1; ++i) {
            const glm::vec2 d = p - grid.centre(i, j);
            if (glm::dot(d, d) < nearest) {
                nearest = glm::dot(d, d);
                bestI = i;
                bestJ = j;
            }
        }
    }
    // Edges of the 5 x 3 around the nearest cell, joined by a smooth minimum.
    const glm::vec2 centre = grid.centre(bestI, bestJ);
    constexpr float kSharpness = 11.f;
    float sum = 0.f;
    for (int j = bestJ - 1; j <= bestJ + 1; ++j) {
        for (int i = bestI - 2; i <= bestI + 2; ++i) {
            if (i == bestI && j == bestJ)
                continue;
            const glm::vec2 across = grid.centre(i, j) - centre;
            const float edge = glm::dot(0.5f * across - (p - centre), across) / std::sqrt(glm::dot(across, across));
            if (edge < 0.8f)
                sum += std::exp(-kSharpness * edge);
        }
    }
    return {grid.id(bestI, bestJ), p - centre, -std::log(sum + 1e-6f) / kSharpness};
}

} // namespace relievo::pattern
