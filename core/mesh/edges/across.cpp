// Edges joined by the places of their ends.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edges/across.h"
#include "core/mesh/edges/places.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace relievo {

namespace {
constexpr std::size_t kMostAtEdge = 16; // of more triangles at one edge no one can say which goes on
constexpr float kHard = 0.866f; // cosine between normals; sheets that lean less overlap enough to be taken for one
constexpr float kFolded = -0.8f; // triangles back to back are no surface that goes on

const Vertex& corner(const Mesh& mesh, std::uint32_t edge)
{
    return mesh.vertices[mesh.indices[edge]];
}

// Of the angle between the normals of two edges, at the end where it is larger.
float cosineBetween(const Mesh& mesh, std::uint32_t edge, std::uint32_t other)
{
    return std::min(glm::dot(corner(mesh, edge).normal, corner(mesh, nextCorner(other)).normal),
        glm::dot(corner(mesh, nextCorner(edge)).normal, corner(mesh, other).normal));
}

bool goesOn(const Mesh& mesh, std::uint32_t edge, std::uint32_t other)
{
    const float cosine = cosineBetween(mesh, edge, other);
    if (cosine > kHard || cosine < kFolded)
        return cosine > kHard;
    const Vertex &a = corner(mesh, edge), &b = corner(mesh, nextCorner(edge));
    const glm::vec3 beyond = corner(mesh, nextCorner(nextCorner(other))).position - a.position;
    return glm::dot(beyond, a.normal + b.normal) > 0.f; // a concave edge
}
} // namespace

std::vector<std::uint32_t> edgesAcross(const Mesh& mesh)
{
    std::vector<std::uint32_t> across(mesh.indices.size(), kNoEdge);
    const std::vector<std::uint32_t> place = placesOf(mesh);
    const auto key
        = [&](std::uint32_t from, std::uint32_t to) { return std::uint64_t(place[mesh.indices[from]]) << 32 | place[mesh.indices[to]]; };
    std::unordered_multimap<std::uint64_t, std::uint32_t> byEnds;
    byEnds.reserve(mesh.indices.size());
    const auto isPoint = [&](std::uint32_t e) { return place[mesh.indices[e]] == place[mesh.indices[nextCorner(e)]]; };
    for (std::uint32_t e = 0; e < mesh.indices.size(); ++e)
        if (!isPoint(e))
            byEnds.emplace(key(e, nextCorner(e)), e);
    for (std::uint32_t e = 0; e < mesh.indices.size(); ++e) {
        const std::uint64_t back = key(nextCorner(e), e);
        std::size_t count = 0;
        // Where several meet, the one that turns least. Not by equal_range, which walks through all of them.
        for (auto other = byEnds.find(back); other != byEnds.end() && other->first == back; ++other) {
            if (++count > kMostAtEdge) {
                across[e] = kNoEdge;
                break;
            }
            if (goesOn(mesh, e, other->second)
                && (across[e] == kNoEdge || cosineBetween(mesh, e, across[e]) < cosineBetween(mesh, e, other->second)))
                across[e] = other->second;
        }
    }
    return across;
}

} // namespace relievo
