// The node hierarchy of a glTF file in order of descent.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/animation/pose.h"
#include <tiny_gltf.h>

namespace relievo {

struct GltfNodes {
    std::vector<PoseNode> nodes; // each after its parent
    std::vector<int> numbers; // of each node of the file in `nodes`; -1: it is part of a circle
    std::vector<glm::dmat4> rest; // of each of `nodes`: its world matrix at rest

    int numberOf(int node) const // -1 also for a node that the file does not hold
    {
        return node >= 0 && std::size_t(node) < numbers.size() ? numbers[std::size_t(node)] : -1;
    }
};

GltfNodes readNodes(const tinygltf::Model& model);

// A glTF node as a pose begins from it; transforms that are not finite stand still.
PoseNode poseNodeOf(const tinygltf::Node& node);

// Whether a number of a file is one to calculate with; false for NaN.
bool isSmall(float number);

} // namespace relievo
