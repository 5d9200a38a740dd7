// What moves in a glTF file: skins, morph targets, the node hierarchy and its animations.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/readers/raw_mesh.h"
#include <map>
#include <tiny_gltf.h>

namespace relievo {

// A glTF node as a pose begins from it; transforms that are not finite stand still.
PoseNode poseNodeOf(const tinygltf::Node& node);

// Collects while a scene is gathered.
class GltfDeformation {
public:
    GltfDeformation(const tinygltf::Model& model, std::string where);

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
    void orderNodes();
    void readClips();
    std::optional<AnimationChannel> channelOf(const tinygltf::Animation& animation, const tinygltf::AnimationChannel& from);
    std::size_t targetCount(int node) const;
    std::size_t targetOf(int node, std::size_t t);
    std::optional<int> skinOf(const tinygltf::Primitive& primitive, int node, const glm::dmat4& world) const;
    std::vector<glm::dmat4> bindMatrices(const tinygltf::Skin& skin) const;
    std::uint16_t rigidJoint(int node, const glm::dmat4& world);
    std::uint16_t firstJointOf(int skin, const glm::dmat4& world);
    Expected<void> addInfluences(const tinygltf::Primitive& primitive, int skin, const glm::dmat4& world, std::size_t count);
    Expected<void> addTargets(
        const tinygltf::Primitive& primitive, int node, const glm::dmat4& world, std::size_t first, const RawMesh& raw);

    const tinygltf::Model& m_model;
    std::string m_where;
    RawDeformation m_raw;
    std::vector<int> m_nodeNumbers; // of each node of the file in Deformation::nodes; -1: it is part of a circle
    std::vector<glm::dmat4> m_rest; // by number: world matrices of the nodes at rest
    std::vector<bool> m_animated; // by number: the node or one above it has an animated place
    struct SkinUse {
        int skin;
        glm::dmat4 world;
        std::uint16_t firstJoint;
    };
    std::vector<SkinUse> m_skins;
    std::map<int, glm::dvec3> m_skinPlaces; // where the first joint of each skin holds its mesh's origin at rest
    std::map<std::pair<int, std::size_t>, std::size_t> m_targets; // by node and number there, in Deformation::targets
    std::size_t m_missingJoints = 0, m_oddWeights = 0, m_manyInfluences = 0, m_brokenChannels = 0, m_unsorted = 0;
    std::size_t m_heldDeltas = 0; // of m_raw.pieces
};

} // namespace relievo
