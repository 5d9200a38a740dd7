// The animations of a glTF file with every count checked.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/animation/gltf_animation.h"
#include "core/mesh/readers/gltf_accessor.h"
#include <algorithm>
#include <numeric>

namespace relievo {

namespace {
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

// Of a node of the file.
std::size_t targetCount(const tinygltf::Model& model, int node)
{
    const int mesh = model.nodes[std::size_t(node)].mesh;
    if (mesh < 0 || std::size_t(mesh) >= model.meshes.size() || model.meshes[std::size_t(mesh)].primitives.empty())
        return 0;
    return model.meshes[std::size_t(mesh)].primitives.front().targets.size();
}

// Nothing when it is broken; its keys are in the order of the file.
std::optional<AnimationChannel> channelOf(const tinygltf::Model& model, const GltfNodes& nodes, const tinygltf::Animation& animation,
    const tinygltf::AnimationChannel& from, const std::string& where)
{
    const auto* path = std::ranges::find(kPaths, from.target_path, &PathRow::path);
    const int node = nodes.numberOf(from.target_node);
    if (path == std::end(kPaths) || node < 0 || from.sampler < 0 || std::size_t(from.sampler) >= animation.samplers.size())
        return std::nullopt;
    const tinygltf::AnimationSampler& sampler = animation.samplers[std::size_t(from.sampler)];
    const auto* interpolation = std::ranges::find(kInterpolations, sampler.interpolation, &InterpolationRow::name);
    AnimationChannel channel;
    channel.node = node;
    channel.what = path->what;
    channel.components = path->components == 0 ? targetCount(model, from.target_node) : path->components;
    if (interpolation == std::end(kInterpolations) || channel.components == 0
        || (channel.what != Animated::Weights && nodes.nodes[std::size_t(node)].matrix))
        return std::nullopt;
    channel.interpolation = interpolation->interpolation;
    Expected<std::vector<float>> times = readFloats(model, sampler.input, 1, where);
    Expected<std::vector<float>> values = readFloats(model, sampler.output, path->components == 0 ? 1 : int(path->components), where);
    if (!times || !values || times->empty())
        return std::nullopt;
    const std::size_t numbers = channel.components * (channel.interpolation == Interpolation::CubicSpline ? 3 : 1);
    if (values->size() != times->size() * numbers || !std::ranges::all_of(*times, isSmall) || !std::ranges::all_of(*values, isSmall))
        return std::nullopt;
    channel.times = std::move(*times);
    channel.values = std::move(*values);
    return channel;
}
} // namespace

GltfClips readClips(const tinygltf::Model& model, const GltfNodes& nodes, const std::string& where)
{
    GltfClips read;
    read.moves.assign(nodes.nodes.size(), false);
    for (const tinygltf::Animation& animation : model.animations) {
        AnimationClip clip;
        clip.name = animation.name.empty() ? "clip " + std::to_string(read.clips.size()) : animation.name;
        for (const tinygltf::AnimationChannel& from : animation.channels) {
            std::optional<AnimationChannel> channel = channelOf(model, nodes, animation, from, where);
            if (!channel) {
                ++read.broken;
                continue;
            }
            read.unsorted += sortKeys(*channel);
            clip.seconds = std::max(clip.seconds, channel->times.back());
            if (channel->what != Animated::Weights)
                read.moves[std::size_t(channel->node)] = true;
            clip.channels.push_back(std::move(*channel));
        }
        if (!clip.channels.empty())
            read.clips.push_back(std::move(clip));
    }
    for (std::size_t i = 0; i < read.moves.size(); ++i)
        if (const int parent = nodes.nodes[i].parent; parent >= 0 && read.moves[std::size_t(parent)])
            read.moves[i] = true;
    return read;
}

} // namespace relievo
