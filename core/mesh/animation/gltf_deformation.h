// What moves in a glTF file: its skins, together with nodes, animations and morph targets.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/animation/gltf_animation.h"
#include "core/mesh/animation/gltf_targets.h"
#include <map>

namespace relievo {

// Collects while a scene is gathered.
class GltfDeformation {
public:
    GltfDeformation(const tinygltf::Model& model, std::string where);
    GltfDeformation(const GltfDeformation&) = delete; // m_targets knows m_nodes
    GltfDeformation& operator=(const GltfDeformation&) = delete;

    // Where a primitive of `node` (-1: none), whose world matrix is `world`, is to be stored: there, but when it has a skin not far from
    // where that holds it.
    glm::dmat4 storedAt(const tinygltf::Primitive& primitive, int node, const glm::dmat4& world);

    // After the primitive's positions were appended to `raw` from `first` on, placed by `world` as storedAt gave it.
    // Errors: accessors that break their buffers.
    Expected<void> addPrimitive(
        const tinygltf::Primitive& primitive, int node, const glm::dmat4& world, std::size_t first, const RawMesh& raw);

    // Nothing when no skin places anything and nothing moves. Adds to `warnings`: "skin-joints" (missing joints or matrices stand still),
    // "skin-weights" (do not sum to 1), "skin-influences" (more than four: the strongest four count), "animation-channels" (broken,
    // left out), "animation-times" (were not in order).
    std::optional<RawDeformation> finished(Warnings& warnings);

private:
    std::optional<int> skinOf(const tinygltf::Primitive& primitive, int node, const glm::dmat4& world) const;
    std::vector<glm::dmat4> bindMatrices(const tinygltf::Skin& skin) const;
    std::uint16_t rigidJoint(int node, const glm::dmat4& world);
    std::uint16_t firstJointOf(int skin, const glm::dmat4& world);
    Expected<void> addInfluences(const tinygltf::Primitive& primitive, int skin, const glm::dmat4& world, std::size_t count);

    const tinygltf::Model& m_model;
    std::string m_where;
    GltfNodes m_nodes;
    GltfClips m_clips;
    GltfTargets m_targets;
    std::vector<Influence> m_influences; // one for each of RawMesh::positions
    std::vector<Joint> m_joints{Joint()};
    struct SkinUse {
        int skin;
        glm::dmat4 world;
        std::uint16_t firstJoint;
    };
    std::vector<SkinUse> m_skins;
    std::map<int, glm::dvec3> m_skinPlaces; // where the first joint of each skin holds its mesh's origin at rest
    std::size_t m_missingJoints = 0, m_oddWeights = 0, m_manyInfluences = 0;
};

} // namespace relievo
