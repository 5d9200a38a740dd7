// Directions in which a mesh is pushed out without tearing at its hard edges.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <glm/vec3.hpp>
#include <vector>

namespace relievo {

// One vector a vertex, the same for all vertices of one position: the mean of their normals, as long as it takes to move each of
// their faces out by 1 (a mitre, at most 3 long). Where the mesh is smooth it is the normal.
std::vector<glm::vec3> pushDirections(const Mesh& mesh);

} // namespace relievo
