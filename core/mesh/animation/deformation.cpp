// From how a file's positions move to how a mesh's vertices do.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/frames/frames.h"
#include "core/mesh/readers/raw_mesh.h"
#include <algorithm>
#include <cmath>

namespace relievo {

namespace {
// Normals as makeNormals would have them: each the angle-weighted mean of the triangles that its vertex serves.
void renewNormals(Mesh& mesh)
{
    std::vector<glm::vec3> sums(mesh.vertices.size(), glm::vec3(0.f));
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t first = i - i % 3;
        const glm::vec3 at = mesh.vertices[mesh.indices[i]].position;
        const glm::vec3 a = mesh.vertices[mesh.indices[first + (i + 1 - first) % 3]].position - at;
        const glm::vec3 b = mesh.vertices[mesh.indices[first + (i + 2 - first) % 3]].position - at;
        const glm::vec3 across = glm::cross(a, b);
        if (const float length = glm::length(across); length > 0.f)
            sums[mesh.indices[i]] += across / length * std::atan2(length, glm::dot(a, b));
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (glm::length(sums[i]) > 1e-6f)
            mesh.vertices[i].normal = glm::normalize(sums[i]);
}

// What a target adds to each vertex, by building the mesh that it makes. pieces: of it, in the order of positions. source: the position of
// each vertex.
std::vector<MorphDelta> deltasOf(const Mesh& mesh, std::span<const RawDeformation::Piece> pieces, const std::vector<std::uint32_t>& source)
{
    Mesh reached = mesh, base = mesh;
    std::vector<bool> touched(source.size());
    const auto forTouched = [&](const auto& act) { // act(vertex, piece, offset in it)
        for (std::size_t i = 0; i < source.size(); ++i) {
            const auto after = std::ranges::upper_bound(pieces, std::size_t(source[i]), {}, &RawDeformation::Piece::first);
            if (after == pieces.begin())
                continue;
            const RawDeformation::Piece& piece = *std::prev(after);
            if (const std::size_t offset = source[i] - piece.first; offset < piece.positions.size())
                act(i, piece, offset);
        }
    };
    forTouched([&](std::size_t i, const RawDeformation::Piece& piece, std::size_t offset) {
        touched[i] = true;
        reached.vertices[i].position += piece.positions[offset];
    });
    if (!mesh.fileHasNormals) {
        renewNormals(base);
        renewNormals(reached);
    }
    forTouched([&](std::size_t i, const RawDeformation::Piece& piece, std::size_t offset) {
        if (!piece.normals.empty() && glm::length(mesh.vertices[i].normal + piece.normals[offset]) > 1e-6f)
            reached.vertices[i].normal = glm::normalize(mesh.vertices[i].normal + piece.normals[offset]);
    });
    refreshFrames(reached);
    std::vector<MorphDelta> deltas(source.size());
    for (std::size_t i = 0; i < source.size(); ++i) {
        const Vertex &from = base.vertices[i], &to = reached.vertices[i];
        if (touched[i])
            deltas[i] = {to.position - from.position, to.normal - from.normal, to.dPdu - from.dPdu, to.dPdv - from.dPdv};
    }
    return deltas;
}
} // namespace

std::size_t mostTargets(std::size_t vertices)
{
    return kMostDeltas / std::max(vertices, std::size_t(1));
}

void cutTargets(RawDeformation& moves, std::size_t vertices)
{
    std::vector<MorphTarget>& targets = moves.deformation.targets;
    if (targets.size() <= mostTargets(vertices))
        return;
    targets.resize(mostTargets(vertices));
    std::erase_if(moves.pieces, [&](const RawDeformation::Piece& piece) { return piece.target >= targets.size(); });
    moves.isCut = true;
}

std::shared_ptr<const Deformation> deformationOf(Mesh& mesh, RawMesh& raw)
{
    if (!raw.moves)
        return nullptr;
    cutTargets(*raw.moves, mesh.vertices.size());
    if (raw.moves->isCut)
        mesh.warnings.push_back({"morph-too-large",
            "The morph targets are too large together: only the first " + std::to_string(raw.moves->deformation.targets.size())
                + " are kept."});
    std::vector<std::uint32_t> source(mesh.vertices.size(), 0); // position of each vertex
    for (std::size_t i = mesh.indices.size(); i-- > 0;)
        source[mesh.indices[i]] = raw.corners[i].position;
    const auto deformation = std::make_shared<Deformation>(std::move(raw.moves->deformation));
    std::vector<Influence> influences(source.size());
    for (std::size_t i = 0; i < source.size(); ++i)
        influences[i] = deformation->influences[source[i]];
    deformation->influences = std::move(influences);
    std::vector<RawDeformation::Piece>& pieces = raw.moves->pieces;
    std::ranges::sort(pieces, {}, [](const RawDeformation::Piece& piece) { return std::pair(piece.target, piece.first); });
    for (std::size_t t = 0; t < deformation->targets.size(); ++t) {
        const auto ours = std::ranges::equal_range(pieces, t, {}, &RawDeformation::Piece::target);
        deformation->targets[t].deltas = deltasOf(mesh, ours, source);
        for (RawDeformation::Piece& piece : ours) // both forms of all targets would take half as much again
            piece = {};
    }
    return deformation;
}

} // namespace relievo
