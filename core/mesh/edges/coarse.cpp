// Clustering vertices.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edges/coarse.h"
#include "core/mesh/numbering.h"
#include <glm/geometric.hpp>

namespace relievo {

CoarseTriangles coarseTriangles(const Mesh& mesh, float side)
{
    Numbering<3> cubes(mesh.vertices.size());
    std::vector<std::uint32_t> firstIn, instead;
    instead.reserve(mesh.vertices.size());
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vertex& vertex = mesh.vertices[i];
        const auto [cube, isNew] = cubes(bitsOf(glm::floor((vertex.position - mesh.boundsMin) / side)));
        if (isNew)
            firstIn.push_back(i);
        const Vertex& first = mesh.vertices[firstIn[cube]];
        const bool alike
            = glm::distance(vertex.uv, first.uv) * mesh.metresPerUV < 3.f * side && glm::dot(vertex.normal, first.normal) > 0.5f;
        instead.push_back(alike ? firstIn[cube] : i);
    }
    CoarseTriangles coarse;
    for (const MeshPart& part : mesh.parts) {
        coarse.firstIndex.push_back(std::uint32_t(coarse.indices.size()));
        for (std::uint32_t i = part.firstIndex; i < part.firstIndex + part.indexCount; i += 3) {
            const std::uint32_t a = instead[mesh.indices[i]], b = instead[mesh.indices[i + 1]], c = instead[mesh.indices[i + 2]];
            if (a != b && b != c && c != a)
                coarse.indices.insert(coarse.indices.end(), {a, b, c});
        }
    }
    coarse.firstIndex.push_back(std::uint32_t(coarse.indices.size()));
    return coarse;
}

} // namespace relievo
