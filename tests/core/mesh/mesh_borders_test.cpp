// Borders of the relief: which edges are some, which triangles know of them, and that seams are none.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edges/across.h"
#include "core/mesh/edges/borders.h"
#include "core/mesh/frames/frames.h"
#include "core/mesh/shapes/shapes.h"
#include <algorithm>
#include <gtest/gtest.h>

using namespace relievo;

namespace {

std::span<const glm::vec4> of(const Borders& borders, std::size_t triangle)
{
    return std::span(borders.segments).subspan(borders.starts[triangle], borders.starts[triangle + 1] - borders.starts[triangle]);
}

float turn(glm::vec2 a, glm::vec2 b)
{
    return a.x * b.y - a.y * b.x;
}

glm::vec2 middleOf(const Mesh& mesh, std::size_t triangle)
{
    const auto uv = [&](std::size_t k) { return mesh.vertices[mesh.indices[3 * triangle + k]].uv; };
    return (uv(0) + uv(1) + uv(2)) / 3.f;
}

// An L of three unit squares, open all around.
Mesh corner()
{
    Mesh mesh;
    for (const glm::vec2 uv : {glm::vec2{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {0, 2}, {1, 2}})
        mesh.vertices.push_back(
            {.position = {uv.x, 0.f, uv.y}, .normal = {0.f, 1.f, 0.f}, .uv = uv, .tangent = {}, .dPdu = {}, .dPdv = {}});
    mesh.indices = {0, 3, 4, 0, 4, 1, 1, 4, 5, 1, 5, 2, 3, 6, 7, 3, 7, 4};
    mesh.parts = {{"L", "", 0, 18}};
    completeFrames(mesh);
    return mesh;
}

// A strip of `quads` squares of 1 cm in xz; all their UVs are one point when `mapped` is false.
Mesh strip(std::uint32_t quads, bool mapped)
{
    Mesh mesh;
    for (std::uint32_t i = 0; i <= quads; ++i)
        for (const float z : {0.f, 0.01f})
            mesh.vertices.push_back({.position = {0.01f * float(i), 0.f, z},
                .normal = {0.f, 1.f, 0.f},
                .uv = mapped ? glm::vec2(0.01f * float(i), z) : glm::vec2(0.f),
                .tangent = {},
                .dPdu = {},
                .dPdv = {}});
    for (std::uint32_t i = 0; i < 2 * quads; i += 2)
        mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + 3, i, i + 3, i + 2});
    mesh.parts = {{"strip", "", 0, std::uint32_t(mesh.indices.size())}};
    completeFrames(mesh);
    return mesh;
}

// `count` triangles that all have the edge from (0, 0, 0) to (0, 0, 1), and as many that run back along it.
Mesh book(int count)
{
    Mesh mesh;
    for (int i = 0; i < 2 * count; ++i) {
        const std::uint32_t first = std::uint32_t(mesh.vertices.size());
        for (const glm::vec3 p : {glm::vec3(0.f), glm::vec3(0.f, 0.f, 1.f), glm::vec3(i % 2 == 0 ? 1.f : -1.f, 0.f, 0.5f)})
            mesh.vertices.push_back({.position = p, .normal = {0.f, 1.f, 0.f}, .uv = {p.x, p.z}, .tangent = {}, .dPdu = {}, .dPdv = {}});
        mesh.indices.insert(mesh.indices.end(), {first + std::uint32_t(i % 2), first + 1 - std::uint32_t(i % 2), first + 2});
    }
    mesh.parts = {{"book", "", 0, std::uint32_t(mesh.indices.size())}};
    completeFrames(mesh);
    return mesh;
}

} // namespace

// What follows keeps the cost of large meshes in proportion to their size.
TEST(Borders, EdgesOfVeryManyTrianglesAndOfNoLengthGoOnNowhere)
{
    const std::vector<std::uint32_t> few = edgesAcross(book(16)), many = edgesAcross(book(17));
    for (std::size_t e = 0; e < few.size(); e += 3)
        EXPECT_NE(few[e], kNoEdge) << e;
    for (const std::uint32_t other : many)
        EXPECT_EQ(other, kNoEdge);
    Mesh point = strip(1, true);
    point.indices.insert(point.indices.end(), {0, 0, 0, 1, 1, 1});
    const std::vector<std::uint32_t> across = edgesAcross(point);
    for (std::size_t e = 6; e < across.size(); ++e)
        EXPECT_EQ(across[e], kNoEdge) << e;
}

TEST(Borders, OneSegmentStandsForAtMost256Edges)
{
    const Borders borders = bordersOf(strip(600, true));
    ASSERT_FALSE(borders.starts.empty());
    float longest = 0.f;
    for (const glm::vec4 s : borders.segments)
        longest = std::max(longest, glm::distance(glm::vec2(s.x, s.y), glm::vec2(s.z, s.w)));
    EXPECT_NEAR(longest, 2.56f, 1e-4f);
}

TEST(Borders, TrianglesWithoutAnAreaInTheTextureHaveNone)
{
    EXPECT_TRUE(bordersOf(strip(10, false)).segments.empty());
    EXPECT_FALSE(bordersOf(strip(10, true)).segments.empty());
}

TEST(Borders, SmoothClosedShapesHaveNone)
{
    for (const char* closed : {"sphere", "torus", "teapot"}) {
        const Borders borders = bordersOf(*makeShape(closed));
        EXPECT_TRUE(borders.segments.empty()) << closed;
        EXPECT_TRUE(borders.starts.empty()) << closed;
    }
}

TEST(Borders, PlaneAndBoxKnowAllFourSides)
{
    for (const char* shape : {"plane", "box"}) {
        const Mesh mesh = *makeShape(shape);
        const Borders borders = bordersOf(mesh);
        ASSERT_EQ(borders.starts.size(), mesh.indices.size() / 3 + 1) << shape;
        for (std::size_t i = 0; i + 1 < borders.starts.size(); ++i) {
            EXPECT_EQ(of(borders, i).size(), 4u) << shape;
            for (const glm::vec4 s : of(borders, i)) { // the surface lies on their left
                const glm::vec2 from(s.x, s.y), to(s.z, s.w);
                EXPECT_GT(turn(to - from, middleOf(mesh, i) - from), 0.f) << shape;
                EXPECT_FLOAT_EQ(glm::distance(from, to), 1.f) << shape;
            }
        }
    }
}

TEST(Borders, CylinderEndsAtItsCapsAndNotAtItsSeam)
{
    const Mesh mesh = *makeShape("cylinder");
    const Borders borders = bordersOf(mesh);
    int sides = 0, caps = 0, atSeam = 0;
    for (std::size_t i = 0; i + 1 < borders.starts.size(); ++i) {
        const bool side = std::abs(mesh.vertices[mesh.indices[3 * i]].normal.y) < 0.5f;
        const glm::vec2 middle = middleOf(mesh, i);
        (side ? sides : caps) += !of(borders, i).empty();
        for (const glm::vec4 s : of(borders, i)) {
            if (!side) { // rim of the cap, 2 tiles a metre
                EXPECT_NEAR(glm::distance(glm::vec2(s.x, s.y), glm::vec2(0.5f)), 2.f / 3.14159265f, 1e-4f);
                continue;
            }
            EXPECT_FLOAT_EQ(s.y, s.w);
            EXPECT_TRUE(std::abs(s.y) < 1e-5f || std::abs(s.y - 2.f) < 1e-5f);
            EXPECT_LE(std::abs(s.y - middle.y), 0.6f); // within reach
            // What lies beyond the seam is seen beyond the seam: the whole rim is one segment and its copy 4 tiles on.
            atSeam += middle.x < 0.1f && s.x < -0.1f && s.z < 0.1f;
            atSeam += middle.x > 3.9f && s.x > 3.9f && s.z > 4.1f;
        }
    }
    EXPECT_EQ(caps, 2 * 7 * 144); // all but the middle, which is out of reach
    EXPECT_GT(sides, 72 * 2 * 6);
    EXPECT_LT(sides, 72 * 2 * 16);
}

TEST(Borders, ConcaveEdgesAreNone)
{
    Mesh room = *makeShape("box"); // seen from inside
    for (std::size_t i = 0; i < room.indices.size(); i += 3)
        std::swap(room.indices[i], room.indices[i + 1]);
    for (Vertex& v : room.vertices)
        v.normal = -v.normal;
    completeFrames(room);
    EXPECT_TRUE(bordersOf(room).segments.empty());
}

// A way through a concave patch that stays inside crosses nothing in the end, also where it comes near the corner.
TEST(Borders, ConcavePatchesKeepTheirInside)
{
    const Mesh mesh = corner();
    const Borders borders = bordersOf(mesh, {.reach = 3.f});
    const auto crossings = [&](std::size_t triangle, glm::vec2 from, glm::vec2 to) {
        int outwards = 0;
        for (const glm::vec4 s : of(borders, triangle)) {
            const glm::vec2 a(s.x, s.y), b(s.z, s.w);
            const bool fromLeft = turn(b - a, from - a) > 0.f, toLeft = turn(b - a, to - a) > 0.f;
            if (fromLeft != toLeft && (turn(to - from, a - from) > 0.f) != (turn(to - from, b - from) > 0.f))
                outwards += fromLeft ? 1 : -1;
        }
        return outwards;
    };
    EXPECT_LT(of(borders, 0).size(), 8u); // of 8 edges: straight runs are one
    EXPECT_EQ(crossings(2, {1.5f, 0.9f}, {0.9f, 0.95f}), 0);
    EXPECT_EQ(crossings(2, {1.5f, 0.9f}, {0.2f, 0.2f}), 0);
    EXPECT_EQ(crossings(2, {1.5f, 0.5f}, {1.5f, 1.5f}), 1); // over the inner corner's edge
    EXPECT_EQ(crossings(2, {1.8f, 0.9f}, {0.9f, 1.8f}), 0); // out over the gap and in again
    EXPECT_EQ(crossings(2, {1.5f, 0.5f}, {1.5f, -0.5f}), 1);
}

TEST(Borders, KeepToTheirLimits)
{
    const Mesh cylinder = *makeShape("cylinder");
    const Borders few = bordersOf(cylinder, {.reach = 0.5f, .perTriangle = 3});
    std::size_t most = 0;
    for (std::size_t i = 0; i + 1 < few.starts.size(); ++i)
        most = std::max(most, of(few, i).size());
    EXPECT_EQ(most, 3u);
    EXPECT_LE(bordersOf(cylinder, {.budget = 1000}).segments.size(), 1000u);
    EXPECT_GT(bordersOf(cylinder, {.reach = 0.5f}).segments.size(), bordersOf(cylinder, {.reach = 0.1f}).segments.size());
}
