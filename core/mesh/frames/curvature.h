// How the surface bends around each vertex, for rays that follow it beyond the tangent plane (silhouettes).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace relievo {

// The surface near a vertex falls below its tangent plane (along -normal) by full.x du^2 + full.y dv^2 + full.z du dv metres; du and
// dv in mesh UV units, measured by the vertex' own dPdu and dPdv. Positive: convex. Always finite.
struct Curvature {
    glm::vec3 full{0.f}; // m per UV unit squared
    // A and B of Oliveira and Policarpo ("An Efficient Representation for Surface Details", 2005): the fit z = A x^2 + B y^2 without a
    // mixed term along the tangent and the bitangent, as if the principal directions lay there; m per UV unit squared.
    glm::vec2 axes{0.f};
};

// One for each vertex, by least squares over how the normals of its neighbours lean. Vertices that only a UV seam parts share
// their neighbours; across a hard edge there are none. A vertex at a border or hard edge takes the mean of its inner neighbours.
std::vector<Curvature> vertexCurvatures(const Mesh& mesh);

// What bends a search ray: `full`, or for axes (A, B, 0), of each vertex.
std::vector<glm::vec3> vertexFalls(const Mesh& mesh, bool axes);

} // namespace relievo
