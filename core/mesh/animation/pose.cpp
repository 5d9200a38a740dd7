// Sampling animations and deforming a mesh on the CPU.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/animation/pose.h"
#include "core/mesh/frames/frames.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <tbb/parallel_for.h>

namespace relievo {

bool isFinite(const glm::mat4& m)
{
    float sum = 0.f;
    for (int k = 0; k < 4; ++k)
        sum += glm::dot(glm::abs(m[k]), glm::vec4(1.f));
    return std::isfinite(sum);
}

namespace {
// Where a moment lies among keys: between key and key + 1 by `share`, or on key when share is 0.
struct Moment {
    std::size_t key = 0;
    float share = 0.f, span = 0.f; // span: s
};

Moment momentOf(const std::vector<float>& times, float seconds)
{
    const auto after = std::upper_bound(times.begin(), times.end(), seconds);
    if (after == times.begin())
        return {};
    const std::size_t key = std::size_t(after - times.begin()) - 1;
    if (after == times.end())
        return {key};
    const float span = *after - times[key];
    return {key, span > 0.f ? (seconds - times[key]) / span : 0.f, span};
}

glm::quat quatOf(const std::vector<float>& v)
{
    return {v[3], v[0], v[1], v[2]};
}

std::vector<float> turned(const std::vector<float>& from, const std::vector<float>& to, float share)
{
    const glm::quat q = glm::slerp(glm::normalize(quatOf(from)), glm::normalize(quatOf(to)), share); // the short way round
    return {q.x, q.y, q.z, q.w};
}

// The channel's numbers at a moment.
std::vector<float> sampled(const AnimationChannel& channel, float seconds)
{
    const Moment at = momentOf(channel.times, seconds);
    const std::size_t n = channel.components;
    const bool cubic = channel.interpolation == Interpolation::CubicSpline;
    const auto numbers = [&](std::size_t key, std::size_t third) {
        const auto first = channel.values.begin() + std::ptrdiff_t((cubic ? 3 * key + third : key) * n);
        return std::vector<float>(first, first + std::ptrdiff_t(n));
    };
    std::vector<float> value = numbers(at.key, 1);
    if (at.share == 0.f || channel.interpolation == Interpolation::Step)
        return value;
    const std::vector<float> next = numbers(at.key + 1, 1);
    if (!cubic && channel.what == Animated::Rotation)
        return turned(value, next, at.share);
    const float t = at.share, t2 = t * t, t3 = t2 * t;
    if (!cubic) {
        for (std::size_t i = 0; i < n; ++i)
            value[i] += (next[i] - value[i]) * t;
        return value;
    }
    const std::vector<float> out = numbers(at.key, 2), in = numbers(at.key + 1, 0);
    for (std::size_t i = 0; i < n; ++i)
        value[i] = (2 * t3 - 3 * t2 + 1) * value[i] + at.span * (t3 - 2 * t2 + t) * out[i] + (3 * t2 - 2 * t3) * next[i]
            + at.span * (t3 - t2) * in[i];
    return value;
}

void apply(const AnimationChannel& channel, float seconds, const Deformation& deformation, std::vector<PoseNode>& nodes, Pose& pose)
{
    const std::vector<float> v = sampled(channel, seconds);
    PoseNode& node = nodes[std::size_t(channel.node)];
    switch (channel.what) {
    case Animated::Translation:
        node.translation = {v[0], v[1], v[2]};
        break;
    case Animated::Scale:
        node.scale = {v[0], v[1], v[2]};
        break;
    case Animated::Rotation:
        if (const glm::quat q = quatOf(v); glm::dot(q, q) > 1e-12f)
            node.rotation = glm::dquat(glm::normalize(q));
        break;
    case Animated::Weights:
        for (std::size_t t = 0, i = 0; t < deformation.targets.size() && i < v.size(); ++t)
            if (deformation.targets[t].node == channel.node)
                pose.weights[t] = v[i++];
    }
}

// The mesh's vertices moved by the targets, then by the joints.
Vertex moved(const Vertex& from, std::size_t at, const Deformation& deformation, const Pose& pose)
{
    Vertex vertex = from;
    for (std::size_t t = 0; t < std::min(deformation.targets.size(), pose.weights.size()); ++t) {
        const MorphDelta& delta = deformation.targets[t].deltas[at];
        vertex.position += pose.weights[t] * delta.position;
        vertex.normal += pose.weights[t] * delta.normal;
    }
    glm::mat4 skin(0.f);
    const Influence& influence = deformation.influences[at];
    for (std::size_t k = 0; k < 4; ++k)
        skin += influence.weights[k] * (influence.joints[k] < pose.joints.size() ? pose.joints[influence.joints[k]] : glm::mat4(1.f));
    const glm::mat3 linear(skin);
    const glm::mat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]), glm::cross(linear[0], linear[1]));
    vertex.position = glm::vec3(skin * glm::vec4(vertex.position, 1.f));
    const glm::vec3 normal = cofactors * vertex.normal * (glm::determinant(linear) < 0.f ? -1.f : 1.f);
    vertex.normal = glm::length(normal) > 1e-20f ? glm::normalize(normal) : from.normal;
    const glm::vec3 along = linear * glm::vec3(from.tangent);
    const glm::vec3 flat = along - vertex.normal * glm::dot(along, vertex.normal);
    vertex.tangent = glm::vec4(glm::length(flat) > 1e-20f ? glm::normalize(flat) : perpendicular(vertex.normal), from.tangent.w);
    const float sum
        = glm::dot(glm::abs(vertex.position), glm::vec3(1.f)) + glm::dot(vertex.normal + glm::vec3(vertex.tangent), glm::vec3(1.f));
    return sum < 1e15f ? vertex : from; // beyond, squares of lengths leave the range of float; false for NaN
}
} // namespace

glm::dmat4 localMatrix(const PoseNode& node)
{
    if (node.matrix)
        return *node.matrix;
    const glm::dmat4 turn = glm::mat4_cast(node.rotation);
    return glm::scale(glm::translate(glm::dmat4(1.0), node.translation) * turn, node.scale);
}

Pose bindPose(const Mesh& mesh)
{
    if (!mesh.deformation)
        return {};
    return {
        std::vector<glm::mat4>(mesh.deformation->joints.size(), glm::mat4(1.f)), std::vector<float>(mesh.deformation->targets.size(), 0.f)};
}

Pose poseAt(const Mesh& mesh, int clip, float seconds)
{
    Pose pose = bindPose(mesh);
    if (!mesh.deformation)
        return pose;
    const Deformation& deformation = *mesh.deformation;
    for (std::size_t t = 0; t < deformation.targets.size(); ++t)
        pose.weights[t] = deformation.targets[t].restWeight;
    std::vector<PoseNode> nodes = deformation.nodes;
    if (clip >= 0 && std::size_t(clip) < deformation.clips.size())
        for (const AnimationChannel& channel : deformation.clips[std::size_t(clip)].channels)
            apply(channel, std::isfinite(seconds) ? seconds : 0.f, deformation, nodes, pose);
    const glm::dmat4 scene = glm::translate(glm::dmat4(1.0), -deformation.origin);
    std::vector<glm::dmat4> worldFromNode(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
        worldFromNode[i] = (nodes[i].parent < 0 ? scene : worldFromNode[std::size_t(nodes[i].parent)]) * localMatrix(nodes[i]);
    for (std::size_t i = 0; i < pose.joints.size(); ++i) {
        const Joint& joint = deformation.joints[i];
        const glm::mat4 matrix(joint.node < 0 ? glm::dmat4(1.0) : worldFromNode[std::size_t(joint.node)] * joint.fromMesh);
        pose.joints[i] = isFinite(matrix) ? matrix : glm::mat4(1.f);
    }
    return pose;
}

Mesh posed(const Mesh& mesh, const Pose& pose)
{
    Mesh result = mesh;
    if (!mesh.deformation)
        return result;
    tbb::parallel_for(std::size_t(0), mesh.vertices.size(),
        [&](std::size_t i) { result.vertices[i] = moved(mesh.vertices[i], i, *mesh.deformation, pose); });
    refreshFrames(result);
    return result;
}

} // namespace relievo
