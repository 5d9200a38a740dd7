// Sorting vertices by position.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edges/places.h"
#include <algorithm>
#include <tuple>

namespace relievo {

std::vector<std::uint32_t> placesOf(const Mesh& mesh)
{
    std::vector<std::uint32_t> order(mesh.vertices.size()), place(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        order[i] = i;
    const auto key = [&](std::uint32_t i) {
        const glm::vec3 p = mesh.vertices[i].position;
        return std::tuple(p.x, p.y, p.z);
    };
    std::ranges::sort(order, {}, key);
    for (std::size_t i = 0; i < order.size(); ++i)
        place[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? place[order[i - 1]] : std::uint32_t(i);
    return place;
}

} // namespace relievo
