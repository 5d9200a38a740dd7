// Where exact searches used to end without an answer: rays over very many texels, and touches just where a ray begins.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/techniques.h"
#include "core/trace/exact_search.h"
#include "core/trace/reference.h"
#include "core/trace/shader_on_cpu.h"
#include "tests/core/maps/maps_support.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace relievo;
using test::fieldOf;

namespace {
const char* const kExact[] = {"reference", "pyramid", "cell-cone"};

HeightField noiseField(int width, int height, Wrap wrap, std::mt19937& random)
{
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    return fieldOf(
        width, height, [&](int, int) { return unit(random); }, wrap);
}

std::vector<SearchHit> hitsOf(std::string_view key, const HeightField& field, const std::vector<SearchRay>& rays)
{
    Parameters parameters;
    parameters.wrap = field.wrap();
    const auto hits = traceRays(key, parameters, &field, rays);
    EXPECT_TRUE(hits) << key;
    return hits ? *hits : std::vector<SearchHit>(rays.size());
}
} // namespace

// Far beyond its borders a clamped tile goes on as its corner does.
TEST(SearchLimits, ClampedRaysOfAnyLengthAreAnswered)
{
    std::mt19937 random(1);
    for (const auto& [width, height] : {std::pair(64, 64), {1, 5}, {33, 2}}) {
        const HeightField field = noiseField(width, height, Wrap::Clamp, random);
        const double corner = 1. - double(field.texel(width - 1, height - 1));
        std::vector<SearchRay> rays;
        for (const double travel : {1e2, 3e3, 1e5, 1e7, 1e9})
            for (const double start : {0.99, 2., 1e3})
                rays.push_back({{start, start}, {travel, 0.7 * travel}, 0.01});
        for (const char* key : kExact) {
            const auto hits = hitsOf(key, field, rays);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                EXPECT_TRUE(hits[i].found && !hits[i].isUnfinished) << key << ' ' << rays[i].duv.x;
                EXPECT_NEAR(hits[i].t, corner, 0.01) << key << ' ' << rays[i].uv.x << ' ' << rays[i].duv.x; // 0.01: what lies before
            }
        }
        for (const SearchRay& ray : rays) {
            const SearchHit plain = exactHit(field, ray);
            EXPECT_LE(plain.fetches, width + height + 2);
            EXPECT_NEAR(plain.t, ExactSearch(field).hit(ray).t, 1e-12);
        }
    }
}

TEST(SearchLimits, ClampedRaysFromFarAwayComeIn)
{
    const HeightField wall = fieldOf(
        16, 16, [](int x, int) { return x == 8 ? 1.f : 0.f; }, Wrap::Clamp);
    for (const double from : {3., 1e3, 1e6}) {
        const SearchRay ray{{-from, 0.5}, {2. * from, 0.1}, 0.01};
        const double expected = (7.5 / 16. + from) / (2. * from); // about where the wall begins to rise
        const SearchHit hit = exactHit(wall, ray);
        EXPECT_TRUE(hit.found);
        EXPECT_NEAR(hit.t, expected, 1.5 / 16. / from);
        EXPECT_LT(hit.t, 0.9);
    }
}

TEST(SearchLimits, RepeatedRaysThatAreGivenUpSaySo)
{
    const HeightField needle = fieldOf(64, 64, [](int x, int y) { return x == 0 && y == 0 ? 1.f : 0.f; });
    const std::vector<SearchRay> rays{{{0.5, 0.5}, {2e5, 0.}, 0.01}, {{0.5, 0.5}, {0.3, 0.1}, 0.5}, {{0.5, 0.5}, {-1e20, 1e20}, 0.01}};
    for (const char* key : kExact) {
        const auto hits = hitsOf(key, needle, rays);
        for (const std::size_t i : {0u, 2u}) {
            EXPECT_TRUE(hits[i].isUnfinished && !hits[i].found) << key << ' ' << i;
            EXPECT_EQ(hits[i].t, 1.) << key;
            EXPECT_EQ(hits[i].uv, rays[i].uv + rays[i].duv) << key;
        }
        EXPECT_TRUE(hits[1].found && !hits[1].isUnfinished) << key;
    }
}

// A ray that begins on a texel of height 1 touches it, whichever way it goes on and whatever node the texel is a corner of.
TEST(SearchLimits, TouchesAtTheStartAreFound)
{
    for (const int size : {2, 4, 5, 16, 64})
        for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp}) {
            std::vector<SearchRay> rays;
            const HeightField field = fieldOf(
                size, size, [](int x, int y) { return x % 2 == 0 && y % 2 == 0 ? 1.f : 0.f; }, wrap);
            for (int y = 0; y < size; y += 2)
                for (int x = 0; x < size; x += 2)
                    for (const glm::dvec2 way : {glm::dvec2(1., 0.), {-1., 0.}, {0., 1.}, {0., -0.62}, {0.5, 0.5}, {-0.5, -0.5}, {-3., 1.}})
                        rays.push_back({(glm::dvec2(x, y) + 0.5) / double(size), way, 0.5});
            std::erase_if(rays, [size](const SearchRay& ray) { // only those that begin on the texel in single precision too
                const glm::vec2 at = glm::vec2(ray.uv) * float(size) - 0.5f;
                return at.x != std::round(at.x) || at.y != std::round(at.y);
            });
            ASSERT_FALSE(rays.empty());
            for (const char* key : kExact)
                for (const SearchHit& hit : hitsOf(key, field, rays))
                    ASSERT_TRUE(hit.found && hit.t == 0.) << key << ' ' << size << ' ' << hit.t << ' ' << hit.uv.x << ' ' << hit.uv.y;
        }
}

// Drivers take denormal numbers for 0 or not: so that both answer alike, they are 0 everywhere.
TEST(SearchLimits, NextToNothingIsNothing)
{
    std::mt19937 random(2);
    const HeightField field = noiseField(64, 64, Wrap::Clamp, random);
    for (const TechniqueRow& row : kTechniques) {
        if (row.file.empty())
            continue;
        for (const double v : {12.5 / 64., 0., 1e-40}) {
            const auto level = hitsOf(row.key, field, {{{0.38, v < 1e-30 ? 0. : v}, {0.84, 0.}, 0.5}}).front();
            for (const double tiny : {1e-38, -1e-38, 1e-45, -1e-41}) {
                const auto hit = hitsOf(row.key, field, {{{0.38, v}, {0.84, tiny}, 0.5}}).front();
                EXPECT_EQ(hit.fetches, level.fetches) << row.key << ' ' << v << ' ' << tiny;
                EXPECT_EQ(hit.t, level.t) << row.key;
                EXPECT_EQ(hit.uv, level.uv) << row.key;
            }
        }
    }
}
