// How far the GPU's answers are from the CPU's, of the same search text.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/trace/shader_on_cpu.h"
#include "render/windowless.h"
#include <cmath>
#include <random>

namespace relievo::test {

struct Agreement {
    int apart = 0; // rays whose t differ by 1e-4 or more, or that hit only on one
    int otherFetches = 0; // rays whose fetch counts differ
};

// Starts all over the tile and around, any direction, down to grazing.
inline std::vector<SearchRay> raysOf(int count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(-1.f, 1.f);
    std::vector<SearchRay> rays;
    for (int i = 0; i < count; ++i)
        rays.push_back({{unit(random), unit(random)}, {0.6f * unit(random), 0.6f * unit(random)}, std::abs(unit(random)) + 1e-3f});
    return rays;
}

// cpu: what traceRays answers. Needs a current context. Errors: those of traceRaysOnGpu.
inline Expected<Agreement> agreement(
    std::span<const SearchHit> cpu, std::string_view technique, const HeightField& field, std::span<const SearchRay> rays, Dialect dialect)
{
    const auto gpu = traceRaysOnGpu(technique, Parameters(), &field, rays, dialect);
    if (!gpu)
        return tl::unexpected(gpu.error());
    Agreement result;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const SearchHit &a = cpu[i], &b = (*gpu)[i];
        result.apart += !(std::abs(a.t - b.t) < 1e-4) || a.found != b.found;
        result.otherFetches += a.fetches != b.fetches;
    }
    return result;
}

} // namespace relievo::test
