// The searches that pictures of relief objects are drawn by, against the exact one in double precision.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/object_search.h"
#include "core/object/object_shader.h"
#include "core/state/techniques.h"
#include "tests/core/object/object_support.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace relievo;
using namespace relievo::test;

namespace {
using Random = std::mt19937;

std::vector<Solid> anySolids(Random& random, int count)
{
    std::uniform_real_distribution<double> place(-0.6, 0.6), size(0.05, 0.4);
    std::vector<Solid> solids;
    for (int i = 0; i < count; ++i)
        solids.push_back({{place(random), place(random), place(random)}, {size(random), size(random), size(random)}, i % 2 == 0});
    return solids;
}

struct Compared {
    int hits = 0, wrong = 0, ties = 0;
    double fetches = 0.;
};

// rays from all around, and from within.
Compared compared(const ReliefObject& object, int rays, Random& random)
{
    const ObjectTexels texels = objectTexels(object);
    const double size = leastSize(object);
    Compared sum;
    for (int i = 0; i < rays; ++i) {
        const glm::dvec3 target = object.center + 0.3 * size * evenDirection(random), from = evenDirection(random);
        const glm::dvec3 origin = object.center + (i % 4 == 0 ? 0.4 : 4.) * size * from, direction = glm::normalize(target - origin);
        const auto exact = firstHit(object, origin, direction);
        const ObjectRayHit found = searchObject("object", {}, object, texels, origin, direction);
        sum.hits += bool(exact);
        sum.fetches += found.fetches;
        if (bool(exact) == found.found && (!exact || std::abs(exact->t - found.t) < 1e-4 * size))
            continue;
        (isTie(object, found, origin, direction) ? sum.ties : sum.wrong) += 1;
    }
    return sum;
}
} // namespace

TEST(ObjectShader, TheExactSearchFindsTheFirstHit)
{
    Random random(3);
    for (const int layers : {1, 2, 4})
        for (const int size : {1, 2, 17, 64, 150}) {
            ReliefObject object = objectOf(anySolids(random, 2 + size % 5), size, layers);
            if (size == 17)
                object.axes[std::size_t(layers % 3)] = {}; // not bounded along it
            place(object);
            const Compared all = compared(object, 3000, random);
            EXPECT_EQ(all.wrong, 0) << layers << ' ' << size;
            EXPECT_LT(all.ties, 5) << layers << ' ' << size;
        }
}

// Needles and noise: every texel on its own, some thin, some empty, some backwards.
TEST(ObjectShader, TheExactSearchHoldsOnNoise)
{
    Random random(5);
    for (int round = 0; round < 6; ++round) {
        ReliefObject object;
        for (AxisMap& map : object.axes) {
            map = {20 + round, 31, 1 + round % 3, {}};
            for (int i = 0; i < map.width * map.height * map.layers; ++i) {
                const auto front = std::uint16_t(random() % 40000), back = std::uint16_t(front + random() % 25000);
                map.intervals.push_back(random() % 5 == 0 ? Interval()
                        : random() % 7 == 0               ? Interval{front, front}
                                                          : Interval{front, back});
            }
        }
        if (round % 2 == 1)
            object.axes[0] = object.axes[1] = {};
        place(object);
        const Compared all = compared(object, 3000, random);
        EXPECT_EQ(all.wrong, 0) << round;
        EXPECT_GT(all.hits, 500) << round;
    }
}

TEST(ObjectShader, ReadsLessThanSearchingSideBySide)
{
    Random random(7);
    const ReliefObject object = objectOf(anySolids(random, 5), 128, 1);
    const ObjectTexels texels = objectTexels(object);
    double once = 0., bySides = 0.;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 origin = 2. * evenDirection(random), direction = glm::normalize(0.3 * evenDirection(random) - origin);
        once += searchObject("object", {}, object, texels, origin, direction).fetches;
        bySides += searchObject("object-sides", {}, object, texels, origin, direction).fetches;
    }
    EXPECT_LT(once, bySides);
}

// The report's figure 5.2: seen from the front all of the box is solid, and only from above it is told that most of it is not.
TEST(ObjectShader, TheNaiveFormShowsWhatOtherSidesDiscard)
{
    ReliefObject object;
    object.axes[2] = {8, 8, 1, std::vector<Interval>(64, {0, Interval::kDeepest})};
    object.axes[1] = {8, 8, 1, std::vector<Interval>(64)};
    for (std::size_t x = 0; x < 8; ++x) // a wall from z = 0 to 1/8 of the box's half, for u is x and v is z
        object.axes[1].intervals[4 * 8 + x] = {0, Interval::kDeepest};
    const ObjectTexels texels = objectTexels(object);
    const glm::dvec3 origin{0.1, 0.1, 2.}, direction{0., 0.01, -1.}, above{0., 2., -0.2}, down{0., -1., 0.};
    const auto exact = firstHit(object, origin, direction);
    ASSERT_TRUE(exact);
    EXPECT_NEAR(exact->t, 1.875, 1e-6);
    Parameters parameters;
    const auto found = [&](const char* technique, glm::dvec3 from, glm::dvec3 way) {
        return searchObject(technique, parameters, object, texels, from, way);
    };
    EXPECT_NEAR(found("object", origin, direction).t, 1.875, 1e-5);
    EXPECT_NEAR(found("object-steps", origin, direction).t, 1.875, 0.01);
    EXPECT_NEAR(found("object-sides", origin, direction).t, 1.875, 0.01); // what is seen from above; what is seen from the front is dropped
    EXPECT_FALSE(firstHit(object, above, down));
    for (const TechniqueRow& row : kObjectTechniques)
        EXPECT_FALSE(found(row.key.data(), above, down).found) << row.key;
    parameters.crossDiscard = false;
    EXPECT_NEAR(found("object-sides", origin, direction).t, 1.5, 0.04); // a wall that is not there, on the front itself
}

TEST(ObjectShader, EveryTechniqueHoldsOnOddRays)
{
    Random random(9);
    ReliefObject object = objectOf(anySolids(random, 4), 33, 2);
    const ObjectTexels texels = objectTexels(object);
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    const glm::dvec3 odd[][2] = {{{0., 0., 0.}, {0., 0., 0.}}, {{nan, 0., 0.}, {1., 0., 0.}}, {{0., 0., 2.}, {inf, 0., -1.}},
        {{0., 0., 2.}, {0., 0., -1.}}, {{0.5, 0.5, 2.}, {0., 0., -1.}}, {{0.5, 0., 2.}, {0., 0., -1e-30}}, {{0., 0., 1e9}, {0., 0., -1.}},
        {{-2., 0.25, 0.}, {1., 1e-9, 1e-9}}, {{-0.5, -0.5, -0.5}, {1., 1., 1.}}};
    for (const TechniqueRow& row : kObjectTechniques)
        for (const auto& [origin, direction] : odd) {
            const ObjectRayHit hit = searchObject(row.key, {}, object, texels, origin, direction);
            EXPECT_TRUE(!hit.found || (std::isfinite(hit.t) && std::isfinite(glm::length(hit.normal)))) << row.key;
        }
    EXPECT_FALSE(searchObject("relief", {}, object, texels, {0., 0., 2.}, {0., 0., -1.}).found);
}
