// Tangents and Jacobians where textures mirror, collapse or fall apart; tests/clients/mikktspace.sh compares whole meshes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/frames/frames.h"
#include "core/mesh/frames/tangents.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

using namespace relievo;

namespace {
// A strip in the xz plane facing +y: columns at x = 0, 1, 2 with the given u, rows at z = 0, 1 with v = z.
Mesh strip(float u0, float u1, float u2)
{
    Mesh mesh;
    const float u[3] = {u0, u1, u2};
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column)
            mesh.vertices.push_back({.position = {float(column), 0.f, float(row)},
                .normal = {0.f, 1.f, 0.f},
                .uv = {u[column], float(row)},
                .tangent = {},
                .dPdu = {},
                .dPdv = {}});
    mesh.indices = {0, 3, 4, 0, 4, 1, 1, 4, 5, 1, 5, 2};
    completeFrames(mesh);
    return mesh;
}
} // namespace

TEST(MeshTangents, MirrorSplitsItsSeamAndKeepsBothJacobians)
{
    const Mesh mesh = strip(0.f, 1.f, 0.f);
    EXPECT_EQ(mesh.vertices.size(), 8u); // the two in the middle serve two sides
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const Vertex& v = mesh.vertices[mesh.indices[i]];
        const float side = i < 6 ? 1.f : -1.f;
        EXPECT_EQ(v.tangent, glm::vec4(side, 0.f, 0.f, side));
        EXPECT_LT(glm::distance(v.dPdu, glm::vec3(side, 0.f, 0.f)), 1e-6f);
        EXPECT_LT(glm::distance(v.dPdv, glm::vec3(0.f, 0.f, 1.f)), 1e-6f);
    }
}

TEST(MeshTangents, DifferencesAreTurnsOrMirrors)
{
    Mesh mesh = strip(0.f, 1.f, 2.f);
    TangentDifference difference = tangentDifference(mesh);
    EXPECT_EQ(difference.corners, 12u);
    EXPECT_EQ(difference.off, 0u);
    EXPECT_LT(difference.worst, 1e-4);
    mesh.vertices[0].tangent = {std::cos(0.0087266463f), 0.f, std::sin(0.0087266463f), 1.f}; // half a degree, at two corners
    difference = tangentDifference(mesh);
    EXPECT_EQ(difference.off, 2u);
    EXPECT_NEAR(difference.worst, 0.5, 1e-4);
    mesh.vertices[5].tangent.w = -1.f; // at two more
    difference = tangentDifference(mesh);
    EXPECT_EQ(difference.off, 4u);
    EXPECT_EQ(difference.worst, 180.);
}

TEST(MeshTangents, PlainStripIsNotSplit)
{
    EXPECT_EQ(strip(0.f, 1.f, 2.f).vertices.size(), 6u);
}

TEST(MeshTangents, TrianglesWithoutUVAreaFollowTheirNeighbours)
{
    const Mesh mesh = strip(0.f, 1.f, 1.f); // the second quad shows a line of the image
    for (const std::uint32_t at : {mesh.indices[6], mesh.indices[7], mesh.indices[9]})
        EXPECT_EQ(mesh.vertices[at].tangent, glm::vec4(1.f, 0.f, 0.f, 1.f));
    for (const Vertex& v : mesh.vertices)
        EXPECT_NEAR(glm::length(glm::vec3(v.tangent)), 1.f, 1e-5f);
}

TEST(MeshTangents, EveryUVEqualStillGivesASoundFrame)
{
    Mesh mesh = strip(0.f, 0.f, 0.f);
    for (Vertex& v : mesh.vertices)
        v.uv = {0.3f, 0.3f};
    completeFrames(mesh);
    for (const Vertex& v : mesh.vertices) {
        EXPECT_NEAR(glm::dot(glm::vec3(v.tangent), v.normal), 0.f, 1e-6f);
        EXPECT_GT(glm::length(glm::cross(v.dPdu, v.dPdv)), 0.f);
    }
}

TEST(MeshTangents, CollapsedTrianglesTakeWhatTheirVertexHas)
{
    Mesh mesh = strip(0.f, 1.f, 2.f);
    mesh.indices.insert(mesh.indices.end(), {1, 1, 4});
    const std::vector<glm::vec4> tangents = cornerTangents(mesh);
    for (std::size_t i = 12; i < 15; ++i)
        EXPECT_EQ(tangents[i], glm::vec4(1.f, 0.f, 0.f, 1.f));
}

// A triangle of 90 degrees with u along +x and one of 45 degrees, far longer, with u along +x - z, meet at the origin.
TEST(MeshTangents, MeanIsWeightedByTheAngle)
{
    Mesh mesh;
    const auto add = [&mesh](glm::vec3 position, glm::vec2 uv) {
        mesh.vertices.push_back({.position = position, .normal = {0.f, 1.f, 0.f}, .uv = uv, .tangent = {}, .dPdu = {}, .dPdv = {}});
    };
    add({0.f, 0.f, 0.f}, {0.f, 0.f});
    add({-1.f, 0.f, 0.f}, {-1.f, 0.f});
    add({0.f, 0.f, 1.f}, {0.f, 1.f});
    add({10.f, 0.f, 10.f}, {10.f, 0.f}); // v along +z = dPdv, 10 dPdu = (10, 0, 10)
    mesh.indices = {0, 1, 2, 0, 2, 3};
    completeFrames(mesh);
    const float angle = std::atan2(mesh.vertices[0].tangent.z, mesh.vertices[0].tangent.x);
    // Directions at 0 and 45 degrees with weights 90 and 45: tan = sin 45 / (2 + cos 45).
    EXPECT_NEAR(angle, std::atan2(std::sqrt(0.5f), 2.f + std::sqrt(0.5f)), 1e-5f);
}
