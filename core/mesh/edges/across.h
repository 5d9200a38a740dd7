// What lies across each edge of a mesh, where its surface goes on.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <cstdint>
#include <vector>

namespace relievo {

inline constexpr std::uint32_t kNoEdge = ~0u;

// An edge of a triangle is numbered by its first corner in Mesh::indices.
inline std::uint32_t nextCorner(std::uint32_t edge)
{
    return edge % 3 == 2 ? edge - 2 : edge + 1;
}

// For each edge the one that runs back along it in another triangle; kNoEdge at a border of the surface: where there is no second triangle,
// at convex edges where the normals differ by more than 30 degrees, since displaced surfaces part there, where the triangles lie back to
// back, and where more than 16 run back. An edge without length has none. UV seams are no borders.
std::vector<std::uint32_t> edgesAcross(const Mesh& mesh);

} // namespace relievo
