// Transforms of glTF nodes with every number checked, and the order in which parents come first.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/animation/gltf_nodes.h"
#include <algorithm>
#include <cmath>

namespace relievo {

namespace {
std::optional<glm::dvec3> tripleOf(const std::vector<double>& list)
{
    if (list.size() != 3 || !std::ranges::all_of(list, [](double number) { return isSmall(float(number)); }))
        return std::nullopt;
    return glm::dvec3(list[0], list[1], list[2]);
}
} // namespace

bool isSmall(float number)
{
    return std::abs(number) < 1e15f;
}

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

GltfNodes readNodes(const tinygltf::Model& model)
{
    const std::size_t count = model.nodes.size();
    const auto exists = [count](int node) { return node >= 0 && std::size_t(node) < count; };
    std::vector<bool> isChild(count);
    for (const tinygltf::Node& node : model.nodes)
        for (const int child : node.children)
            if (exists(child))
                isChild[std::size_t(child)] = true;
    GltfNodes read;
    read.numbers.assign(count, -1);
    std::vector<int> order; // the file's number of each
    const auto add = [&](int node, int parent) {
        if (!exists(node) || read.numbers[std::size_t(node)] >= 0)
            return;
        read.numbers[std::size_t(node)] = int(read.nodes.size());
        read.nodes.push_back(poseNodeOf(model.nodes[std::size_t(node)]));
        read.nodes.back().parent = parent;
        order.push_back(node);
    };
    for (std::size_t i = 0; i < count; ++i)
        if (!isChild[i])
            add(int(i), -1);
    for (std::size_t done = 0; done < order.size(); ++done) {
        const int parent = read.nodes[done].parent;
        read.rest.push_back((parent < 0 ? glm::dmat4(1.0) : read.rest[std::size_t(parent)]) * localMatrix(read.nodes[done]));
        for (const int child : model.nodes[std::size_t(order[done])].children)
            add(child, int(done));
    }
    return read;
}

} // namespace relievo
