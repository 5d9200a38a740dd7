// The displaced mesh: micro-triangles against the exact search on a plane, and against a sphere of known radius.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edges/closed.h"
#include "core/mesh/shapes/shapes.h"
#include "core/trace/displaced_mesh.h"
#include "core/trace/exact_search.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

using namespace relievo;

namespace {
HeightField waves(int size)
{
    std::vector<float> heights;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            heights.push_back(0.5f + 0.5f * std::sin(float(x) * 6.2831853f / float(size)) * std::cos(float(y) * 12.566371f / float(size)));
    return {size, size, std::move(heights)};
}
} // namespace

TEST(DisplacedMesh, PlaneAgreesWithTheExactSearch)
{
    const Mesh plane = *makeShape("plane");
    const HeightField field = waves(64);
    Parameters parameters;
    parameters.depth = 0.2f, parameters.midlevel = 0.5f;
    const auto surface = DisplacedMesh::build(plane, field, parameters, {});
    ASSERT_TRUE(surface);
    EXPECT_GE(surface->triangles(), 8u * 64u * 64u);
    EXPECT_GT(surface->bytes(), surface->triangles() * 12);
    EXPECT_EQ(surface->coarseness(), 1.f);
    const ExactSearch exact(field);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1., 1.);
    for (int i = 0; i < 500; ++i) {
        // From the pushed-out plane (y = 0.1) down through the depth of 0.2 m.
        const glm::dvec2 from(0.25 * unit(random), 0.25 * unit(random)), shift(0.2 * unit(random), 0.2 * unit(random));
        const SearchHit hit = exact.hit({from + 0.5, shift, 0.5});
        const glm::dvec3 way(shift.x, -0.2, shift.y);
        const float distance = surface->hit(glm::vec3(glm::dvec3(from.x, 0.1, from.y) - way), glm::vec3(glm::normalize(way))).distance;
        EXPECT_NEAR(double(distance) / glm::length(way) - 1., hit.t, 2e-3);
    }
}

TEST(DisplacedMesh, SphereShrinksByTheDepth)
{
    const Mesh sphere = *makeShape("sphere");
    Parameters parameters;
    parameters.depth = 0.1f;
    const auto surface = DisplacedMesh::build(sphere, HeightField(8, 8, std::vector<float>(64, 0.f)), parameters, {});
    ASSERT_TRUE(surface);
    const float depth = 0.1f * sphere.metresPerUV;
    EXPECT_NEAR(surface->hit({0.f, 0.1f, 2.f}, {0.f, 0.f, -1.f}).distance, 2.f - std::sqrt((0.5f - depth) * (0.5f - depth) - 0.01f), 1e-3f);
    EXPECT_TRUE(std::isinf(surface->hit({0.f, 0.5f - 0.5f * depth, 2.f}, {0.f, 0.f, -1.f}).distance)); // between it and the mesh
}

TEST(DisplacedMesh, TheInsideOfAClosedMeshIsNotSeen)
{
    const HeightField low(8, 8, std::vector<float>(64, 0.f));
    Parameters parameters;
    parameters.depth = 0.1f;
    const auto box = DisplacedMesh::build(*makeShape("box"), low, parameters, {}),
               plane = DisplacedMesh::build(*makeShape("plane"), low, parameters, {});
    ASSERT_TRUE(box && plane);
    // Between the top and its sheet, towards the back of the next side's sheet.
    EXPECT_TRUE(std::isinf(box->hit({0.f, 0.45f, 0.f}, {1.f, 0.f, 0.f}).distance));
    EXPECT_NEAR(box->hit({2.f, 0.45f, 0.f}, {-1.f, 0.f, 0.f}).distance, 1.6f, 1e-5f);
    EXPECT_NEAR(plane->hit({0.f, -1.f, 0.f}, {0.f, 1.f, 0.f}).distance, 0.9f, 1e-5f); // an open one has two sides
}

TEST(DisplacedMesh, SeamsAreClosedByWalls)
{
    // The plane cut along x = 0; the right half sees another place of the texture, 0.1 m lower than the left.
    Mesh mesh = *makeShape("plane");
    const std::vector<Vertex> old = mesh.vertices;
    mesh.vertices.clear(), mesh.indices.clear();
    for (const float side : {-0.5f, 0.f})
        for (const float z : {-0.5f, 0.5f})
            for (const float x : {side, side + 0.5f}) {
                mesh.vertices.push_back(old.front());
                mesh.vertices.back().position = {x, 0.f, z};
                mesh.vertices.back().uv = {side < 0.f ? 0.25f : 0.75f, 0.5f};
            }
    for (const std::uint32_t first : {0u, 4u})
        for (const std::uint32_t k : {0u, 2u, 1u, 1u, 2u, 3u})
            mesh.indices.push_back(first + k);
    mesh.parts = {{}};
    mesh.parts.front().indexCount = 12;
    Parameters parameters;
    parameters.depth = 0.1f;
    const HeightField field(4, 1, {1.f, 1.f, 0.f, 0.f});
    const auto surface = DisplacedMesh::build(mesh, field, parameters, {});
    ASSERT_TRUE(surface);
    EXPECT_NEAR(surface->hit({-0.3f, 1.f, 0.1f}, {0.f, -1.f, 0.f}).distance, 1.f, 1e-5f);
    EXPECT_NEAR(surface->hit({0.3f, 1.f, 0.1f}, {0.f, -1.f, 0.f}).distance, 1.1f, 1e-5f);
    EXPECT_NEAR(surface->hit({0.4f, -0.05f, 0.1f}, {-1.f, 0.f, 0.f}).distance, 0.4f, 1e-5f);
    EXPECT_TRUE(surface->hit({0.3f, -1.f, 0.1f}, {0.f, 1.f, 0.f}).back);
    EXPECT_FALSE(surface->hit({0.3f, 1.f, 0.1f}, {0.f, -1.f, 0.f}).back);
}

TEST(DisplacedMesh, KeepsToItsBudgetAndSaysSo)
{
    const auto surface = DisplacedMesh::build(*makeShape("torus"), waves(256), Parameters(), {.maxTriangles = 50'000});
    ASSERT_TRUE(surface);
    EXPECT_LE(surface->triangles(), 50'000u);
    EXPECT_GT(surface->coarseness(), 2.f);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(DisplacedMesh::build(*makeShape("torus"), waves(256), Parameters(), {}, Progress{{}, stop.get_token()}));
}

TEST(ClosedMesh, KnowsInsideFromOutside)
{
    for (const char* closed : {"sphere", "torus", "box", "cylinder", "teapot"})
        EXPECT_TRUE(isClosed(*makeShape(closed))) << closed;
    EXPECT_FALSE(isClosed(*makeShape("plane")));
    Mesh inverted = *makeShape("sphere");
    for (std::size_t i = 0; i < inverted.indices.size(); i += 3)
        std::swap(inverted.indices[i], inverted.indices[i + 1]);
    EXPECT_FALSE(isClosed(inverted));
    Mesh open = *makeShape("torus");
    open.indices.resize(open.indices.size() - 3);
    EXPECT_FALSE(isClosed(open));
}
