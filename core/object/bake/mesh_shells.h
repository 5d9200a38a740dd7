// What of a mesh encloses a volume, and what is a sheet.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include "core/object/bake/winding.h"

namespace relievo {

// Closed: of a shell (triangles that hang together by positions) whose edges are run through as often in one direction as in the other.
// Open: of another shell, and it bounds what it encloses: where its winding number exceeds 0.5 (whichever way it faces). Sheet: nothing is
// enclosed on either side. Loose: a sheet that winds around nothing, as parts of it may be cut away by opacity or all of its shell are
// sheets.
enum class TriangleKind : std::uint8_t { Closed, Open, Sheet, Loose };
constexpr bool isSheet(TriangleKind kind)
{
    return kind == TriangleKind::Sheet || kind == TriangleKind::Loose;
}

struct MeshShells {
    std::vector<TriangleKind> kinds; // of each triangle
    // A fan over each hole: with them every shell is closed. So the winding number of the mesh, times it was entered less those it was
    // left, is that of the mesh with its lids less theirs, which are few.
    std::vector<Winding::Triangle> lids;
    Winding ofLids;
    std::size_t openTriangles = 0; // of shells that are not closed
    bool facesInwards = false; // closed shells enclose less than nothing on the whole
};

// isCut: of each triangle, whether opacity cuts it.
MeshShells shellsOf(const Mesh& mesh, const std::vector<char>& isCut);

// The corners of a triangle; number < indices / 3.
inline std::array<glm::dvec3, 3> cornersOf(const Mesh& mesh, std::size_t triangle)
{
    std::array<glm::dvec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
        corners[k] = mesh.vertices[mesh.indices[3 * triangle + k]].position;
    return corners;
}

} // namespace relievo
