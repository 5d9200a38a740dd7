// Meshes that move: skeleton, morph targets and animations of a file, and the mesh at a moment.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <optional>

namespace relievo {

// A posed vertex: p' = sum over k of weights[k] * Pose::joints[joints[k]] * (p + sum over targets t of Pose::weights[t] * deltas of t).
struct Influence {
    std::array<std::uint16_t, 4> joints{}; // into Deformation::joints; joint 0 never moves
    std::array<float, 4> weights{1.f, 0.f, 0.f, 0.f}; // sum to 1
    bool operator==(const Influence&) const = default;
};

bool isFinite(const glm::mat4& m);

// A node of the file's scene, relative to its parent.
struct PoseNode {
    int parent = -1; // into Deformation::nodes, always a smaller number
    glm::dvec3 translation{0.0}, scale{1.0}; // double: a node may stand far from the origin
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    std::optional<glm::dmat4> matrix; // instead of the three, when the file says so; never animated
};

glm::dmat4 localMatrix(const PoseNode& node);

// Pose::joints[i] = world matrix of `node` * fromMesh, where fromMesh takes the mesh as it is stored to the space of the joint.
struct Joint {
    int node = -1; // -1: never moves
    glm::dmat4 fromMesh{1.0};
};

// What a morph target adds at weight 1 to one vertex of the mesh as stored; the UVs stay. m; the normal is made unit afterwards.
struct MorphDelta {
    glm::vec3 position{0.f}, normal{0.f}, dPdu{0.f}, dPdv{0.f};
};

struct MorphTarget {
    std::string name;
    int node = -1; // whose mesh it belongs to, into Deformation::nodes
    float restWeight = 0.f;
    std::vector<MorphDelta> deltas; // one a vertex
};

enum class Interpolation { Linear, Step, CubicSpline };
enum class Animated { Translation, Rotation, Scale, Weights };

struct AnimationChannel {
    int node = 0;
    Animated what = Animated::Translation;
    Interpolation interpolation = Interpolation::Linear;
    std::vector<float> times; // s, ascending, at least one
    // `components` numbers a key; CubicSpline: three times as many, incoming tangent, value, outgoing tangent (glTF 2.0, appendix C).
    std::size_t components = 3;
    std::vector<float> values;
};

struct AnimationClip {
    std::string name;
    float seconds = 0.f; // the last key
    std::vector<AnimationChannel> channels;
};

struct Deformation {
    std::vector<Influence> influences; // one a vertex
    std::vector<Joint> joints; // at least one
    std::vector<MorphTarget> targets;
    std::vector<PoseNode> nodes;
    glm::dvec3 origin{0.0}; // m, of the mesh and its poses, as the nodes count
    std::vector<AnimationClip> clips;
};

struct Pose {
    std::vector<glm::mat4> joints; // as many as Deformation::joints
    std::vector<float> weights; // as many as Deformation::targets
    bool operator==(const Pose&) const = default;
};

// The pose in which the mesh is stored: every joint the identity, every weight 0. Without a deformation: empty.
Pose bindPose(const Mesh& mesh);

// The pose of clip number `clip` at `seconds`, held before its first and after its last key; the caller repeats it. For any other
// number: the pose in which the file's nodes rest. Always finite.
Pose poseAt(const Mesh& mesh, int clip, float seconds);

// The mesh in that pose: positions, normals and tangents as Influence says, Jacobians exact from the moved triangles, same
// vertices and indices, same metresPerUV. Without a deformation: the mesh.
Mesh posed(const Mesh& mesh, const Pose& pose);

} // namespace relievo
