// The joints that glTF primitives follow: those of their skins, or the node that they hang on.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/animation/gltf_deformation.h"
#include "core/mesh/readers/gltf_accessor.h"
#include "core/mesh/readers/gltf_primitive.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace relievo {

namespace {
constexpr std::size_t kMostJoints = 0xffff;

// The inverse of an affine matrix, or nothing for a flat one.
std::optional<glm::dmat4> inverseOf(const glm::dmat4& matrix)
{
    const glm::dmat4 inverse = glm::inverse(matrix);
    return glm::determinant(glm::dmat3(matrix)) != 0.0 && isFinite(glm::mat4(inverse)) ? std::optional(inverse) : std::nullopt;
}

struct Pull {
    std::uint16_t joint;
    float weight;
};

// The strongest four, their weights made to sum to 1; nothing when none pulls.
std::optional<Influence> strongest(std::vector<Pull>& pulls)
{
    std::ranges::stable_sort(pulls, std::greater<>(), &Pull::weight);
    float sum = 0.f;
    for (std::size_t k = 0; k < std::min(pulls.size(), std::size_t(4)); ++k)
        sum += pulls[k].weight;
    if (!(sum > 1e-6f))
        return std::nullopt;
    Influence influence;
    influence.weights[0] = 0.f;
    for (std::size_t k = 0; k < std::min(pulls.size(), std::size_t(4)); ++k) {
        influence.joints[k] = pulls[k].joint;
        influence.weights[k] = pulls[k].weight / sum;
    }
    return influence;
}
} // namespace

GltfDeformation::GltfDeformation(const tinygltf::Model& model, std::string where)
    : m_model(model)
    , m_where(std::move(where))
    , m_nodes(readNodes(model))
    , m_clips(readClips(model, m_nodes, m_where))
    , m_targets(model, m_nodes, m_where)
{
}

// The skin that moves the primitive, when it has one that can.
std::optional<int> GltfDeformation::skinOf(const tinygltf::Primitive& primitive, int node, const glm::dmat4& world) const
{
    const int skin = node >= 0 ? m_model.nodes[std::size_t(node)].skin : -1;
    const bool moves
        = skin >= 0 && std::size_t(skin) < m_model.skins.size() && primitive.attributes.contains("JOINTS_0") && inverseOf(world);
    return moves ? std::optional(skin) : std::nullopt;
}

// Those of its first joints that the file holds.
std::vector<glm::dmat4> GltfDeformation::bindMatrices(const tinygltf::Skin& skin) const
{
    const Expected<std::vector<float>> numbers = skin.inverseBindMatrices >= 0 ? readFloats(m_model, skin.inverseBindMatrices, 16, m_where)
                                                                               : Expected<std::vector<float>>(std::vector<float>());
    std::vector<glm::dmat4> matrices;
    for (std::size_t i = 0; numbers && i + 16 <= numbers->size(); i += 16)
        matrices.emplace_back(glm::make_mat4(numbers->data() + i));
    return matrices;
}

glm::dmat4 GltfDeformation::storedAt(const tinygltf::Primitive& primitive, int node, const glm::dmat4& world)
{
    const std::optional<int> skin = skinOf(primitive, node, world);
    if (!skin)
        return world;
    const auto [place, isNew] = m_skinPlaces.try_emplace(*skin, 0.0);
    if (isNew) {
        const tinygltf::Skin& used = m_model.skins[std::size_t(*skin)];
        const std::vector<glm::dmat4> bind = bindMatrices(used);
        const int joint = used.joints.empty() ? -1 : used.joints.front();
        const int number = m_nodes.numberOf(joint);
        if (number >= 0)
            place->second = glm::dvec3(m_nodes.rest[std::size_t(number)] * (bind.empty() ? glm::dmat4(1.0) : bind.front())[3]);
    }
    glm::dmat4 stored = world;
    if (isFar(glm::dvec3(world[3]) - place->second))
        stored[3] = glm::dvec4(place->second, 1.0);
    return stored;
}

Expected<void> GltfDeformation::addPrimitive(
    const tinygltf::Primitive& primitive, int node, const glm::dmat4& world, std::size_t first, const RawMesh& raw)
{
    const std::size_t count = raw.positions.size() - first;
    if (const std::optional<int> skin = skinOf(primitive, node, world)) {
        if (Expected<void> added = addInfluences(primitive, *skin, world, count); !added)
            return added;
    } else {
        Influence rigid;
        rigid.joints[0] = rigidJoint(node, world);
        m_influences.resize(raw.positions.size(), rigid);
    }
    return m_targets.addPrimitive(primitive, node, world, first, raw);
}

std::uint16_t GltfDeformation::rigidJoint(int node, const glm::dmat4& world)
{
    const std::optional<glm::dmat4> fromMesh = inverseOf(world);
    const int number = m_nodes.numberOf(node);
    if (!fromMesh || number < 0 || !m_clips.moves[std::size_t(number)] || m_joints.size() >= kMostJoints)
        return 0;
    if (m_joints.back().node == number && m_joints.back().fromMesh == *fromMesh) // another primitive of the same node
        return std::uint16_t(m_joints.size() - 1);
    m_joints.push_back({number, *fromMesh});
    return std::uint16_t(m_joints.size() - 1);
}

// The skin's joints for a mesh placed by `world`, from the returned number on.
std::uint16_t GltfDeformation::firstJointOf(int skinNumber, const glm::dmat4& world)
{
    for (const SkinUse& use : m_skins)
        if (use.skin == skinNumber && use.world == world)
            return use.firstJoint;
    const tinygltf::Skin& skin = m_model.skins[std::size_t(skinNumber)];
    const auto first = std::uint16_t(m_joints.size());
    const std::vector<glm::dmat4> bind = bindMatrices(skin);
    for (std::size_t j = 0; j < skin.joints.size() && m_joints.size() < kMostJoints; ++j) {
        Joint joint;
        joint.node = m_nodes.numberOf(skin.joints[j]);
        const bool hasMatrix = j < bind.size();
        const glm::dmat4 meshToJoint = hasMatrix ? bind[j] : glm::dmat4(1.0);
        const bool isSound = isFinite(glm::mat4(meshToJoint));
        m_missingJoints += joint.node < 0 || !isSound || (skin.inverseBindMatrices >= 0 && !hasMatrix);
        joint.fromMesh = (isSound ? meshToJoint : glm::dmat4(1.0)) * *inverseOf(world);
        m_joints.push_back(joint);
    }
    m_skins.push_back({skinNumber, world, first});
    return first;
}

Expected<void> GltfDeformation::addInfluences(const tinygltf::Primitive& primitive, int skin, const glm::dmat4& world, std::size_t count)
{
    std::vector<std::vector<float>> joints, weights; // of each set of four
    for (int set = 0; primitive.attributes.contains("JOINTS_" + std::to_string(set)) && set < 8; ++set) {
        for (auto [key, list] : {std::pair("JOINTS_", &joints), std::pair("WEIGHTS_", &weights)}) {
            Expected<std::vector<float>> read = readAttribute(m_model, primitive.attributes, key + std::to_string(set), 4, count, m_where);
            if (!read)
                return tl::unexpected(read.error());
            read->resize(count * 4, 0.f);
            list->push_back(std::move(*read));
        }
    }
    const std::uint16_t first = firstJointOf(skin, world);
    const std::size_t known = std::min(m_model.skins[std::size_t(skin)].joints.size(), m_joints.size() - first);
    std::vector<Pull> pulls;
    for (std::size_t i = 0; i < count; ++i) {
        pulls.clear();
        float sum = 0.f;
        for (std::size_t k = 0; k < joints.size() * 4; ++k) {
            const float joint = joints[k / 4][i * 4 + k % 4], weight = weights[k / 4][i * 4 + k % 4];
            if (!(weight > 0.f && weight < 1e6f))
                continue;
            sum += weight;
            if (joint < float(known))
                pulls.push_back({std::uint16_t(first + std::uint16_t(joint)), weight});
            else
                ++m_missingJoints;
        }
        m_manyInfluences += pulls.size() > 4;
        const std::optional<Influence> influence = strongest(pulls);
        m_oddWeights += !influence || std::abs(sum - 1.f) > 0.01f;
        m_influences.push_back(influence.value_or(Influence()));
    }
    return {};
}

std::optional<RawDeformation> GltfDeformation::finished(Warnings& warnings)
{
    struct Row {
        std::size_t count;
        const char *code, *text;
    };
    const Row rows[] = {
        {m_missingJoints, "skin-joints", " joints or bind matrices of the skeleton are missing; what they pull stands still."},
        {m_oddWeights, "skin-weights", " vertices have skin weights that do not sum to 1; they were scaled."},
        {m_manyInfluences, "skin-influences", " vertices follow more than four joints; the strongest four count."},
        {m_clips.broken, "animation-channels", " animation channels are broken and were left out."},
        {m_clips.unsorted, "animation-times", " animation channels have keys that are not in the order of time; they were sorted."},
    };
    for (const Row& row : rows)
        if (row.count > 0)
            warnings.push_back({row.code, std::to_string(row.count) + row.text});
    RawDeformation raw = m_targets.finished(m_influences.size());
    if (m_clips.clips.empty() && raw.pieces.empty() && m_skins.empty() && !raw.isCut)
        return std::nullopt;
    raw.deformation.influences = std::move(m_influences);
    raw.deformation.joints = std::move(m_joints);
    raw.deformation.nodes = std::move(m_nodes.nodes);
    raw.deformation.clips = std::move(m_clips.clips);
    return raw;
}

} // namespace relievo
