// Vertices and triangles as texels.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edges/prism_texels.h"
#include "core/mesh/edges/across.h"
#include "core/mesh/frames/push.h"
#include <algorithm>

namespace relievo {

std::vector<glm::vec4> prismTexels(const Mesh& mesh, const std::vector<std::uint32_t>& across, const std::vector<char>& isPlain)
{
    std::vector<char> plain(mesh.indices.size() / 3, 0); // by triangle
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
        if (isPlain[i])
            std::fill_n(plain.begin() + std::ptrdiff_t(mesh.parts[i].firstIndex / 3), mesh.parts[i].indexCount / 3, char(1));
    const std::vector<glm::vec3> push = pushDirections(mesh);
    std::vector<glm::vec4> texels;
    texels.reserve(1 + kPrismVertexTexels * mesh.vertices.size() + kPrismTriangleTexels * (mesh.indices.size() / 3));
    texels.emplace_back(float(1 + kPrismVertexTexels * mesh.vertices.size()), 0.f, 0.f, 0.f);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vertex& vertex = mesh.vertices[i];
        texels.insert(texels.end(),
            {glm::vec4(vertex.position, vertex.uv.x), glm::vec4(vertex.normal, vertex.uv.y), glm::vec4(push[i], 0.f),
                glm::vec4(vertex.dPdu, 0.f), glm::vec4(vertex.dPdv, 0.f)});
    }
    const auto number = [&](std::uint32_t edge) { return edge == kNoEdge || plain[edge / 3] ? -1.f : float(edge); };
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        texels.emplace_back(float(mesh.indices[i]), float(mesh.indices[i + 1]), float(mesh.indices[i + 2]), 0.f);
        texels.emplace_back(number(across[i]), number(across[i + 1]), number(across[i + 2]), 0.f);
    }
    return texels;
}

} // namespace relievo
