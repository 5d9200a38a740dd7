// Completing a mesh: texture Jacobian and tangent frame at every vertex, size and bounds.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <glm/geometric.hpp>
#include <span>

namespace relievo {

// Twice the area of a triangle in UV space, signed: negative where the image is seen unmirrored, as v runs down.
float signedUVArea(glm::vec2 a, glm::vec2 b, glm::vec2 c);

// Any unit vector at right angles to the unit vector n.
glm::vec3 perpendicular(glm::vec3 n);

// Fills dPdu, dPdv, tangent (tangents.h), bounds, outline and metresPerUV from positions, unit normals, UVs and indices. A vertex whose
// triangles want several tangents is split; the new ones stand at the end.
// The Jacobian at a vertex is the area-weighted mean over its triangles without the part along the normal; where the UVs are
// degenerate it becomes a right-angled frame of metresPerUV. Requires finite values and indices within `vertices` (asserted).
// fileTangents: empty, or one per vertex; those with w = 0 are made, the others are kept.
void completeFrames(Mesh& mesh, std::span<const glm::vec4> fileTangents = {});

// Renews dPdu, dPdv and bounds after vertices have moved, and metresPerUV and outline where renewSize says so. Tangents and the number of
// vertices stay.
void refreshFrames(Mesh& mesh, bool renewSize = false);

} // namespace relievo
