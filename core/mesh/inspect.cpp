// Faults of a mesh that can be drawn nevertheless, counted for `relievo info`.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/frames/frames.h"
#include "core/mesh/frames/tangents.h"
#include "core/mesh/numbering.h"
#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>
#include <tbb/parallel_sort.h>

namespace relievo {

namespace {
struct Counts {
    std::size_t withoutArea = 0, withoutUVArea = 0, flipped = 0;
};

Counts countTriangles(const Mesh& mesh)
{
    Counts counts;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]], &c = mesh.vertices[mesh.indices[i + 2]];
        const glm::dvec3 side = glm::dvec3(b.position) - glm::dvec3(a.position), other = glm::dvec3(c.position) - glm::dvec3(a.position);
        const glm::dvec3 across = glm::cross(side, other);
        if (glm::length(across) <= 1e-12 * (glm::dot(side, side) + glm::dot(other, other)))
            ++counts.withoutArea;
        else if (glm::dot(across, glm::dvec3(a.normal) + glm::dvec3(b.normal) + glm::dvec3(c.normal)) < 0.0)
            ++counts.flipped;
        if (signedUVArea(a.uv, b.uv, c.uv) == 0.f)
            ++counts.withoutUVArea;
    }
    return counts;
}

// Edges, by position, at which more than two triangles meet.
std::size_t countNonManifold(const Mesh& mesh)
{
    Numbering<3> numbering(mesh.vertices.size());
    std::vector<std::uint32_t> place;
    place.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices)
        place.push_back(numbering(bitsOf(vertex.position)).number);
    std::vector<std::uint64_t> edges;
    edges.reserve(mesh.indices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint64_t corners[3] = {place[mesh.indices[i]], place[mesh.indices[i + 1]], place[mesh.indices[i + 2]]};
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
            continue;
        for (std::size_t k = 0; k < 3; ++k)
            edges.push_back(std::min(corners[k], corners[(k + 1) % 3]) << 32 | std::max(corners[k], corners[(k + 1) % 3]));
    }
    tbb::parallel_sort(edges);
    std::size_t count = 0;
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
        while (last < edges.size() && edges[last] == edges[first])
            ++last;
        count += last - first > 2;
    }
    return count;
}

std::string textOf(const TangentDifference& difference)
{
    char worst[32];
    std::snprintf(worst, sizeof worst, "%.3g", difference.worst);
    return std::to_string(difference.off) + " of " + std::to_string(difference.corners)
        + " corners have tangents in the file that are not MikkTSpace's, for which most normal maps are baked: up to " + worst
        + " degrees from them.";
}
} // namespace

Warnings inspectMesh(const Mesh& mesh)
{
    const Counts counts = countTriangles(mesh);
    struct Row {
        std::size_t count;
        const char *code, *one, *many;
    };
    const Row rows[] = {
        {counts.withoutArea, "degenerate-triangles", " triangle has no area.", " triangles have no area."},
        {counts.withoutUVArea, "degenerate-uvs", " triangle has UVs without area: it shows a point or a line of the texture.",
            " triangles have UVs without area: they show a point or a line of the texture."},
        {mesh.repeatedVertices, "duplicate-vertices", " vertex is written out although an equal one exists.",
            " vertices are written out although equal ones exist."},
        {countNonManifold(mesh), "non-manifold-edges", " edge joins more than two triangles.", " edges join more than two triangles."},
        {counts.flipped, "flipped-normals", " triangle faces away from its normals: its winding or its normals are inverted.",
            " triangles face away from their normals: their winding or their normals are inverted."},
    };
    Warnings warnings;
    for (const Row& row : rows)
        if (row.count > 0)
            warnings.push_back({row.code, std::to_string(row.count) + (row.count == 1 ? row.one : row.many)});
    if (mesh.fileHasTangents)
        if (const TangentDifference difference = tangentDifference(mesh); difference.off > 0)
            warnings.push_back({"other-tangents", textOf(difference)});
    return warnings;
}

} // namespace relievo
