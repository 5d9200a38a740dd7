// Relief objects baked from meshes: what is inside, whatever the mesh is like.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/bake/bake_object.h"
#include "core/object/object_search.h"
#include "tests/core/object/object_meshes.h"

using namespace relievo;
using namespace relievo::test;

namespace {
ObjectOptions sized(int size, int layers = 1, ObjectSides sides = ObjectSides::Six, int supersample = 1)
{
    return {sides, layers, size, supersample};
}

glm::dvec3 anyPoint(std::mt19937& random, glm::dvec3 half)
{
    std::uniform_real_distribution<double> share(-1., 1.);
    return half * glm::dvec3(share(random), share(random), share(random));
}

// How many of random points in a box around the origin are inside of just one of the two.
template <class Exact> double disagreement(const ReliefObject& object, glm::dvec3 half, Exact exact)
{
    std::mt19937 random(7);
    int wrong = 0;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 point = anyPoint(random, half);
        wrong += isInside(object, point) != exact(point);
    }
    return double(wrong) / count;
}

// All intervals of a map are this one.
void expectFilled(const AxisMap& map, Interval wanted)
{
    ASSERT_TRUE(map.isGiven());
    std::size_t others = 0;
    for (const Interval& interval : map.intervals)
        others += interval != wanted;
    EXPECT_EQ(others, 0u);
}
constexpr Interval kFull{0, Interval::kDeepest};
} // namespace

TEST(BakeObject, ABoxFillsItsBounds)
{
    for (const int size : {1, 2, 7, 64}) {
        const BakedDepths baked = bakedDepths(meshOf(boxCorners({-1.f, 2.f, 0.f}, {3.f, 3.f, 0.5f})), sized(size));
        EXPECT_TRUE(baked.warnings.empty());
        EXPECT_EQ(baked.object.center, glm::dvec3(1., 2.5, 0.25));
        EXPECT_EQ(baked.object.half[0], glm::dvec3(2., 0., 0.));
        EXPECT_EQ(baked.object.half[1], glm::dvec3(0., 0.5, 0.));
        for (const AxisMap& map : baked.object.axes)
            expectFilled(map, kFull);
        EXPECT_TRUE(checkObject(baked.object));
    }
}

// Rays run through edges and corners: each texel's middle lies on some.
TEST(BakeObject, SurfacesAreCrossedOnceWhereTrianglesMeet)
{
    constexpr int size = 8; // texel centres at odd sixteenths
    std::vector<glm::vec3> corners;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const glm::vec3 low{float(x) / 16.f, float(y) / 16.f, 0.f};
            corners = corners + boxCorners(low, low + glm::vec3(1.f / 16.f, 1.f / 16.f, 1.f));
        }
    const BakedDepths baked = bakedDepths(meshOf(corners), sized(size, 4));
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < baked.object.axes[axis].intervals.size(); i += 4) {
            EXPECT_EQ(baked.object.axes[axis].intervals[i], kFull);
            EXPECT_FALSE(baked.object.axes[axis].intervals[i + 1].isSolid());
        }
    std::vector<glm::vec3> cone;
    for (int i = 0; i < 12; ++i) {
        const auto at = [](int k) { return glm::vec3(std::cos(float(k) * 0.5235988f), std::sin(float(k) * 0.5235988f), 0.f); };
        cone = cone + std::vector<glm::vec3>{glm::vec3(0.f, 0.f, 1.f), at(i), at((i + 1) % 12), glm::vec3(0.f), at((i + 1) % 12), at(i)};
    }
    const BakedDepths spike = bakedDepths(meshOf(cone), sized(9, 4)); // its tip lies on a texel's middle
    const AxisMap& map = spike.object.axes[2];
    EXPECT_EQ(map.at(4, 4, 0), kFull);
    EXPECT_FALSE(map.at(4, 4, 1).isSolid());
}

TEST(BakeObject, ASphereIsMetWhereItIs)
{
    const auto sphere = makeShape("sphere");
    ASSERT_TRUE(sphere);
    const BakedDepths baked = bakedDepths(*sphere, sized(128));
    EXPECT_FALSE(isTold(baked.warnings, "open-mesh"));
    std::mt19937 random(1);
    double sum = 0.;
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 direction = glm::normalize(anyPoint(random, glm::dvec3(1.)) + glm::dvec3(0., 0., 1e-3));
        const auto hit = firstHit(baked.object, anyPoint(random, glm::dvec3(0.2)) - 2. * direction, direction);
        ASSERT_TRUE(hit);
        sum += std::pow(glm::length(hit->point) - 0.5, 2.);
        ++hits;
    }
    EXPECT_LT(std::sqrt(sum / hits), 0.25 / 128.);
}

// Between many spheres there are places that are walled in along all axes: six height fields fill them, layers do not.
TEST(BakeObject, LayersHoldWhatHeightFieldsCannot)
{
    const auto sphere = makeShape("sphere");
    ASSERT_TRUE(sphere);
    std::mt19937 random(9);
    std::vector<glm::vec3> corners;
    std::vector<glm::dvec3> centers;
    for (int i = 0; i < 16; ++i) {
        centers.push_back(anyPoint(random, glm::dvec3(1.)));
        for (const std::uint32_t index : sphere->indices)
            corners.push_back(glm::vec3(centers.back()) + 0.7f * sphere->vertices[index].position);
    }
    const Mesh mesh = meshOf(corners);
    const auto exact = [&](glm::dvec3 point) {
        return std::ranges::any_of(centers, [&](glm::dvec3 center) { return glm::length(point - center) <= 0.35; });
    };
    const BakedDepths one = bakedDepths(mesh, sized(256, 1)), four = bakedDepths(mesh, sized(256, 4));
    EXPECT_TRUE(isTold(one.warnings, "layers-merged"));
    const double ofFour = disagreement(four.object, glm::dvec3(1.), exact);
    EXPECT_GT(disagreement(one.object, glm::dvec3(1.), exact), 2. * ofFour);
    EXPECT_LT(ofFour, 0.003);
}

// Where something begins or ends beside a part of the surface, that part stays in its layer.
TEST(BakeObject, ALayerFollowsOnePartOfTheSurface)
{
    for (const bool mirrored : {false, true}) {
        const float from = mirrored ? -1.f : 0.f;
        const Mesh mesh = meshOf(boxCorners({-1.f, -1.f, 0.f}, {1.f, 1.f, 0.5f}) + boxCorners({from, -1.f, 0.7f}, {from + 1.f, 1.f, 1.f}));
        const AxisMap map = bakedDepths(mesh, sized(8, 2, ObjectSides::Two)).object.axes[2];
        for (int x = 0; x < 8; ++x) {
            EXPECT_EQ(map.at(x, 4, 0).isSolid(), mirrored ? x < 4 : x >= 4) << x;
            EXPECT_EQ(map.at(x, 4, 1).front, 32768) << x;
        }
    }
}

TEST(BakeObject, WhatFacesInwardsIsTheSameObject)
{
    const Mesh right = meshOf(boxCorners({0.f, 0.f, 0.f}, {1.f, 1.f, 1.f}) + boxCorners({2.f, 0.f, 0.f}, {3.f, 2.f, 1.f}));
    const Mesh turned = meshOf(boxCorners({0.f, 0.f, 0.f}, {1.f, 1.f, 1.f}, true) + boxCorners({2.f, 0.f, 0.f}, {3.f, 2.f, 1.f}, true));
    const BakedDepths a = bakedDepths(right, sized(30, 2)), b = bakedDepths(turned, sized(30, 2));
    EXPECT_EQ(a.object, b.object);
    EXPECT_TRUE(a.warnings.empty());
    EXPECT_TRUE(isTold(b.warnings, "facing-inwards"));
}

TEST(BakeObject, AShellInAShellIsACavityOnlyIfItFacesIn)
{
    for (const bool inwards : {false, true}) {
        const Mesh mesh = meshOf(boxCorners(glm::vec3(-1.f), glm::vec3(1.f)) + boxCorners(glm::vec3(-0.5f), glm::vec3(0.5f), inwards));
        const BakedDepths baked = bakedDepths(mesh, sized(32, 2));
        EXPECT_TRUE(baked.warnings.empty());
        EXPECT_EQ(isInside(baked.object, {0.1, 0.2, 0.}), !inwards);
        EXPECT_TRUE(isInside(baked.object, {0.8, 0.1, 0.}));
    }
}

// A box whose top is missing but for a rim, and whose sides overlap: half of the winding decides, and it is told once.
TEST(BakeObject, AnOpenMeshIsFilledWhereItWindsAround)
{
    auto corners = boxCorners(glm::vec3(-1.f), glm::vec3(1.f));
    corners.erase(corners.begin(), corners.begin() + 3); // half a face
    const BakedDepths baked = bakedDepths(meshOf(corners), sized(40));
    EXPECT_TRUE(isTold(baked.warnings, "open-mesh"));
    EXPECT_EQ(baked.warnings.size(), 1u);
    EXPECT_TRUE(isInside(baked.object, {0., 0., 0.}));
    EXPECT_TRUE(isInside(baked.object, {0.5, 0.3, -0.2}));
    EXPECT_LT(disagreement(baked.object, glm::dvec3(1.), [](glm::dvec3) { return true; }), 0.12);
}

// A tube without ends: rays along it meet no surface, and yet go through what it encloses.
TEST(BakeObject, AHoleIsClosedWhereNoSurfaceIs)
{
    auto corners = boxCorners(glm::vec3(-1.f), glm::vec3(1.f));
    corners.resize(24); // no faces across z
    const BakedDepths baked = bakedDepths(meshOf(corners), sized(33));
    EXPECT_TRUE(isTold(baked.warnings, "open-mesh"));
    const auto hit = firstHit(baked.object, {0.05, 0.02, 3.}, {0., 0., -1.});
    ASSERT_TRUE(hit);
    EXPECT_GT(hit->t, 2.1); // half of the winding lies within the tube
    EXPECT_LT(hit->t, 2.9);
    EXPECT_TRUE(isInside(baked.object, {0., 0., 0.}));
}

// Cards in all directions: each is met from both sides where it lies, and beside it nothing.
TEST(BakeObject, SheetsAreMetFromBothSides)
{
    std::mt19937 random(5);
    for (int i = 0; i < 12; ++i) {
        glm::dvec3 normal = i < 3 ? glm::dvec3(i == 0, i == 1, i == 2) : glm::normalize(anyPoint(random, glm::dvec3(1.)));
        const glm::dvec3 u = glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.6 ? glm::dvec3(1., 0., 0.) : glm::dvec3(0., 1., 0.)));
        const glm::dvec3 v = glm::cross(normal, u);
        const BakedDepths baked = bakedDepths(meshOf(quad(-u - v, u - v, u + v, v - u)), sized(64, 1, ObjectSides::Six, 2));
        EXPECT_TRUE(isTold(baked.warnings, "open-mesh"));
        int wrong = 0;
        for (int k = 0; k < 400; ++k) {
            const glm::dvec3 share = anyPoint(random, glm::dvec3(1.2, 1.2, 0.5));
            const bool isOn = std::abs(share.x) < 0.93 && std::abs(share.y) < 0.93;
            const bool isBeside = std::abs(share.x) > 1.1 || std::abs(share.y) > 1.1;
            const glm::dvec3 aim = share.x * u + share.y * v;
            const glm::dvec3 direction = glm::normalize((k % 2 ? 1. : -1.) * normal + 0.3 * share.z * u + 0.2 * share.x * v);
            const auto hit = firstHit(baked.object, aim - 3. * direction, direction);
            wrong += isOn && (!hit || std::abs(hit->t - 3.) > 0.02);
            wrong += isBeside && hit;
        }
        EXPECT_LE(wrong, 4) << normal.x << ' ' << normal.y << ' ' << normal.z;
    }
}

TEST(BakeObject, AFlatMeshHasABoxAndIsTold)
{
    for (const ObjectSides sides : {ObjectSides::One, ObjectSides::Two, ObjectSides::Six}) {
        const BakedDepths baked
            = bakedDepths(meshOf(quad({-1.f, -1.f, 0.f}, {1.f, -1.f, 0.f}, {1.f, 1.f, 0.f}, {-1.f, 1.f, 0.f})), sized(16, 1, sides));
        EXPECT_TRUE(isTold(baked.warnings, "flat-mesh"));
        const auto hit = firstHit(baked.object, {0.3, 0.2, 5.}, {0., 0., -1.});
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, 5., 2e-3);
    }
}

TEST(BakeObject, OneSideReachesBackAndTwoSidesDoNot)
{
    const Mesh mesh = meshOf(boxCorners({-1.f, -1.f, 0.f}, {0.f, 1.f, 1.f}) + boxCorners({0.f, -1.f, -1.f}, {1.f, 1.f, 0.f}));
    const BakedDepths one = bakedDepths(mesh, sized(8, 1, ObjectSides::One)), two = bakedDepths(mesh, sized(8, 1, ObjectSides::Two));
    for (const BakedDepths* baked : {&one, &two}) {
        EXPECT_FALSE(baked->object.axes[0].isGiven() || baked->object.axes[1].isGiven());
        EXPECT_EQ(baked->object.axes[2].at(1, 3, 0).front, 0);
        EXPECT_NEAR(baked->object.axes[2].at(6, 3, 0).front, 32768, 1);
    }
    EXPECT_EQ(one.object.axes[2].at(1, 3, 0).back, Interval::kDeepest);
    EXPECT_NEAR(two.object.axes[2].at(1, 3, 0).back, 32768, 1);
}

// Bars that no middle of a texel meets are kept by the rays beside it.
TEST(BakeObject, WhatIsThinnerThanATexelIsKeptBySupersampling)
{
    std::vector<glm::vec3> corners = boxCorners({-1.f, -1.f, -1.f}, {1.f, -0.9f, 1.f});
    for (int i = 0; i < 4; ++i)
        corners = corners + boxCorners({-0.8f + 0.4f * float(i), -0.95f, -0.1f}, {-0.78f + 0.4f * float(i), 1.f, 0.1f});
    const auto bars = [&](int supersample) {
        const BakedDepths baked = bakedDepths(meshOf(corners), sized(16, 1, ObjectSides::Two, supersample));
        int filled = 0;
        for (int x = 0; x < 16; ++x)
            filled += baked.object.axes[2].at(x, 4, 0).isSolid();
        return filled;
    };
    EXPECT_LT(bars(1), 4);
    EXPECT_GE(bars(8), 4);
}

// Of four bars behind each other with gaps of 0.1, 0.3 and 0.2, two layers keep the widest gap open.
TEST(BakeObject, TheNarrowestGapsAreClosedFirst)
{
    std::vector<glm::vec3> corners;
    for (const float z : {0.f, 0.2f, 0.6f, 0.9f})
        corners = corners + boxCorners({0.f, 0.f, z}, {1.f, 1.f, z + 0.1f});
    const BakedDepths baked = bakedDepths(meshOf(corners), sized(4, 2));
    EXPECT_TRUE(isTold(baked.warnings, "layers-merged"));
    const AxisMap& map = baked.object.axes[2];
    EXPECT_EQ(map.at(1, 1, 0).front, 0);
    EXPECT_NEAR(map.at(1, 1, 0).back, 0.4 * 65535., 1.);
    EXPECT_NEAR(map.at(1, 1, 1).front, 0.7 * 65535., 1.);
    EXPECT_EQ(map.at(1, 1, 1).back, Interval::kDeepest);
    const BakedDepths all = bakedDepths(meshOf(corners), sized(4, 4));
    EXPECT_TRUE(all.warnings.empty());
    EXPECT_TRUE(all.object.axes[2].at(1, 1, 3).isSolid());
}

TEST(BakeObject, ThousandsOfPartsAreBaked)
{
    std::mt19937 random(3);
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 at = anyPoint(random, glm::dvec3(1.));
        corners = corners + boxCorners(at - 0.02f, at + 0.02f);
    }
    const BakedDepths baked = bakedDepths(meshOf(corners), sized(64, 4));
    EXPECT_FALSE(isTold(baked.warnings, "open-mesh"));
    EXPECT_TRUE(checkObject(baked.object));
}

TEST(BakeObject, WhatCannotBeBakedIsRefused)
{
    const Mesh point = meshOf({{1.f, 1.f, 1.f}, {1.f, 1.f, 1.f}, {1.f, 1.f, 1.f}});
    const auto nothing = MeshSurface::load(point, {});
    ASSERT_TRUE(nothing);
    EXPECT_FALSE(bakeDepths(*nothing, sized(8)));
    const Mesh box = meshOf(boxCorners(glm::vec3(0.f), glm::vec3(1.f)));
    const auto surface = MeshSurface::load(box, {});
    ASSERT_TRUE(surface);
    for (const ObjectOptions& odd : {sized(0), sized(kLargestObjectMap + 1), sized(8, 0), sized(8, 5), sized(8, 1, ObjectSides::Six, 9)})
        EXPECT_FALSE(bakeDepths(*surface, odd));
    std::stop_source stop;
    stop.request_stop();
    const auto stopped = bakeDepths(*surface, sized(8), {{}, stop.get_token()});
    ASSERT_FALSE(stopped);
    EXPECT_TRUE(isCancelled(stopped.error()));
}
