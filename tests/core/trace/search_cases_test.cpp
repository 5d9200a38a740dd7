// Searches on rays that once went wrong: each case is small enough to be followed by hand.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/techniques.h"
#include "core/trace/reference.h"
#include "core/trace/shader_on_cpu.h"
#include "tests/core/maps/maps_support.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace relievo;
using test::fieldOf;

namespace {
SearchHit hitOf(std::string_view key, const Parameters& parameters, const HeightField& field, const SearchRay& ray)
{
    const auto hits = traceRays(key, parameters, &field, std::vector<SearchRay>{ray});
    EXPECT_TRUE(hits) << key;
    return hits ? hits->front() : SearchHit();
}
} // namespace

// A ray that begins below the polygon: the gap at its start counts from there, and between two samples on a level field it is linear.
TEST(SearchCases, SecantsBeginWhereTheRayDoes)
{
    const HeightField level = fieldOf(4, 4, [](int, int) { return 0.4f; });
    SearchRay ray{{0.1, 0.2}, {0.5, 0.3}, 0.5};
    ray.bend = {-0.5, 0., 0.}; // depth t + 0.5
    Parameters parameters;
    parameters.minSteps = parameters.maxSteps = 4, parameters.refineSteps = 0;
    for (const char* key : {"pom", "interval"}) {
        EXPECT_NEAR(hitOf(key, parameters, level, ray).t, 0.1, 1e-6) << key;
        SearchRay inside = ray;
        inside.bend.x = -0.7;
        EXPECT_NEAR(hitOf(key, parameters, level, inside).t, 0., 1e-6) << key;
    }
}

// The end of the last leap may lie inside the relief like that of any other.
TEST(SearchCases, TheLastLeapIsHalvedToo)
{
    const HeightField rough = fieldOf(100, 37, [](int x, int y) { return float((7919 * x + 104729 * y) % 1000) / 1000.f; });
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1., 1.);
    std::vector<SearchRay> rays;
    for (int i = 0; i < 3000; ++i)
        rays.push_back({{unit(random), unit(random)}, {1.5 * unit(random), 1.5 * unit(random)}, 0.5});
    Parameters parameters;
    parameters.leapSteps = 4, parameters.refineSteps = 16, parameters.lastBracket = true;
    for (const char* key : {"cone", "cone-quad", "cone-robust", "cone-relaxed"}) {
        const auto hits = traceRays(key, parameters, &rough, rays);
        ASSERT_TRUE(hits);
        int inside = 0;
        for (const SearchHit& hit : *hits)
            inside += hit.found && hit.t - (1. - double(rough.at(glm::vec2(hit.uv)))) > 0.02;
        EXPECT_EQ(inside, 0) << key;
    }
}

// The wall is crossed so near the floor that the little way beyond it, long on a vertical ray, leads below.
TEST(SearchCases, WhatLiesBeyondTheLastWallIsFound)
{
    const HeightField field = fieldOf(16, 16, [](int, int y) { return y == 4 ? 0.002f : 0.5f; });
    for (const double wall : {0.9905, 0.992, 0.995}) {
        const SearchRay ray{{(5.5 - wall * 1e-3) / 16., 4.5 / 16.}, {1e-3 / 16., 0.}, 1.};
        for (const char* key : {"pyramid", "cell-cone"})
            EXPECT_NEAR(hitOf(key, {}, field, ray).t, exactHit(field, ray).t, 3e-5) << key;
    }
}

// Beyond a clamped border the surface goes on unchanged, however far.
TEST(SearchCases, BeyondAClampedBorderThereIsOneCell)
{
    const HeightField field = fieldOf(
        256, 256, [](int x, int) { return x == 255 ? 0.5f : 0.6f; }, Wrap::Clamp);
    for (const double travel : {20., 2000., 5000., -5000.}) {
        const SearchRay ray{{travel > 0. ? 0.9 : 0.1, 0.5}, {travel, 0.}, 0.01};
        for (const char* key : {"pyramid", "cell-cone"}) {
            const SearchHit hit = hitOf(key, {}, field, ray);
            EXPECT_NEAR(hit.t, exactHit(field, ray).t, 1e-5) << key << travel;
            EXPECT_LT(hit.fetches, 60) << key << travel;
        }
    }
}

// A ray that hardly sinks, as through a prism, does not come near the level ground: no node needs to be opened.
TEST(SearchCases, NodesThatABentRayStaysAboveAreNotOpened)
{
    const HeightField level = fieldOf(64, 64, [](int, int) { return 0.5f; });
    SearchRay ray{{0.1, 0.2}, {3., 0.4}, 0.1};
    ray.bend = {0., 0.9, 0.}; // depth 0.1 t
    const SearchHit hit = hitOf("pyramid", {}, level, ray);
    EXPECT_FALSE(hit.found);
    EXPECT_LE(hit.fetches, 8);
}

TEST(SearchCases, ASlopeOfNextToNothingIsNone)
{
    const HeightField level = fieldOf(16, 16, [](int, int) { return 0.5f; });
    for (const char* key : {"pyramid", "cell-cone"})
        EXPECT_NEAR(hitOf(key, {}, level, {{0.03125, 0.3}, {-1e-42, 0.5}, 1.}).t, 0.5, 1e-6) << key;
}
