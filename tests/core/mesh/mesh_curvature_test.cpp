// Curvature at the vertices agrees with the formula of the surface, for any UVs, and stays finite on any mesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/frames/curvature.h"
#include "core/mesh/frames/frames.h"
#include <cmath>
#include <functional>
#include <glm/mat2x2.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

using namespace relievo;

namespace {
constexpr float kPi = std::numbers::pi_v<float>;

struct Point {
    glm::vec3 position, normal;
};

// A grid over (s, t) in [0, 1]^2 with UVs = turn * (s, t); triangles face along the normals.
Mesh grid(
    unsigned columns, unsigned rows, const std::function<Point(float, float)>& surface, glm::mat2 turn = glm::mat2(1.f), float jitter = 0.f)
{
    Mesh mesh;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> shift(-jitter, jitter);
    for (unsigned j = 0; j <= rows; ++j)
        for (unsigned i = 0; i <= columns; ++i) {
            const bool edge = i == 0 || j == 0 || i == columns || j == rows;
            const float s = (float(i) + (edge ? 0.f : shift(random))) / float(columns),
                        t = (float(j) + (edge ? 0.f : shift(random))) / float(rows);
            const Point p = surface(s, t);
            mesh.vertices.push_back({.position = p.position,
                .normal = glm::normalize(p.normal),
                .uv = turn * glm::vec2(s, t),
                .tangent = {},
                .dPdu = {},
                .dPdv = {}});
        }
    for (unsigned j = 0; j < rows; ++j)
        for (unsigned i = 0; i < columns; ++i) {
            const std::uint32_t a = j * (columns + 1) + i, b = a + columns + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    completeFrames(mesh);
    return mesh;
}

constexpr float kRing = 0.4f, kTube = 0.15f;
Point torus(float s, float t)
{
    s -= std::floor(s); // the seams close exactly
    t -= std::floor(t);
    const glm::vec3 out(std::sin(2.f * kPi * s), 0.f, std::cos(2.f * kPi * s));
    const glm::vec3 n = out * -std::cos(2.f * kPi * t) + glm::vec3(0.f, std::sin(2.f * kPi * t), 0.f);
    return {kRing * out + kTube * n, n};
}

// Half of the second fundamental form of the torus, positive where convex.
float torusFall(const Vertex& v, glm::vec3 a, glm::vec3 b)
{
    const glm::vec3 around = glm::normalize(glm::cross(glm::vec3(0.f, 1.f, 0.f), v.position));
    const glm::vec3 across = glm::cross(around, v.normal);
    const glm::vec3 out = glm::normalize(glm::vec3(v.position.x, 0.f, v.position.z));
    const float atRing = glm::dot(v.normal, out) / glm::length(glm::vec2(v.position.x, v.position.z)), atTube = 1.f / kTube;
    return 0.5f * (atRing * glm::dot(a, around) * glm::dot(b, around) + atTube * glm::dot(a, across) * glm::dot(b, across));
}

// Root mean square of the error of `full` against the torus, relative to that of the truth.
double torusError(const Mesh& mesh)
{
    const std::vector<Curvature> curvatures = vertexCurvatures(mesh);
    double error = 0, size = 0;
    for (std::size_t i = 0; i < curvatures.size(); ++i) {
        const Vertex& v = mesh.vertices[i];
        const glm::vec3 truth(torusFall(v, v.dPdu, v.dPdu), torusFall(v, v.dPdv, v.dPdv), 2.f * torusFall(v, v.dPdu, v.dPdv));
        error += double(glm::dot(curvatures[i].full - truth, curvatures[i].full - truth));
        size += double(glm::dot(truth, truth));
    }
    return std::sqrt(error / size);
}

const glm::mat2 kSkewed(2.f, 0.8f, -1.1f, 1.5f);
} // namespace

TEST(MeshCurvature, SphereFallsByHalfTheInverseRadius)
{
    const Mesh mesh = *openMesh("sphere");
    const std::vector<Curvature> curvatures = vertexCurvatures(mesh);
    for (std::size_t i = 0; i < curvatures.size(); ++i) {
        const Vertex& v = mesh.vertices[i];
        const glm::vec3 truth(glm::dot(v.dPdu, v.dPdu), glm::dot(v.dPdv, v.dPdv), 2.f * glm::dot(v.dPdu, v.dPdv)); // R = 0.5
        EXPECT_LT(glm::distance(curvatures[i].full, truth), 1e-3f * glm::length(truth));
        EXPECT_LT(glm::distance(curvatures[i].axes, glm::vec2(truth)), 1e-3f * glm::length(truth));
    }
}

TEST(MeshCurvature, CylinderBendsOneWayAndItsCapsNot)
{
    const Mesh mesh = *openMesh("cylinder");
    const std::vector<Curvature> curvatures = vertexCurvatures(mesh);
    for (std::size_t i = 0; i < curvatures.size(); ++i) {
        const Vertex& v = mesh.vertices[i];
        const bool cap = std::abs(v.normal.y) > 0.5f;
        const float truth = cap ? 0.f : 0.5f * kPi * glm::dot(v.dPdu, v.dPdu); // R = 1 / pi
        EXPECT_NEAR(curvatures[i].full.x, truth, 2e-3f * glm::dot(v.dPdu, v.dPdu));
        EXPECT_NEAR(curvatures[i].axes.x, truth, 2e-3f * glm::dot(v.dPdu, v.dPdu));
        EXPECT_NEAR(curvatures[i].full.y, 0.f, 2e-3f * glm::dot(v.dPdv, v.dPdv));
        EXPECT_NEAR(curvatures[i].full.z, 0.f, 4e-3f * glm::length(v.dPdu) * glm::length(v.dPdv));
    }
}

TEST(MeshCurvature, TorusWithAnyUVsAgreesWithItsFormula)
{
    EXPECT_LT(torusError(grid(96, 48, torus)), 0.01);
    EXPECT_LT(torusError(grid(96, 48, torus, kSkewed)), 0.01);
    EXPECT_LT(torusError(grid(96, 48, torus, kSkewed, 0.3f)), 0.03);
    EXPECT_LT(torusError(grid(24, 12, torus, kSkewed)), 0.1); // as coarse as a game's
}

TEST(MeshCurvature, SkewedUVsNeedTheMixedTerm)
{
    const Mesh mesh = grid(96, 48, torus, kSkewed);
    const std::vector<Curvature> curvatures = vertexCurvatures(mesh);
    double full = 0, axes = 0, size = 0;
    for (std::size_t i = 0; i < curvatures.size(); ++i) {
        const Vertex& v = mesh.vertices[i];
        for (const glm::vec2 d : {glm::vec2(1.f, 1.f), glm::vec2(1.f, -1.f), glm::vec2(1.f, 0.f), glm::vec2(0.f, 1.f)}) {
            const glm::vec3 step = v.dPdu * d.x + v.dPdv * d.y;
            const double truth = double(torusFall(v, step, step));
            const Curvature& c = curvatures[i];
            full += std::pow(double(c.full.x * d.x * d.x + c.full.y * d.y * d.y + c.full.z * d.x * d.y) - truth, 2.0);
            axes += std::pow(double(c.axes.x * d.x * d.x + c.axes.y * d.y * d.y) - truth, 2.0);
            size += truth * truth;
        }
    }
    EXPECT_LT(std::sqrt(full / size), 0.01);
    EXPECT_GT(std::sqrt(axes / size), 0.2);
}

TEST(MeshCurvature, SaddleBendsBothWaysUpToItsBorder)
{
    // y = 0.5 x^2 - 0.8 z^2 + 0.6 x z around the origin; z down the image.
    const auto saddle = [](float s, float t) {
        const float x = 0.1f * (s - 0.5f), z = 0.1f * (t - 0.5f);
        return Point{{x, 0.5f * x * x - 0.8f * z * z + 0.6f * x * z, z}, {-x - 0.6f * z, 1.f, 1.6f * z - 0.6f * x}};
    };
    const Mesh mesh = grid(8, 8, saddle);
    for (const Curvature& c : vertexCurvatures(mesh))
        EXPECT_LT(glm::distance(c.full, 0.01f * glm::vec3(-0.5f, 0.8f, -0.6f)), 3e-4f);
}

TEST(MeshCurvature, UVSeamsDoNotInterruptTheSurface)
{
    // The seams of the torus are borders of its vertices but not of its surface.
    const Mesh mesh = grid(48, 24, torus);
    const std::vector<Curvature> curvatures = vertexCurvatures(mesh);
    for (std::size_t i = 0; i < curvatures.size(); ++i) {
        const Vertex& v = mesh.vertices[i];
        if (i % 49 != 0 && i % 49 != 48)
            continue;
        const glm::vec3 truth(torusFall(v, v.dPdu, v.dPdu), torusFall(v, v.dPdv, v.dPdv), 2.f * torusFall(v, v.dPdu, v.dPdv));
        EXPECT_LT(glm::distance(curvatures[i].full, truth), 0.02f * glm::length(truth));
    }
}

TEST(MeshCurvature, FlatAndHardEdgedMeshesAreFlat)
{
    for (const char* shape : {"plane", "box"})
        for (const Curvature& c : vertexCurvatures(*openMesh(shape))) {
            EXPECT_EQ(c.full, glm::vec3(0.f)) << shape;
            EXPECT_EQ(c.axes, glm::vec2(0.f)) << shape;
        }
}

TEST(MeshCurvature, FiniteOnSliversSingleTrianglesAndHubs)
{
    const auto needle = [](float s, float t) { return Point{{s, 1e-7f * t, 1e-9f * s * t}, {s - 0.5f, 0.1f, 1.f}}; };
    const auto hub = [](float s, float t) { return Point{{t * std::sin(6.28f * s), 0.f, t * std::cos(6.28f * s)}, {s, 1.f, t}}; };
    const auto huge = [](float s, float t) { return Point{{1e14f * s, 1e14f * s * t, 1e14f * t}, {s, 1.f, t}}; };
    std::vector<Mesh> meshes = {
        grid(1, 1, needle), grid(4, 4, needle), grid(400, 2, hub), grid(3, 3, huge, glm::mat2(1e-12f)), grid(3, 3, huge, glm::mat2(0.f))};
    Mesh one = grid(1, 1, torus);
    one.indices.resize(3);
    meshes.push_back(one);
    for (const Mesh& mesh : meshes) {
        const std::vector<Curvature> curvatures = vertexCurvatures(mesh);
        ASSERT_EQ(curvatures.size(), mesh.vertices.size());
        for (const Curvature& c : curvatures)
            EXPECT_TRUE(std::isfinite(glm::dot(c.full, glm::vec3(1.f))) && std::isfinite(glm::dot(c.axes, glm::vec2(1.f))));
    }
    EXPECT_TRUE(vertexCurvatures(Mesh{}).empty());
}
