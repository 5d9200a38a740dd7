// Meshes in coordinates of a country: floats near their own origin hold what floats near the far one would round away.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/raw_mesh.h"
#include <algorithm>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace relievo {

void RawMesh::addPosition(glm::dvec3 position)
{
    constexpr double kNear = 1e4, kBeyondFloats = 1e14; // m
    const double distance = glm::length(position); // NaN is neither
    if (positions.empty() && distance > kNear && distance < kBeyondFloats)
        origin = glm::round(position);
    positions.emplace_back(position - origin);
}

void settleOrigin(RawMesh& raw)
{
    constexpr double kFarInSizes = 1e4;
    if (raw.origin == glm::dvec3(0.0) || raw.corners.empty())
        return;
    glm::dvec3 low(raw.positions[raw.corners.front().position]), high(low);
    for (const RawMesh::Corner& corner : raw.corners) {
        low = glm::min(low, glm::dvec3(raw.positions[corner.position]));
        high = glm::max(high, glm::dvec3(raw.positions[corner.position]));
    }
    const glm::dvec3 size = high - low, centre = raw.origin + 0.5 * (low + high);
    if (glm::length(centre) > kFarInSizes * std::max({size.x, size.y, size.z})) {
        char place[128];
        std::snprintf(place, sizeof place, "(%.0f, %.0f, %.0f)", raw.origin.x, raw.origin.y, raw.origin.z);
        raw.warn("mesh-moved", std::string("The mesh lies very far from the origin; it was moved from ") + place + " to there.");
        return;
    }
    for (glm::vec3& position : raw.positions)
        position = glm::vec3(glm::dvec3(position) + raw.origin);
}

} // namespace relievo
