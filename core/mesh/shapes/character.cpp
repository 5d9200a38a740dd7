// The figure: tubes for its limbs, a skeleton in them, and a walk.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shapes/character.h"
#include "core/mesh/animation/pose.h"
#include "core/mesh/shapes/shape_grid.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace relievo {

namespace {

// Nodes of the skeleton; joint i + 1 moves with node i, joint 0 never moves.
enum Bone { Hips, Chest, Head, LeftThigh, LeftCalf, RightThigh, RightCalf, LeftArm, LeftForearm, RightArm, RightForearm, BoneCount };
struct BoneRow {
    int parent;
    glm::vec3 at; // where it turns, m
    float swing[4]; // degrees about x: mean, and amplitudes of cosine and sine of the step, and of the cosine of twice that
};
constexpr BoneRow kBones[BoneCount] = {
    {-1, {0.f, 0.02f, 0.f}, {3.f, 0.f, 0.f, 1.f}},
    {Hips, {0.f, 0.12f, 0.f}, {2.f, 0.f, 0.f, -2.f}},
    {Chest, {0.f, 0.33f, 0.f}, {-4.f, 0.f, 0.f, 2.f}},
    {Hips, {0.08f, 0.f, 0.f}, {-6.f, -28.f, 0.f, 0.f}},
    {LeftThigh, {0.08f, -0.24f, 0.f}, {24.f, 0.f, 22.f, 0.f}},
    {Hips, {-0.08f, 0.f, 0.f}, {-6.f, 28.f, 0.f, 0.f}},
    {RightThigh, {-0.08f, -0.24f, 0.f}, {24.f, 0.f, -22.f, 0.f}},
    {Chest, {0.145f, 0.25f, 0.f}, {0.f, 26.f, 0.f, 0.f}},
    {LeftArm, {0.18f, 0.06f, 0.f}, {-28.f, 12.f, 0.f, 0.f}},
    {Chest, {-0.145f, 0.25f, 0.f}, {0.f, -26.f, 0.f, 0.f}},
    {RightArm, {-0.18f, 0.06f, 0.f}, {-28.f, -12.f, 0.f, 0.f}},
};

// A tube from top to bottom with rounded ends; its upper part hangs on one bone, its lower part on another.
struct Limb {
    glm::vec3 top, bottom; // m
    float radius[3]; // at the top, in the middle, at the bottom; along x
    float flat; // radius along z over that along x
    Bone upper, lower;
    float tilesAround;
};
constexpr Limb kLimbs[] = {
    {{0.f, 0.37f, 0.f}, {0.f, -0.09f, 0.f}, {0.12f, 0.145f, 0.135f}, 0.72f, Chest, Hips, 3.f},
    {{0.f, 0.50f, 0.01f}, {0.f, 0.31f, 0.f}, {0.10f, 0.095f, 0.05f}, 1.05f, Head, Head, 2.f},
    {{0.08f, 0.04f, 0.f}, {0.085f, -0.45f, 0.f}, {0.08f, 0.062f, 0.04f}, 1.f, LeftThigh, LeftCalf, 2.f},
    {{-0.08f, 0.04f, 0.f}, {-0.085f, -0.45f, 0.f}, {0.08f, 0.062f, 0.04f}, 1.f, RightThigh, RightCalf, 2.f},
    {{0.085f, -0.42f, 0.03f}, {0.085f, -0.5f, 0.05f}, {0.04f, 0.05f, 0.05f}, 2.1f, LeftCalf, LeftCalf, 1.f},
    {{-0.085f, -0.42f, 0.03f}, {-0.085f, -0.5f, 0.05f}, {0.04f, 0.05f, 0.05f}, 2.1f, RightCalf, RightCalf, 1.f},
    {{0.125f, 0.30f, 0.f}, {0.205f, -0.15f, 0.f}, {0.056f, 0.043f, 0.032f}, 1.f, LeftArm, LeftForearm, 1.f},
    {{-0.125f, 0.30f, 0.f}, {-0.205f, -0.15f, 0.f}, {0.056f, 0.043f, 0.032f}, 1.f, RightArm, RightForearm, 1.f},
};

// s once around, seen from outside to the right; t down.
glm::vec3 pointOf(const Limb& limb, float s, float t)
{
    const float along = 0.5f - 0.5f * std::cos(kPi * t), angle = 2.f * kPi * (s - std::floor(s));
    const float middle = 4.f * along * (1.f - along);
    const float radius = (along < 0.5f ? limb.radius[0] : limb.radius[2]) * (1.f - middle) + limb.radius[1] * middle;
    const float blunt = std::clamp(4.f * limb.radius[1] / glm::length(limb.bottom - limb.top), 0.3f, 1.f); // 1: an ellipsoid
    const float round = std::pow(std::max(std::sin(kPi * t), 0.f), blunt);
    return limb.top + (limb.bottom - limb.top) * along + radius * round * glm::vec3(std::sin(angle), 0.f, limb.flat * std::cos(angle));
}

glm::vec3 normalOf(const Limb& limb, float s, float t)
{
    if (t <= 0.f || t >= 1.f)
        return {0.f, t <= 0.f ? 1.f : -1.f, 0.f};
    const float step = 1e-3f;
    const glm::vec3 across = pointOf(limb, s + step, t) - pointOf(limb, s - step, t);
    const glm::vec3 down = pointOf(limb, s, std::min(t + step, 1.f)) - pointOf(limb, s, std::max(t - step, 0.f));
    return glm::normalize(glm::cross(down, across));
}

Influence influenceOf(const Limb& limb, float y)
{
    const float joint = kBones[limb.lower].at.y, blend = 0.06f;
    const float share = limb.upper == limb.lower ? 1.f : std::clamp(0.5f + 0.5f * (y - joint) / blend, 0.f, 1.f);
    const float upper = share * share * (3.f - 2.f * share);
    return {{std::uint16_t(limb.upper + 1), std::uint16_t(limb.lower + 1), 0, 0}, {upper, 1.f - upper, 0.f, 0.f}};
}

void addLimb(Mesh& mesh, std::vector<Influence>& influences, const Limb& limb)
{
    constexpr unsigned kColumns = 32, kRows = 64;
    const auto first = std::uint32_t(mesh.vertices.size());
    // v grows with the way down over the tube's girth there, so that texels are square; not at the ends, where the girth is nothing.
    const float least = 0.35f * limb.radius[1];
    float v = 0.f;
    for (unsigned j = 0; j <= kRows; ++j) {
        if (j > 0) {
            const float before = float(j - 1) / float(kRows), here = float(j) / float(kRows), middle = 0.5f * (before + here);
            const float girth = 0.5f * (1.f + limb.flat) * 0.5f * glm::distance(pointOf(limb, 0.25f, middle), pointOf(limb, 0.75f, middle));
            v += glm::distance(pointOf(limb, 0.25f, before), pointOf(limb, 0.25f, here)) * limb.tilesAround
                / (2.f * kPi * std::max(girth, least));
        }
        for (unsigned i = 0; i <= kColumns; ++i) {
            const float s = float(i) / float(kColumns), t = float(j) / float(kRows);
            const bool pole = j == 0 || j == kRows;
            const glm::vec3 position = pointOf(limb, s, t);
            const float u = s + (pole ? 0.5f / float(kColumns) : 0.f);
            mesh.vertices.push_back({.position = position,
                .normal = normalOf(limb, s, t),
                .uv = {limb.tilesAround * u, v},
                .tangent = {},
                .dPdu = {},
                .dPdv = {}});
            influences.push_back(influenceOf(limb, position.y));
        }
    }
    for (unsigned j = 0; j < kRows; ++j)
        for (unsigned i = 0; i < kColumns; ++i) { // at an end one of the two is a line
            const std::uint32_t a = first + j * (kColumns + 1) + i, b = a + kColumns + 1;
            if (j + 1 < kRows)
                mesh.indices.insert(mesh.indices.end(), {a, b, b + 1});
            else
                mesh.indices.insert(mesh.indices.end(), {a, b, a + 1});
            if (j > 0 && j + 1 < kRows)
                mesh.indices.insert(mesh.indices.end(), {a, b + 1, a + 1});
        }
}

AnimationChannel swingOf(int node, const float (&swing)[4])
{
    constexpr int kKeys = 24;
    AnimationChannel channel{node, Animated::Rotation, Interpolation::Linear, {}, 4, {}};
    for (int key = 0; key <= kKeys; ++key) {
        const float step = 2.f * kPi * float(key % kKeys) / float(kKeys);
        const float degrees = swing[0] + swing[1] * std::cos(step) + swing[2] * std::sin(step) + swing[3] * std::cos(2.f * step);
        const float half = 0.5f * degrees * kPi / 180.f;
        channel.times.push_back(1.2f * float(key) / float(kKeys));
        channel.values.insert(channel.values.end(), {std::sin(half), 0.f, 0.f, std::cos(half)});
    }
    return channel;
}

// centre: of the mesh, which is where the figure is moved away from.
std::shared_ptr<const Deformation> walk(std::vector<Influence> influences, glm::vec3 centre)
{
    auto deformation = std::make_shared<Deformation>();
    deformation->influences = std::move(influences);
    deformation->joints.push_back({});
    AnimationClip clip{"walk", 1.2f, {}};
    for (int bone = 0; bone < BoneCount; ++bone) {
        const BoneRow& row = kBones[bone];
        PoseNode node;
        node.parent = row.parent;
        node.translation = row.at - (row.parent >= 0 ? kBones[row.parent].at : centre);
        deformation->nodes.push_back(node);
        deformation->joints.push_back({bone, glm::translate(glm::mat4(1.f), centre - row.at)});
        clip.channels.push_back(swingOf(bone, row.swing));
    }
    deformation->clips.push_back(std::move(clip));
    return deformation;
}
} // namespace

void makeCharacter(Mesh& mesh)
{
    std::vector<Influence> influences;
    for (const Limb& limb : kLimbs)
        addLimb(mesh, influences, limb);
    glm::vec3 low = mesh.vertices.front().position, high = low;
    for (const Vertex& vertex : mesh.vertices)
        low = glm::min(low, vertex.position), high = glm::max(high, vertex.position);
    const glm::vec3 centre = 0.5f * (low + high);
    for (Vertex& vertex : mesh.vertices)
        vertex.position -= centre;
    mesh.deformation = walk(std::move(influences), centre);
}

} // namespace relievo
