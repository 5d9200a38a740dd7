// Tangents that agree with MikkTSpace, so that normal maps baked elsewhere shade as they were baked.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <cstddef>
#include <vector>

namespace relievo {

// One tangent for each of mesh.indices, from positions, unit normals and UVs (Mikkelsen, "Simulation of Wrinkled Surfaces Revisited",
// 2008, chapter 5): corners of one position, normal and UV whose triangles hang together and turn the image the same way share the
// angle-weighted mean of their directions of u, taken in the tangent plane. xyz unit and at right angles to the normal; w as
// Vertex::tangent's; w = 0 where no triangle says anything. Linear in the number of triangles but for a sort.
std::vector<glm::vec4> cornerTangents(const Mesh& mesh);

// How far the mesh's tangents, which are its file's where that has sound ones, are from these. A normal map that was baked for other
// tangents than it is drawn with shades wrongly. Corners without a direction of u do not count.
struct TangentDifference {
    std::size_t corners = 0, off = 0; // off: turned by more than kTangentTolerance, or mirrored
    double worst = 0.; // degrees; 180 where mirrored
};
inline constexpr double kTangentTolerance = 0.1; // degrees
TangentDifference tangentDifference(const Mesh& mesh);

} // namespace relievo
