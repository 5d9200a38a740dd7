// The exact search with a pyramid against the plain walk.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/exact_search.h"
#include "core/trace/reference.h"
#include "core/trace/shader_on_cpu.h"
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace relievo;

namespace {

constexpr int kKinds = 6;

HeightField field(int kind, int width, int height, Wrap wrap, std::mt19937& random)
{
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    const std::function<float(int, int)> kinds[kKinds] = {
        [&](int, int) { return unit(random); }, // noise
        [](int x, int y) { return float((x + y) % 2); }, // checkerboard
        [&](int, int) { return unit(random) < 0.02f ? 1.f : 0.f; }, // needles
        [](int, int) { return 0.375f; }, // flat
        [](int x, int y) { return 0.5f + 0.5f * std::sin(float(x) * 0.4f) * std::cos(float(y) * 0.3f); },
        [](int x, int y) { return float((x / 3 + y / 4) % 5) / 4.f; }, // terraces
    };
    std::vector<float> heights;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            heights.push_back(kinds[kind](x, y));
    return {width, height, std::move(heights), wrap, 32};
}

HeightField anyField(int kind, std::mt19937& random)
{
    static constexpr int kSizes[] = {1, 2, 3, 5, 8, 13, 16, 31, 47, 150};
    const auto size = [&] { return kSizes[random() % std::size(kSizes)]; };
    const int width = size(), height = size();
    return field(kind, width, height, random() % 2 ? Wrap::Repeat : Wrap::Clamp, random);
}

void expectSame(const HeightField& field, const ExactSearch& search, const SearchRay& ray, double raise = 0.)
{
    const SearchHit expected = exactHit(field, ray, raise), hit = search.hit(ray, raise);
    ASSERT_EQ(hit.found, expected.found);
    ASSERT_NEAR(hit.t, expected.t, 1e-12) << field.width() << " x " << field.height()
                                          << (field.wrap() == Wrap::Clamp ? " clamp" : " repeat") << " uv " << ray.uv.x << ' ' << ray.uv.y
                                          << " duv " << ray.duv.x << ' ' << ray.duv.y;
    ASSERT_EQ(hit.uv, ray.uv + ray.duv * hit.t);
}

} // namespace

TEST(ExactSearch, AnswersAsThePlainWalk)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1., 1.);
    for (int i = 0; i < 300 * kKinds; ++i) {
        const HeightField heights = anyField(i % kKinds, random);
        const ExactSearch search(heights);
        for (const double travel : {0., 0.01, 0.3, 3., 0.5 * std::tan(89.9 * 3.14159265358979 / 180.)})
            for (int k = 0; k < 4; ++k) {
                SearchRay ray{{2. * unit(random), 2. * unit(random)}, {travel * unit(random), travel * unit(random)}, 0.5};
                if (k == 1)
                    ray.duv.x = 0.;
                if (k == 2)
                    ray.duv.y = -0.;
                expectSame(heights, search, ray);
            }
    }
}

TEST(ExactSearch, AlongTexelEdgesAndThroughVertices)
{
    std::mt19937 random(2);
    for (int i = 0; i < 100 * kKinds; ++i) {
        const HeightField heights = anyField(i % kKinds, random);
        const ExactSearch search(heights);
        const auto texels = [&](int most) { return double(int(random() % unsigned(2 * most + 1)) - most); };
        for (int k = 0; k < 16; ++k) { // from a vertex, by whole texels (0 too): along an edge, through vertices
            const double stepX = texels(3), stepY = texels(3), times = texels(20);
            expectSame(heights, search,
                {{(texels(60) + 0.5) / heights.width(), (texels(60) + 0.5) / heights.height()},
                    {stepX * times / heights.width(), stepY * times / heights.height()}, 0.5});
        }
    }
}

TEST(ExactSearch, FarStartsAndRaisedSurfaces)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1., 1.);
    for (int i = 0; i < 60 * kKinds; ++i) {
        const HeightField heights = anyField(i % kKinds, random);
        const ExactSearch search(heights);
        for (const double far : {1e3, 1e6, 1e9, 1e13})
            expectSame(heights, search, {{far * unit(random), far * unit(random)}, {unit(random), unit(random)}, 0.5});
        for (const double raise : {-2., -0.25, -1e-4, 1e-4, 0.25, 2.})
            expectSame(heights, search, {{unit(random), unit(random)}, {unit(random), unit(random)}, 0.5}, raise);
    }
}

TEST(ExactSearch, UnusualRaysAreThoseOfThePlainWalk)
{
    std::mt19937 random(4);
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp}) {
        const HeightField heights = field(2, 13, 8, wrap, random);
        const ExactSearch search(heights);
        for (const double odd : {inf, -inf, nan, 1e5, 1e-310, -1e-310, -1e-300, 5e-16})
            for (int k = 0; k < 4; ++k) {
                SearchRay ray{{0.3, 0.5 / 8.}, {-0.4, 0.2}, 0.5};
                (k < 2 ? ray.uv : ray.duv)[k % 2] = odd;
                const SearchHit expected = exactHit(heights, ray), hit = search.hit(ray);
                EXPECT_EQ(hit.found, expected.found) << odd << ' ' << k;
                EXPECT_NEAR(hit.t, expected.t, 1e-12) << odd << ' ' << k;
            }
        EXPECT_EQ(search.hit({{0.3, 0.5}, {1e300, 1.}, 0.5}).found, exactHit(heights, {{0.3, 0.5}, {1e300, 1.}, 0.5}).found);
    }
}

TEST(ExactSearch, PassesOverWhatTheRayStaysAbove)
{
    std::mt19937 random(5);
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp}) {
        const HeightField ground = field(3, 500, 300, wrap, random);
        const SearchRay ray{{0.1, 0.2}, {1.7, 0.9}, 0.1};
        EXPECT_GT(exactHit(ground, ray).fetches, 500);
        EXPECT_LT(ExactSearch(ground).hit(ray).fetches, 20);
        EXPECT_LT(ExactSearch(ground).bytes(), ground.texels().size_bytes() / 12);
        EXPECT_LT(traceRays("reference", Parameters(), &ground, {&ray, 1})->front().fetches, 20);
    }
}
