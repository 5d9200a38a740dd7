// Mitred normals by position.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/push.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <tuple>

namespace relievo {

std::vector<glm::vec3> pushDirections(const Mesh& mesh)
{
    std::vector<std::uint32_t> order(mesh.vertices.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        order[i] = i;
    const auto key = [&](std::uint32_t i) {
        const glm::vec3 p = mesh.vertices[i].position;
        return std::tuple(p.x, p.y, p.z);
    };
    std::ranges::sort(order, {}, key);

    std::vector<glm::vec3> push(order.size());
    for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
        glm::vec3 sum(0.f);
        for (last = first; last < order.size() && key(order[last]) == key(order[first]); ++last)
            sum += mesh.vertices[order[last]].normal;
        const float length = glm::length(sum);
        const glm::vec3 mean = length > 1e-6f ? sum / length : mesh.vertices[order[first]].normal;
        float least = 1.f;
        for (std::size_t i = first; i < last; ++i)
            least = std::min(least, glm::dot(mean, mesh.vertices[order[i]].normal));
        for (std::size_t i = first; i < last; ++i)
            push[order[i]] = mean / std::max(least, 1.f / 3.f);
    }
    return push;
}

} // namespace relievo
