// Edges counted in both directions.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edges/closed.h"
#include "core/mesh/edges/places.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace relievo {

bool isClosed(const Mesh& mesh)
{
    const std::vector<std::uint32_t> place = placesOf(mesh);
    std::unordered_map<std::uint64_t, int> balance; // of an edge: passages from its lower to its higher end less those back
    balance.reserve(mesh.indices.size());
    double volume = 0.;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t from = place[mesh.indices[i + k]], to = place[mesh.indices[i + (k + 1) % 3]];
            if (from != to)
                balance[std::min(from, to) << 32 | std::max(from, to)] += from < to ? 1 : -1;
        }
        const auto at = [&](std::size_t k) { return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position - mesh.boundsMin); };
        volume += glm::dot(at(0), glm::cross(at(1), at(2)));
    }
    return volume > 0. && std::ranges::all_of(balance, [](const auto& edge) { return edge.second == 0; });
}

} // namespace relievo
