// Tangents that agree with MikkTSpace, so that normal maps baked elsewhere shade as they were baked.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <vector>

namespace relievo {

// One tangent for each of mesh.indices, from positions, unit normals and UVs (Mikkelsen, "Simulation of Wrinkled Surfaces Revisited",
// 2008, chapter 5): corners of one position, normal and UV whose triangles hang together and turn the image the same way share the
// angle-weighted mean of their directions of u, taken in the tangent plane. xyz unit and at right angles to the normal; w as
// Vertex::tangent's; w = 0 where no triangle says anything. Linear in the number of triangles but for a sort.
std::vector<glm::vec4> cornerTangents(const Mesh& mesh);

} // namespace relievo
