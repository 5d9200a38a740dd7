// The exact reference against brute force, and the techniques' texts on the CPU against the reference.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/techniques.h"
#include "core/trace/reference.h"
#include "core/trace/shader_on_cpu.h"
#include "tests/core/trace/bilinear.h"
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace relievo;

namespace {

HeightField gridOf(int width, int height, const std::function<float(int, int)>& h, Wrap wrap = Wrap::Repeat)
{
    std::vector<float> heights;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            heights.push_back(h(x, y));
    return {width, height, std::move(heights), wrap, 32};
}

HeightField randomField(std::mt19937& random)
{
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    const int kind = int(random() % 4);
    const auto height = [&](int x, int y) {
        switch (kind) {
        case 0:
            return unit(random); // noise
        case 1:
            return float((x + y) % 2); // checkerboard
        case 2:
            return unit(random) < 0.1f ? 1.f : 0.f; // needles
        default:
            return 0.5f + 0.5f * std::sin(float(x) * 0.9f) * std::cos(float(y) * 0.7f);
        }
    };
    return gridOf(1 + int(random() % 9), 1 + int(random() % 9), height, random() % 2 ? Wrap::Repeat : Wrap::Clamp);
}

SearchRay randomRay(std::mt19937& random, double longest)
{
    std::uniform_real_distribution<double> unit(-1., 1.);
    SearchRay ray{{unit(random), unit(random)}, {longest * unit(random), longest * unit(random)}, 0.5};
    if (random() % 8 == 0)
        ray.duv.x = 0.;
    if (random() % 8 == 0)
        ray.duv.y = 0.;
    return ray;
}

double gap(const HeightField& field, const SearchRay& ray, double t)
{
    return 1. - t - heightAt(field, ray.uv + ray.duv * t);
}

// First t where the gap is not positive, by fine steps and bisection.
double marched(const HeightField& field, const SearchRay& ray, int steps)
{
    double outside = 0.;
    for (int i = 0; i <= steps; ++i) {
        double t = double(i) / steps;
        if (gap(field, ray, t) > 0.) {
            outside = t;
            continue;
        }
        for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * (outside + t);
            (gap(field, ray, middle) <= 0. ? t : outside) = middle;
        }
        return t;
    }
    return 1.;
}

} // namespace

TEST(Reference, MatchesBruteForceOnAThousandSmallFields)
{
    std::mt19937 random(1);
    int earlier = 0;
    for (int i = 0; i < 1000; ++i) {
        const HeightField field = randomField(random);
        for (int k = 0; k < 5; ++k) {
            const SearchRay ray = randomRay(random, 1.5);
            const SearchHit hit = exactHit(field, ray);
            ASSERT_TRUE(hit.found);
            const double t = marched(field, ray, 4000);
            // The hit lies on the surface, nothing lies above it before, and the march (which may step over a sliver) never finds an
            // earlier one.
            EXPECT_NEAR(gap(field, ray, hit.t), 0., hit.t < 1. && hit.t > 0. ? 1e-9 : 1.);
            EXPECT_LE(hit.t, t + 1e-9) << "field " << i;
            if (hit.t < t - 1e-9) {
                ++earlier; // a sliver between two steps: the finer march must see it
                EXPECT_LT(gap(field, ray, hit.t + 1e-7), 1e-6);
                EXPECT_LT(t - hit.t, 1.);
            }
        }
    }
    EXPECT_LT(earlier, 25); // slivers thinner than 1 / 4000 of the depth are rare
}

TEST(Reference, RayAlongTexelEdgesAndThroughVertices)
{
    const HeightField field = gridOf(4, 4, [](int x, int y) { return x == 2 && y == 2 ? 1.f : 0.f; });
    // Along the row of texel centres y = 2, and diagonally through vertices: both meet the needle's flank.
    const SearchHit along = exactHit(field, {{0.125, 0.625}, {1., 0.}, 1.});
    EXPECT_NEAR(gap(field, {{0.125, 0.625}, {1., 0.}, 1.}, along.t), 0., 1e-12);
    EXPECT_LT(along.t, 0.5);
    const SearchRay diagonal{{0.125, 0.125}, {1., 1.}, 1.};
    const SearchHit hit = exactHit(field, diagonal);
    EXPECT_NEAR(hit.t, marched(field, diagonal, 100000), 1e-9);
}

TEST(Reference, StraightDownReadsTheDepth)
{
    const HeightField field = gridOf(3, 5, [](int x, int y) { return float(x + y) / 8.f; });
    const SearchHit hit = exactHit(field, {{0.4, 0.3}, {0., 0.}, 1.});
    EXPECT_NEAR(hit.t, 1. - heightAt(field, {0.4, 0.3}), 1e-12);
    EXPECT_EQ(hit.fetches, 1);
}

TEST(Reference, TopIsHitAtOnceAndFloorAtLast)
{
    EXPECT_EQ(exactHit(gridOf(2, 2, [](int, int) { return 1.f; }), {{0.3, 0.3}, {5., 1.}, 1.}).t, 0.);
    EXPECT_EQ(exactHit(gridOf(2, 2, [](int, int) { return 0.f; }), {{0.3, 0.3}, {5., 1.}, 1.}).t, 1.);
}

TEST(Reference, UnusualRaysEnd)
{
    const HeightField field = gridOf(8, 8, [](int x, int) { return x == 0 ? 0.5f : 0.f; });
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (const SearchRay& ray : {SearchRay{{nan, 0.}, {1., 1.}, 1.}, SearchRay{{0., inf}, {1., 1.}, 1.}, SearchRay{{0., 0.}, {nan, 0.}, 1.},
             SearchRay{{0., 0.}, {1., -inf}, 1.}}) {
        const SearchHit hit = exactHit(field, ray);
        EXPECT_FALSE(hit.found);
        EXPECT_EQ(hit.t, 1.);
        EXPECT_EQ(hit.uv, glm::dvec2(0.));
        EXPECT_EQ(hit.fetches, 0);
    }
    const HeightField ground = gridOf(8, 8, [](int, int) { return 0.f; });
    EXPECT_LE(exactHit(ground, {{0., 0.}, {1e30, 1e-30}, 1.}).fetches, kMaxReferenceCells);
    EXPECT_LE(exactHit(ground, {{1e30, 1e300}, {1e-300, 1e-310}, 1.}).fetches, kMaxReferenceCells);
}

TEST(Techniques, EveryRowWithAFileRunsOnTheCpu)
{
    const HeightField field = gridOf(4, 4, [](int, int) { return 0.25f; });
    const SearchRay rays[] = {{{0.1, 0.2}, {0.3, 0.1}, 0.8}};
    for (const TechniqueRow& row : kTechniques) {
        const auto hits = traceRays(row.key, Parameters(), &field, rays);
        ASSERT_TRUE(hits) << row.key;
        const double wanted = row.maps.empty() ? 0. : 0.75;
        EXPECT_TRUE(hits->front().found);
        if (row.isEngine())
            continue; // the depth that engines draw: tests/core/trace/engines_test.cpp
        // Most papers' searches are right to a step of theirs only (1/32 of the depth here).
        EXPECT_NEAR(hits->front().t, wanted, row.isExact ? 1e-6 : 1. / 32.) << row.key;
    }
}

TEST(Techniques, MissingHeightMapIsAnError)
{
    const SearchRay rays[] = {{{0.1, 0.2}, {0.3, 0.1}, 0.8}};
    EXPECT_TRUE(traceRays("flat", Parameters(), nullptr, rays));
    EXPECT_FALSE(traceRays("relief", Parameters(), nullptr, rays));
    EXPECT_FALSE(traceRays("reference", Parameters(), nullptr, rays));
    EXPECT_FALSE(traceRays("no-such-technique", Parameters(), nullptr, rays));
}

TEST(Techniques, FlatAndBumpStayOnThePolygon)
{
    const SearchRay rays[] = {{{0.1, 0.2}, {0.3, 0.1}, 0.8}};
    for (const char* key : {"flat", "bump"}) {
        const SearchHit hit = traceRays(key, Parameters(), nullptr, rays)->front();
        EXPECT_TRUE(hit.found);
        EXPECT_EQ(hit.t, 0.);
        EXPECT_EQ(hit.fetches, 0);
        EXPECT_EQ(glm::vec2(hit.uv), glm::vec2(0.1f, 0.2f));
    }
}

TEST(Techniques, ParallaxShiftsByTheDepthUnderThePoint)
{
    const HeightField field = gridOf(1, 1, [](int, int) { return 0.4f; });
    const SearchRay rays[] = {{{0.5, 0.5}, {0.2, -0.1}, 0.5}};
    Parameters parameters;
    SearchHit hit = traceRays("parallax", parameters, &field, rays)->front();
    EXPECT_NEAR(hit.t, 0.6, 1e-6);
    EXPECT_NEAR(hit.uv.x, 0.5 + 0.6 * 0.2, 1e-6);
    EXPECT_EQ(hit.fetches, 1);
    parameters.offsetLimiting = true; // Welsh: the shift is multiplied by the cosine
    hit = traceRays("parallax", parameters, &field, rays)->front();
    EXPECT_NEAR(hit.uv.x, 0.5 + 0.6 * 0.2 * 0.5, 1e-6);
}

TEST(Techniques, ReliefStepsFollowTheAngle)
{
    const HeightField ground = gridOf(1, 1, [](int, int) { return 0.f; }); // hit at the last step only
    Parameters parameters;
    parameters.minSteps = 8, parameters.maxSteps = 32, parameters.refineSteps = 6;
    for (const auto& [cosine, steps] : {std::pair{1., 8}, {0.5, 20}, {1e-6, 32}}) {
        const SearchRay rays[] = {{{0., 0.}, {0.1, 0.}, cosine}};
        EXPECT_EQ(traceRays("relief", parameters, &ground, rays)->front().fetches, steps + 6) << cosine;
    }
    parameters.minSteps = 32; // "32+6": exactly 32 whatever the angle
    for (double cosine = 0.01; cosine <= 1.; cosine += 0.01) {
        const SearchRay rays[] = {{{0., 0.}, {0.1, 0.}, cosine}};
        EXPECT_EQ(traceRays("relief", parameters, &ground, rays)->front().fetches, 38) << cosine;
    }
}

TEST(Techniques, ReliefFindsTheExactHitOfAGentleSurface)
{
    const HeightField field = gridOf(64, 64,
        [](int x, int y) { return 0.5f + 0.25f * std::sin(6.2831853f * float(x) / 64.f) * std::cos(6.2831853f * float(y) / 64.f); });
    std::mt19937 random(3);
    std::vector<SearchRay> rays;
    for (int i = 0; i < 2000; ++i)
        rays.push_back(randomRay(random, 0.3));
    Parameters parameters;
    parameters.minSteps = parameters.maxSteps = 64, parameters.refineSteps = 16;
    const auto hits = *traceRays("relief", parameters, &field, rays);
    const auto exact = *traceRays("reference", parameters, &field, rays);
    for (std::size_t i = 0; i < rays.size(); ++i)
        EXPECT_NEAR(hits[i].t, exact[i].t, 1e-5);
}

// 32 linear steps and 8 halvings at 80 to 88 degrees: between a sixth and a half of the rays pass through thin features
// (resources/help/speed-and-error.md, "Beside known figures"). A search that never overshoots would not be this one.
TEST(Techniques, ReliefStepsOverThinFeaturesAtGrazingAngles)
{
    std::mt19937 random(5);
    const HeightField needles = gridOf(128, 128, [&](int, int) { return random() % 500 == 0 ? 1.f : 0.1f; });
    std::vector<SearchRay> rays;
    std::uniform_real_distribution<double> unit(0., 1.);
    for (int i = 0; i < 4000; ++i) {
        const double angle = 6.2831853 * unit(random), travel = 0.08 * std::tan((80. + 8. * unit(random)) * 3.14159265 / 180.);
        rays.push_back({{unit(random), unit(random)}, {travel * std::cos(angle), travel * std::sin(angle)}, 0.1});
    }
    Parameters parameters;
    parameters.minSteps = parameters.maxSteps = 32, parameters.refineSteps = 8;
    const auto hits = *traceRays("relief", parameters, &needles, rays);
    const auto exact = *traceRays("reference", parameters, &needles, rays);
    int deeper = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        deeper += hits[i].t > exact[i].t + 0.002;
        EXPECT_GE(hits[i].t, exact[i].t - 1e-5); // relief never stops short
    }
    EXPECT_GT(deeper, 200);
}

TEST(Techniques, NothingButFiniteHitsForAnyFiniteRay)
{
    std::mt19937 random(9);
    const float extremes[] = {0.f, -0.f, 1e-45f, 1e-30f, 0.5f, 1.f, -3.25f, 1e6f, -1e12f, 3e38f, -3e38f};
    const HeightField fields[] = {randomField(random), gridOf(1, 7, [](int, int y) { return float(y % 2); }),
        gridOf(
            5, 1, [](int x, int) { return float(x) / 4.f; }, Wrap::Clamp)};
    std::vector<SearchRay> rays;
    for (const float a : extremes)
        for (const float b : extremes)
            for (const float c : extremes)
                rays.push_back({{a, b}, {c, a}, 0.3});
    for (const HeightField& field : fields)
        for (const TechniqueRow& row : kTechniques) {
            if (row.file.empty())
                continue; // the reference walks every cell: bounded, but not in a test
            const auto hits = *traceRays(row.key, Parameters(), &field, rays);
            for (const SearchHit& hit : hits) {
                EXPECT_TRUE(hit.t >= 0. && hit.t <= 1.) << row.key;
                EXPECT_LE(hit.fetches, row.isExact ? 2 * 65536 : 64) << row.key; // exact searches cross every cell if they must
            }
        }
}

TEST(Techniques, RaysThatAreNotFiniteAreAnswered)
{
    const HeightField field = gridOf(2, 2, [](int, int) { return 0.5f; });
    const double inf = std::numeric_limits<double>::infinity();
    const SearchRay rays[] = {{{inf, 0.}, {0., 0.}, 1.}, {{0., 0.}, {std::nan(""), 0.}, 1.}, {{1e300, 0.}, {0., 0.}, 1.}};
    const auto hits = *traceRays("relief", Parameters(), &field, rays);
    for (const SearchHit& hit : hits)
        EXPECT_TRUE(!hit.found && hit.t == 1. && hit.uv == glm::dvec2(0.) && hit.fetches == 0);
}

TEST(Techniques, CancelStopsWithAnError)
{
    std::stop_source stop;
    stop.request_stop();
    Progress progress;
    progress.stop = stop.get_token();
    const HeightField field = gridOf(2, 2, [](int, int) { return 0.5f; });
    const SearchRay rays[] = {{{0., 0.}, {1., 0.}, 1.}};
    const auto hits = traceRays("relief", Parameters(), &field, rays, progress);
    ASSERT_FALSE(hits);
    EXPECT_TRUE(isCancelled(hits.error()));
}

TEST(ExactWalk, FloatTextMatchesTheReference)
{
    std::mt19937 random(13);
    int wrong = 0, total = 0;
    for (int i = 0; i < 300; ++i) {
        const HeightField field = randomField(random);
        for (int k = 0; k < 30; ++k, ++total) {
            const SearchRay ray = randomRay(random, 1.);
            const SearchRay asFloat{glm::vec2(ray.uv), glm::vec2(ray.duv), 1.};
            wrong += std::abs(double(exactDepthInFloat(field, asFloat)) - exactHit(field, asFloat).t) > 1e-3;
        }
    }
    EXPECT_LE(wrong, total / 500); // ties of single precision
}

TEST(Heat, RunsFromDarkToBrightSteadily)
{
    float last = -1.f;
    for (int i = 0; i <= 20; ++i) {
        const glm::vec3 c = heatColor(float(i) / 20.f);
        const float luminance = 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
        EXPECT_GT(luminance, last);
        last = luminance;
    }
    EXPECT_EQ(heatColor(-1.f), heatColor(0.f));
    EXPECT_EQ(heatColor(7.f), heatColor(1.f));
}
