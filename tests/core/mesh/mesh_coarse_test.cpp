// Meshes drawn with fewer triangles: as many as asked for, where the mesh is, with seams kept.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edges/coarse.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

using namespace relievo;

TEST(CoarseTriangles, AreFewerWithSeamsKept)
{
    for (const char* shape : {"sphere", "torus", "box", "teapot"}) {
        const Mesh mesh = *openMesh(shape);
        constexpr float kSide = 0.05f;
        const CoarseTriangles coarse = coarseTriangles(mesh, kSide);
        ASSERT_EQ(coarse.firstIndex.size(), mesh.parts.size() + 1) << shape;
        EXPECT_EQ(coarse.firstIndex.back(), coarse.indices.size()) << shape;
        EXPECT_LE(coarse.indices.size(), mesh.indices.size()) << shape;
        if (mesh.indices.size() > 30000) {
            EXPECT_LT(coarse.indices.size(), mesh.indices.size() / 2) << shape;
        }
        float area = 0.f, fineArea = 0.f;
        const auto areaOf = [&](const std::vector<std::uint32_t>& indices, std::size_t i) {
            const glm::vec3 a = mesh.vertices[indices[i]].position;
            return 0.5f * glm::length(glm::cross(mesh.vertices[indices[i + 1]].position - a, mesh.vertices[indices[i + 2]].position - a));
        };
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            fineArea += areaOf(mesh.indices, i);
        for (std::size_t i = 0; i < coarse.indices.size(); i += 3) {
            area += areaOf(coarse.indices, i);
            for (std::size_t k = 0; k < 3; ++k) {
                const Vertex &a = mesh.vertices[coarse.indices[i + k]], &b = mesh.vertices[coarse.indices[i + (k + 1) % 3]];
                const float longest = std::string_view(shape) == "box" ? 2.f : 6.f * kSide; // whose sides are so long
                ASSERT_LT(glm::distance(a.position, b.position), longest) << shape;
                if (std::string_view(shape) == "torus") { // nothing reaches over its seams
                    ASSERT_LT(glm::distance(a.uv, b.uv) * mesh.metresPerUV, 8.f * kSide);
                }
            }
        }
        EXPECT_NEAR(area, fineArea, 0.05f * fineArea) << shape;
    }
}

TEST(CoarseTriangles, ATinySideChangesNothing)
{
    const Mesh mesh = *openMesh("torus");
    EXPECT_EQ(coarseTriangles(mesh, 1e-4f).indices, mesh.indices);
}
