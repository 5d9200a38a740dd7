// Mitred normals by position.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/frames/push.h"
#include "core/mesh/edges/places.h"
#include <algorithm>
#include <glm/geometric.hpp>

namespace relievo {

std::vector<glm::vec3> pushDirections(const Mesh& mesh)
{
    const std::vector<std::uint32_t> place = placesOf(mesh);
    std::vector<glm::vec3> mean(place.size(), glm::vec3(0.f)), push(place.size()); // mean: of the vertices of a place, by its number
    for (std::size_t i = 0; i < place.size(); ++i)
        mean[place[i]] += mesh.vertices[i].normal;
    std::vector<float> least(place.size(), 1.f);
    std::vector<char> known(place.size(), 0);
    for (std::size_t i = 0; i < place.size(); ++i) {
        glm::vec3& direction = mean[place[i]];
        if (!known[place[i]]) {
            const float length = glm::length(direction);
            direction = length > 1e-6f ? direction / length : mesh.vertices[i].normal;
            known[place[i]] = 1;
        }
        least[place[i]] = std::min(least[place[i]], glm::dot(direction, mesh.vertices[i].normal));
    }
    for (std::size_t i = 0; i < place.size(); ++i)
        push[i] = mean[place[i]] / std::max(least[place[i]], 1.f / 3.f);
    return push;
}

} // namespace relievo
