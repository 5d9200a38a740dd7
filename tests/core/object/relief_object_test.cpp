// Relief objects against what is known in closed form, and their search against asking point by point.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/object_search.h"
#include "tests/core/object/object_support.h"
#include <gtest/gtest.h>
#include <random>

using namespace relievo;
using namespace relievo::test;

namespace {
using Random = std::mt19937;

double uniform(Random& random, double from, double to)
{
    return std::uniform_real_distribution<double>(from, to)(random);
}

glm::dvec3 anyDirection(Random& random)
{
    for (;;) {
        const glm::dvec3 v{uniform(random, -1., 1.), uniform(random, -1., 1.), uniform(random, -1., 1.)};
        if (const double length = glm::length(v); length > 0.1 && length <= 1.)
            return v / length;
    }
}

ReliefObject fullBox()
{
    ReliefObject object;
    object.axes.fill({1, 1, 1, {{0, Interval::kDeepest}}});
    return object;
}

// Intervals at random: in order, some empty, some thin, and where `wild` is set also some that cross or run backwards.
AxisMap randomMap(Random& random, int layers, bool wild)
{
    AxisMap map{1 + int(random() % 7), 1 + int(random() % 7), layers, {}};
    for (int i = 0; i < map.width * map.height; ++i) {
        std::vector<std::uint16_t> depths(2 * std::size_t(layers));
        for (std::uint16_t& depth : depths)
            depth = std::uint16_t(random() % 65536);
        if (!wild)
            std::ranges::sort(depths);
        for (std::size_t k = 0; k < std::size_t(layers); ++k)
            map.intervals.push_back(random() % 4 == 0 ? Interval() : Interval{depths[2 * k], depths[2 * k + 1]});
    }
    return map;
}
} // namespace

TEST(ReliefObject, TheFramesOfItsAxesAreRightHandedAndFaceOutwards)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const AxisFrame& frame = kAxisFrames[axis];
        EXPECT_EQ(glm::cross(frame.u, frame.v), frame.depth);
        EXPECT_EQ(frame.depth[int(axis)], -1.);
    }
}

TEST(ReliefObject, AFullOneIsItsBox)
{
    ReliefObject object = fullBox();
    place(object);
    const glm::dvec3 along = glm::normalize(object.half[2]);
    const auto hit = firstHit(object, object.center + 3. * along + 0.3 * object.half[0], -2. * along);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 0.75, 1e-12);
    EXPECT_EQ(hit->on, HitOn::Box);
    EXPECT_EQ(hit->axis, 2);
    EXPECT_NEAR(glm::dot(hit->normal, along), 1., 1e-12);
    EXPECT_FALSE(firstHit(object, object.center + 3. * along, along));
    EXPECT_FALSE(firstHit(object, object.center + 3. * along, -along, 1.));
    EXPECT_FALSE(firstHit(object, object.center + 3. * along + 1.01 * object.half[1], -along));
    const auto inside = firstHit(object, object.center, along);
    ASSERT_TRUE(inside);
    EXPECT_EQ(inside->t, 0.);
    EXPECT_EQ(inside->on, HitOn::Inside);
}

// A slab between 1/4 and 3/4 of each axis in turn is met where it lies, from both sides.
TEST(ReliefObject, FrontsAndBacksLieWhereTheMapSays)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ReliefObject object;
        object.axes[axis] = {2, 3, 1, std::vector<Interval>(6, {13107, 52428})}; // 0.2, 0.8
        place(object);
        const glm::dvec3 inwards = kAxisFrames[axis].depth[int(axis)] * object.half[axis], aside = 0.1 * object.half[(axis + 1) % 3];
        const auto front = firstHit(object, object.center - 2. * inwards + aside, inwards);
        const auto back = firstHit(object, object.center + 2. * inwards + aside, -inwards);
        ASSERT_TRUE(front && back);
        EXPECT_NEAR(front->t, 1.4, 1e-12);
        EXPECT_NEAR(back->t, 1.4, 1e-12);
        EXPECT_EQ(front->on, HitOn::Front);
        EXPECT_EQ(back->on, HitOn::Back);
        EXPECT_NEAR(glm::dot(front->normal, glm::normalize(inwards)), -1., 1e-12);
        EXPECT_NEAR(glm::dot(back->normal, glm::normalize(inwards)), 1., 1e-12);
        EXPECT_EQ(front->axis, int(axis));
    }
}

// Texture directions: only one texel of each axis is empty, and it is where the frame says.
TEST(ReliefObject, TexelsLieWhereTheFrameSays)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ReliefObject object;
        object.axes[axis] = {4, 2, 1, std::vector<Interval>(8, {0, Interval::kDeepest})};
        object.axes[axis].intervals[1 * 4 + 3] = {};
        const AxisFrame& frame = kAxisFrames[axis];
        const auto at = [&](double u, double v) { return 0.5 * ((2. * u - 1.) * frame.u + (2. * v - 1.) * frame.v); };
        EXPECT_FALSE(isInside(object, at(3.5 / 4., 1.5 / 2.)));
        EXPECT_TRUE(isInside(object, at(2.4 / 4., 1.5 / 2.)));
        EXPECT_TRUE(isInside(object, at(3.5 / 4., 0.4)));
        EXPECT_FALSE(isInside(object, at(3.1 / 4., 0.6)));
    }
}

TEST(ReliefObject, SpheresAndBoxesAreMetWhereTheyLie)
{
    const std::vector<Solid> solids{{{-0.3, -0.2, 0.1}, glm::dvec3(0.5)}, {{0.4, 0.4, -0.3}, {0.4, 0.3, 0.5}, false}};
    constexpr int size = 256;
    const ReliefObject object = objectOf(solids, size, 2);
    Random random(1);
    int hits = 0, wrong = 0;
    for (int i = 0; i < 3000; ++i) {
        const glm::dvec3 target = 0.4 * anyDirection(random), direction = anyDirection(random);
        const glm::dvec3 origin = 0.5 * target - 2. * direction;
        const auto hit = firstHit(object, origin, direction);
        // The first place within one of them, by steps of a fifth of a texel.
        double exact = 1e300;
        for (double t = 1.; t < 3. && exact > 3.; t += 0.2 / size)
            for (const Solid& solid : solids)
                if (solid.holds(2. * (origin + t * direction)))
                    exact = std::min(exact, t);
        if (bool(hit) != (exact < 3.))
            ++wrong; // at the outlines, which are texels wide
        else if (hit) {
            ++hits;
            wrong += std::abs(hit->t - exact) > 2. / size;
        }
    }
    EXPECT_GT(hits, 1000);
    EXPECT_LT(wrong, 30);
}

// The bilinear surface of a plane is the plane: hits are exact but for the depths' rounding.
TEST(ReliefObject, ASlopeIsMetExactly)
{
    ReliefObject object;
    AxisMap& map = object.axes[2] = {5, 4, 1, {}};
    const auto front = [](double u, double v) { return 0.1 + 0.4 * u + 0.2 * v; };
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x)
            map.intervals.push_back({std::uint16_t(std::lround(front((x + 0.5) / 5., (y + 0.5) / 4.) * 65535.)), Interval::kDeepest});
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const double u = uniform(random, 0.1, 0.9), v = uniform(random, 0.125, 0.875);
        const glm::dvec3 point{u - 0.5, 0.5 - v, 0.5 - front(u, v)};
        const glm::dvec3 direction{uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2), -1.};
        const auto hit = firstHit(object, point - 2. * direction, direction);
        ASSERT_TRUE(hit);
        if (hit->on != HitOn::Front)
            continue; // through the side of the box
        EXPECT_LT(glm::length(hit->point - point), 5e-5);
        EXPECT_LT(glm::length(hit->normal - glm::normalize(glm::dvec3(0.4, -0.2, 1.))), 1e-3);
    }
}

// Every hit is inside and nothing before it is, whatever the maps hold.
TEST(ReliefObject, NothingIsInsideBeforeTheFirstHit)
{
    Random random(3);
    int hits = 0, misses = 0;
    for (int round = 0; round < 400; ++round) {
        ReliefObject object;
        place(object);
        const int layers = 1 + int(random() % 4);
        for (AxisMap& map : object.axes)
            if (random() % 4 > 0)
                map = randomMap(random, layers, round % 3 == 0);
        if (!checkObject(object))
            continue;
        for (int i = 0; i < 25; ++i) {
            const glm::dvec3 direction = i % 5 == 0 ? glm::normalize(object.half[random() % 3]) : anyDirection(random);
            const glm::dvec3 aim = object.center + uniform(random, -1., 1.) * object.half[0] + uniform(random, -1., 1.) * object.half[1]
                + uniform(random, -1., 1.) * object.half[2];
            const glm::dvec3 origin = aim - (i % 7 == 0 ? 0. : 5.) * direction;
            const auto hit = firstHit(object, origin, direction);
            ++(hit ? hits : misses);
            const double end = hit ? hit->t : 10.;
            for (int s = 0; s < 500; ++s) {
                const double t = end * (s + uniform(random, 0., 1.)) / 500. - 1e-7;
                ASSERT_FALSE(t >= 0. && isInside(object, origin + t * direction)) << round << ' ' << i << ' ' << t << ' ' << end;
            }
            if (hit && hit->t > 0.) {
                const auto isNear = [&](double t) { return isInside(object, origin + t * direction); };
                EXPECT_TRUE(isNear(hit->t + 1e-9) || isNear(hit->t)) << round << ' ' << i;
                EXPECT_LT(glm::dot(hit->normal, direction), 1e-9);
                EXPECT_NEAR(glm::length(hit->normal), 1., 1e-9);
            }
        }
    }
    EXPECT_GT(hits, 1000);
    EXPECT_GT(misses, 1000);
}

// A leaf: front and back in one place.
TEST(ReliefObject, WhatHasNoThicknessIsMetFromBothSides)
{
    ReliefObject object;
    object.axes[2] = {8, 8, 1, {}};
    Random random(4);
    for (int i = 0; i < 64; ++i) {
        const auto depth = std::uint16_t(20000 + random() % 20000);
        object.axes[2].intervals.push_back({depth, depth});
    }
    for (int i = 0; i < 500; ++i) {
        const double side = i % 2 ? 1. : -1.;
        const glm::dvec3 aim{uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2), 0.};
        const glm::dvec3 direction{uniform(random, -0.3, 0.3), uniform(random, -0.3, 0.3), -side};
        const auto hit = firstHit(object, aim - direction, direction);
        ASSERT_TRUE(hit) << i;
        EXPECT_EQ(hit->on, side > 0. ? HitOn::Front : HitOn::Back);
        EXPECT_LT(glm::dot(hit->normal, direction), 0.);
    }
}

TEST(ReliefObject, BadMapsAreToldOrRefused)
{
    ReliefObject object = fullBox();
    ASSERT_TRUE(checkObject(object));
    EXPECT_TRUE(checkObject(object)->empty());
    object.axes[1] = {2, 1, 2, {{10, 20}, {30, 40}, {50, 40}, {}}}; // the third runs backwards
    auto told = checkObject(object);
    ASSERT_TRUE(told);
    ASSERT_EQ(told->size(), 1u);
    EXPECT_EQ(told->front().code, "back-before-front");
    EXPECT_FALSE(isInside(object, {0.4, 0., 0.}));
    object.axes[1].intervals = {{10, 20}, {15, 40}, {}, {5, 6}};
    told = checkObject(object);
    ASSERT_TRUE(told && told->size() == 1);
    EXPECT_EQ(told->front().code, "layers-cross");
    object.axes[1].intervals.pop_back();
    EXPECT_FALSE(checkObject(object));
    object = fullBox();
    object.half[0] = {};
    EXPECT_FALSE(checkObject(object));
    EXPECT_FALSE(checkObject(ReliefObject()));
    EXPECT_FALSE(firstHit(ReliefObject(), {0., 0., 5.}, {0., 0., -1.}));
}

TEST(ReliefObject, AnEmptyOneIsNeverMet)
{
    ReliefObject object = fullBox();
    object.axes[0].intervals = {{}};
    Random random(5);
    for (int i = 0; i < 100; ++i)
        EXPECT_FALSE(firstHit(object, 2. * anyDirection(random), anyDirection(random)));
}

TEST(ReliefObject, RaysThatAreNotFiniteMeetNothing)
{
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    for (const double odd : {nan, infinity, -infinity}) {
        EXPECT_FALSE(firstHit(fullBox(), {odd, 0., 0.}, {0., 0., 1.}));
        EXPECT_FALSE(firstHit(fullBox(), {0., 0., 0.}, {0., odd, 1.}));
    }
    EXPECT_FALSE(firstHit(fullBox(), {0., 0., 0.}, {0., 0., 0.}));
}
