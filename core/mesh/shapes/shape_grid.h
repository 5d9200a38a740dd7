// What the shapes made by formula are put together from: grids of quads over a surface.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace relievo {

inline constexpr float kPi = std::numbers::pi_v<float>;

struct Point {
    glm::vec3 position, normal;
    glm::vec2 uv;
};

// A grid of columns x rows quads over (s, t) in [0, 1]^2; seen from outside, s runs to the right and t down.
template <class Surface> void addGrid(Mesh& mesh, unsigned columns, unsigned rows, Surface surface)
{
    const auto first = std::uint32_t(mesh.vertices.size());
    for (unsigned j = 0; j <= rows; ++j) {
        for (unsigned i = 0; i <= columns; ++i) {
            const Point p = surface(float(i) / float(columns), float(j) / float(rows));
            mesh.vertices.push_back({.position = p.position, .normal = p.normal, .uv = p.uv, .tangent = {}, .dPdu = {}, .dPdv = {}});
        }
    }
    const auto samePlace
        = [&mesh](std::uint32_t a, std::uint32_t b) { return glm::distance(mesh.vertices[a].position, mesh.vertices[b].position) < 1e-6f; };
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (!samePlace(a, b) && !samePlace(b, c) && !samePlace(c, a)) // at a pole one of the two is a line
            mesh.indices.insert(mesh.indices.end(), {a, b, c});
    };
    for (unsigned j = 0; j < rows; ++j) {
        for (unsigned i = 0; i < columns; ++i) {
            const std::uint32_t topLeft = first + j * (columns + 1) + i, bottomLeft = topLeft + columns + 1;
            triangle(topLeft, bottomLeft, bottomLeft + 1);
            triangle(topLeft, bottomLeft + 1, topLeft + 1);
        }
    }
}

// Around the y axis from +z towards +x.
inline glm::vec3 around(float share)
{
    const float angle = 2.f * kPi * (share - std::floor(share)); // seams close exactly
    return {std::sin(angle), 0.f, std::cos(angle)};
}

} // namespace relievo
