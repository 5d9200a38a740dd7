// The node hierarchy of a glTF file in order of descent, and its animations with every count checked.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/animation/gltf_deformation.h"
#include "core/mesh/readers/gltf_accessor.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace relievo {

namespace {
bool isSmall(float number)
{
    return std::abs(number) < 1e15f;
} // false for NaN

std::optional<glm::dvec3> tripleOf(const std::vector<double>& list)
{
    if (list.size() != 3 || !std::ranges::all_of(list, [](double number) { return isSmall(float(number)); }))
        return std::nullopt;
    return glm::dvec3(list[0], list[1], list[2]);
}

struct PathRow {
    std::string_view path;
    Animated what;
    std::size_t components; // 0: as many as the node has targets
};
constexpr PathRow kPaths[] = {
    {"translation", Animated::Translation, 3},
    {"rotation", Animated::Rotation, 4},
    {"scale", Animated::Scale, 3},
    {"weights", Animated::Weights, 0},
};

struct InterpolationRow {
    std::string_view name;
    Interpolation interpolation;
};
constexpr InterpolationRow kInterpolations[] = {
    {"LINEAR", Interpolation::Linear},
    {"", Interpolation::Linear},
    {"STEP", Interpolation::Step},
    {"CUBICSPLINE", Interpolation::CubicSpline},
};

// Keys in the order of time; of several at one time the last stands. Whether they were out of order.
bool sortKeys(AnimationChannel& channel)
{
    if (std::ranges::is_sorted(channel.times))
        return false;
    const std::size_t numbers = channel.values.size() / channel.times.size();
    std::vector<std::size_t> order(channel.times.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [&](std::size_t key) { return channel.times[key]; });
    AnimationChannel sorted = channel;
    for (std::size_t i = 0; i < order.size(); ++i) {
        sorted.times[i] = channel.times[order[i]];
        std::copy_n(
            channel.values.begin() + std::ptrdiff_t(order[i] * numbers), numbers, sorted.values.begin() + std::ptrdiff_t(i * numbers));
    }
    channel = std::move(sorted);
    return true;
}
} // namespace

PoseNode poseNodeOf(const tinygltf::Node& from)
{
    PoseNode node;
    if (from.matrix.size() == 16) {
        glm::dmat4 matrix(1.0);
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = from.matrix[std::size_t(i)];
        node.matrix = matrix;
    }
    node.translation = tripleOf(from.translation).value_or(node.translation);
    node.scale = tripleOf(from.scale).value_or(node.scale);
    if (from.rotation.size() == 4) {
        const glm::dquat q(from.rotation[3], from.rotation[0], from.rotation[1], from.rotation[2]);
        if (const double square = glm::dot(q, q); square > 1e-12 && isSmall(float(square)))
            node.rotation = glm::normalize(q);
    }
    return node;
}

void GltfDeformation::orderNodes()
{
    const std::size_t count = m_model.nodes.size();
    const auto exists = [count](int node) { return node >= 0 && std::size_t(node) < count; };
    std::vector<bool> isChild(count);
    for (const tinygltf::Node& node : m_model.nodes)
        for (const int child : node.children)
            if (exists(child))
                isChild[std::size_t(child)] = true;
    m_nodeNumbers.assign(count, -1);
    std::vector<PoseNode>& nodes = m_raw.deformation.nodes;
    std::vector<int> order; // the file's number of each
    const auto add = [&](int node, int parent) {
        if (!exists(node) || m_nodeNumbers[std::size_t(node)] >= 0)
            return;
        m_nodeNumbers[std::size_t(node)] = int(nodes.size());
        nodes.push_back(poseNodeOf(m_model.nodes[std::size_t(node)]));
        nodes.back().parent = parent;
        order.push_back(node);
    };
    for (std::size_t i = 0; i < count; ++i)
        if (!isChild[i])
            add(int(i), -1);
    for (std::size_t done = 0; done < order.size(); ++done) {
        const int parent = nodes[done].parent;
        m_rest.push_back((parent < 0 ? glm::dmat4(1.0) : m_rest[std::size_t(parent)]) * localMatrix(nodes[done]));
        for (const int child : m_model.nodes[std::size_t(order[done])].children)
            add(child, int(done));
    }
}

void GltfDeformation::readClips()
{
    m_animated.assign(m_raw.deformation.nodes.size(), false);
    for (const tinygltf::Animation& animation : m_model.animations) {
        AnimationClip clip;
        clip.name = animation.name.empty() ? "clip " + std::to_string(m_raw.deformation.clips.size()) : animation.name;
        for (const tinygltf::AnimationChannel& from : animation.channels) {
            std::optional<AnimationChannel> channel = channelOf(animation, from);
            if (!channel) {
                ++m_brokenChannels;
                continue;
            }
            m_unsorted += sortKeys(*channel);
            clip.seconds = std::max(clip.seconds, channel->times.back());
            if (channel->what != Animated::Weights)
                m_animated[std::size_t(channel->node)] = true;
            clip.channels.push_back(std::move(*channel));
        }
        if (!clip.channels.empty())
            m_raw.deformation.clips.push_back(std::move(clip));
    }
    for (std::size_t i = 0; i < m_animated.size(); ++i)
        if (const int parent = m_raw.deformation.nodes[i].parent; parent >= 0 && m_animated[std::size_t(parent)])
            m_animated[i] = true;
}

std::size_t GltfDeformation::targetCount(int node) const
{
    const int mesh = m_model.nodes[std::size_t(node)].mesh;
    if (mesh < 0 || std::size_t(mesh) >= m_model.meshes.size() || m_model.meshes[std::size_t(mesh)].primitives.empty())
        return 0;
    return m_model.meshes[std::size_t(mesh)].primitives.front().targets.size();
}

std::optional<AnimationChannel> GltfDeformation::channelOf(const tinygltf::Animation& animation, const tinygltf::AnimationChannel& from)
{
    const auto* path = std::ranges::find(kPaths, from.target_path, &PathRow::path);
    const bool hasNode = from.target_node >= 0 && std::size_t(from.target_node) < m_nodeNumbers.size()
        && m_nodeNumbers[std::size_t(from.target_node)] >= 0;
    if (path == std::end(kPaths) || !hasNode || from.sampler < 0 || std::size_t(from.sampler) >= animation.samplers.size())
        return std::nullopt;
    const tinygltf::AnimationSampler& sampler = animation.samplers[std::size_t(from.sampler)];
    const auto* interpolation = std::ranges::find(kInterpolations, sampler.interpolation, &InterpolationRow::name);
    AnimationChannel channel;
    channel.node = m_nodeNumbers[std::size_t(from.target_node)];
    channel.what = path->what;
    channel.components = path->components == 0 ? targetCount(from.target_node) : path->components;
    if (interpolation == std::end(kInterpolations) || channel.components == 0
        || (channel.what != Animated::Weights && m_raw.deformation.nodes[std::size_t(channel.node)].matrix))
        return std::nullopt;
    channel.interpolation = interpolation->interpolation;
    Expected<std::vector<float>> times = readFloats(m_model, sampler.input, 1, m_where);
    Expected<std::vector<float>> values = readFloats(m_model, sampler.output, path->components == 0 ? 1 : int(path->components), m_where);
    if (!times || !values || times->empty())
        return std::nullopt;
    const std::size_t numbers = channel.components * (channel.interpolation == Interpolation::CubicSpline ? 3 : 1);
    if (values->size() != times->size() * numbers || !std::ranges::all_of(*times, isSmall) || !std::ranges::all_of(*values, isSmall))
        return std::nullopt;
    channel.times = std::move(*times);
    channel.values = std::move(*values);
    return channel;
}

} // namespace relievo
