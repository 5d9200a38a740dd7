// What morph targets of glTF primitives add to positions and normals.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/animation/gltf_targets.h"
#include "core/mesh/readers/gltf_primitive.h"
#include <cmath>

namespace relievo {

namespace {
// As exporters agree to write it, in "extras".
std::string targetName(const tinygltf::Mesh& mesh, std::size_t t)
{
    if (mesh.extras.IsObject() && mesh.extras.Has("targetNames")) {
        const tinygltf::Value& names = mesh.extras.Get("targetNames");
        if (names.IsArray() && t < names.ArrayLen() && names.Get(int(t)).IsString())
            return names.Get(int(t)).Get<std::string>();
    }
    return "target " + std::to_string(t);
}

glm::vec3 tripleAt(const std::vector<float>& values, std::size_t i)
{
    return {values[i * 3], values[i * 3 + 1], values[i * 3 + 2]};
}

bool isSmall(glm::vec3 v)
{
    return glm::dot(glm::abs(v), glm::vec3(1.f)) < 1e15f;
} // false for NaN
} // namespace

GltfTargets::GltfTargets(const tinygltf::Model& model, const GltfNodes& nodes, std::string where)
    : m_model(model)
    , m_nodes(nodes)
    , m_where(std::move(where))
{
}

Expected<void> GltfTargets::addPrimitive(
    const tinygltf::Primitive& primitive, int node, const glm::dmat4& world, std::size_t first, const RawMesh& raw)
{
    const glm::mat3 linear(world);
    const Directions directions = directionsOf(world);
    const std::size_t count = raw.positions.size() - first;
    const bool hasNormals = raw.normals.size() >= count && !raw.corners.empty() && raw.corners.back().normal != RawMesh::kNone;
    for (std::size_t t = 0; node >= 0 && t < primitive.targets.size(); ++t) {
        // Whole targets are left out, here and in cutTargets(): the bound only falls while vertices are added.
        if (const auto known = m_targets.find({node, t});
            (known == m_targets.end() ? m_raw.deformation.targets.size() : known->second) >= mostTargets(raw.positions.size())) {
            m_raw.isCut = true;
            continue;
        }
        const Expected<std::vector<float>> positions = readAttribute(m_model, primitive.targets[t], "POSITION", 3, count, m_where),
                                           normals = readAttribute(m_model, primitive.targets[t], "NORMAL", 3, count, m_where);
        for (const auto* read : {&positions, &normals})
            if (!*read)
                return tl::unexpected(read->error());
        RawDeformation::Piece piece;
        piece.first = first;
        piece.positions.assign(count, glm::vec3(0.f));
        for (std::size_t i = 0; i < count && !positions->empty(); ++i)
            if (const glm::vec3 moved = linear * tripleAt(*positions, i); isSmall(moved))
                piece.positions[i] = moved;
        if (hasNormals && !normals->empty()) {
            piece.normals.assign(count, glm::vec3(0.f));
            for (std::size_t i = 0; i < count; ++i) {
                // raw.normals are directions.normals * normal, of any length: so is the difference, before both are made unit.
                const glm::vec3 from = raw.normals[raw.normals.size() - count + i], to = from + directions.normals * tripleAt(*normals, i);
                if (isSmall(to) && glm::length(from) > 1e-20f && glm::length(to) > 1e-20f)
                    piece.normals[i] = glm::normalize(to) - glm::normalize(from);
            }
        }
        piece.target = targetOf(node, t);
        m_raw.pieces.push_back(std::move(piece));
        m_heldDeltas += count;
    }
    boundDeltas(raw.positions.size());
    return {};
}

// What was within the bound when it came may lie beyond it now.
void GltfTargets::boundDeltas(std::size_t vertices)
{
    if (m_heldDeltas <= 2 * kMostDeltas)
        return;
    cutTargets(m_raw, vertices);
    m_heldDeltas = 0;
    for (const RawDeformation::Piece& piece : m_raw.pieces)
        m_heldDeltas += piece.positions.size();
}

// The number of target `t` of the node's mesh; made when it is the first primitive that has it.
std::size_t GltfTargets::targetOf(int node, std::size_t t)
{
    const auto [found, isNew] = m_targets.try_emplace({node, t}, m_raw.deformation.targets.size());
    if (!isNew)
        return found->second;
    const tinygltf::Node& owner = m_model.nodes[std::size_t(node)];
    const std::vector<double>& rest = !owner.weights.empty() ? owner.weights : m_model.meshes[std::size_t(owner.mesh)].weights;
    MorphTarget target;
    target.name = targetName(m_model.meshes[std::size_t(owner.mesh)], t);
    target.node = m_nodes.numberOf(node);
    if (t < rest.size() && std::abs(rest[t]) < 1e6)
        target.restWeight = float(rest[t]);
    m_raw.deformation.targets.push_back(std::move(target));
    return found->second;
}

RawDeformation GltfTargets::finished(std::size_t vertices)
{
    cutTargets(m_raw, vertices);
    return std::move(m_raw);
}

} // namespace relievo
