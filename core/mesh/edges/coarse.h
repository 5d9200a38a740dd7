// A mesh of very many triangles with fewer, for pictures that last a moment.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <vector>

namespace relievo {

struct CoarseTriangles {
    std::vector<std::uint32_t> indices; // of the mesh's own vertices, triples
    std::vector<std::uint32_t> firstIndex; // by part, and the end of the last
};

// In each cube of `side` (m) the vertices become the first of them that lies there, and triangles without extent are left out (vertex
// clustering; Rossignac and Borrel 1993). Vertices whose UV or normal are others than that one's stay: seams and hard edges are kept.
CoarseTriangles coarseTriangles(const Mesh& mesh, float side);

} // namespace relievo
