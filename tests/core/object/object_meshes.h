// Small meshes to bake objects from, and points that tell what is inside.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/shapes/shapes.h"
#include "core/object/bake/bake_object.h"
#include <gtest/gtest.h>
#include <random>

namespace relievo::test {

// Of corner positions, three a triangle; normals of the triangles.
inline Mesh meshOf(const std::vector<glm::vec3>& corners)
{
    Mesh mesh;
    mesh.name = "test";
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const glm::vec3 up = glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
        for (std::size_t k = 0; k < 3; ++k) {
            mesh.indices.push_back(std::uint32_t(mesh.vertices.size()));
            mesh.vertices.push_back({corners[i + k], glm::dot(up, up) > 0.f ? glm::normalize(up) : glm::vec3(0.f, 1.f, 0.f),
                {k == 1 ? 1.f : 0.f, k == 2 ? 1.f : 0.f}, {1.f, 0.f, 0.f, 1.f}, {}, {}});
        }
    }
    mesh.parts = {{"", "", 0, std::uint32_t(mesh.indices.size()), 1.f}};
    mesh.boundsMin = mesh.boundsMax = corners.empty() ? glm::vec3(0.f) : corners.front();
    for (const glm::vec3& corner : corners) {
        mesh.boundsMin = glm::min(mesh.boundsMin, corner);
        mesh.boundsMax = glm::max(mesh.boundsMax, corner);
    }
    return mesh;
}

inline std::vector<glm::vec3> quad(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d)
{
    return {a, b, c, a, c, d};
}

// Facing outwards, or inwards.
inline std::vector<glm::vec3> boxCorners(glm::vec3 low, glm::vec3 high, bool inwards = false)
{
    std::vector<glm::vec3> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.f, 1.f}) {
            glm::vec3 u{0.f}, v{0.f}, n{0.f};
            n[axis] = side;
            u[(axis + 1) % 3] = 1.f;
            v[(axis + 2) % 3] = side;
            const auto at = [&](glm::vec3 p) { return low + (0.5f + 0.5f * p) * (high - low); };
            for (const glm::vec3& corner : quad(at(n - u - v), at(n + u - v), at(n + u + v), at(n - u + v)))
                corners.push_back(corner);
        }
    if (inwards)
        for (std::size_t i = 0; i < corners.size(); i += 3)
            std::swap(corners[i], corners[i + 1]);
    return corners;
}

inline std::vector<glm::vec3> operator+(std::vector<glm::vec3> a, const std::vector<glm::vec3>& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

inline BakedDepths bakedDepths(const Mesh& mesh, const ObjectOptions& options)
{
    const auto surface = MeshSurface::load(mesh, {});
    EXPECT_TRUE(surface);
    auto baked = bakeDepths(*surface, options);
    EXPECT_TRUE(baked) << (baked ? "" : message(baked.error()));
    return baked.value_or(BakedDepths());
}

inline bool isTold(const Warnings& warnings, std::string_view code)
{
    return std::ranges::count(warnings, code, &Warning::code) == 1;
}

} // namespace relievo::test
