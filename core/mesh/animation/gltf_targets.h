// The morph targets of a glTF file's primitives.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/animation/gltf_nodes.h"
#include "core/mesh/readers/raw_mesh.h"
#include <map>

namespace relievo {

// Collects while a scene is gathered; what all targets hold together stays within kMostDeltas.
class GltfTargets {
public:
    GltfTargets(const tinygltf::Model& model, const GltfNodes& nodes, std::string where);

    // As GltfDeformation::addPrimitive.
    Expected<void> addPrimitive(
        const tinygltf::Primitive& primitive, int node, const glm::dmat4& world, std::size_t first, const RawMesh& raw);

    // Targets and their pieces, for so many vertices.
    RawDeformation finished(std::size_t vertices);

private:
    std::size_t targetOf(int node, std::size_t t);
    void boundDeltas(std::size_t vertices);

    const tinygltf::Model& m_model;
    const GltfNodes& m_nodes;
    std::string m_where;
    RawDeformation m_raw;
    std::map<std::pair<int, std::size_t>, std::size_t> m_targets; // by node and number there, in Deformation::targets
    std::size_t m_heldDeltas = 0; // of m_raw.pieces
};

} // namespace relievo
