// Meshes in coordinates of a country: floats near their own origin hold what floats near the far one would round away.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/readers/raw_mesh.h"
#include <algorithm>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace relievo {

namespace {
const glm::dvec3 kZero(0.0);

// Poses of what is stored relative to `origin` are so as well.
void follow(Deformation& deformation, glm::dvec3 origin)
{
    deformation.origin = origin;
    for (Joint& joint : deformation.joints)
        joint.fromMesh = glm::translate(joint.fromMesh, origin);
}
} // namespace

bool isFar(glm::dvec3 position)
{
    constexpr double kNear = 1e4, kBeyondFloats = 1e14; // m
    const double distance = glm::length(position); // NaN is neither
    return distance > kNear && distance < kBeyondFloats;
}

void RawMesh::addPosition(glm::dvec3 position)
{
    if (positions.empty() && isFar(position))
        origins.back().at = glm::round(position);
    positions.emplace_back(position - origins.back().at);
}

const glm::dvec3& RawMesh::originOf(std::size_t position) const
{
    return std::prev(std::ranges::upper_bound(origins, position, {}, &Origin::first))->at;
}

glm::dvec3 originFor(glm::dvec3 low, glm::dvec3 high)
{
    constexpr double kFarInSizes = 1e4;
    const glm::dvec3 size = high - low, centre = 0.5 * (low + high);
    return isFar(centre) && glm::length(centre) > kFarInSizes * std::max({size.x, size.y, size.z}) ? glm::round(centre) : kZero;
}

void settleOrigin(RawMesh& raw)
{
    if (raw.corners.empty() || std::ranges::all_of(raw.origins, [](const RawMesh::Origin& origin) { return origin.at == kZero; }))
        return;
    const auto pointOf
        = [&raw](const RawMesh::Corner& corner) { return glm::dvec3(raw.positions[corner.position]) + raw.originOf(corner.position); };
    glm::dvec3 low = pointOf(raw.corners.front()), high = low;
    for (const RawMesh::Corner& corner : raw.corners) {
        const glm::dvec3 point = pointOf(corner);
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    const glm::dvec3 origin = originFor(low, high) != kZero ? raw.originOf(raw.corners.front().position) : kZero;
    for (std::size_t k = 0; k < raw.origins.size(); ++k) {
        const std::size_t end = k + 1 < raw.origins.size() ? raw.origins[k + 1].first : raw.positions.size();
        for (std::size_t i = raw.origins[k].first; raw.origins[k].at != origin && i < end; ++i)
            raw.positions[i] = glm::vec3(glm::dvec3(raw.positions[i]) + (raw.origins[k].at - origin));
    }
    raw.origins = {{0, origin}};
    if (origin == kZero)
        return;
    if (raw.moves)
        follow(raw.moves->deformation, origin);
    char place[128];
    std::snprintf(place, sizeof place, "(%.0f, %.0f, %.0f)", origin.x, origin.y, origin.z);
    raw.warn("mesh-moved", std::string("The mesh lies very far from the origin; it was moved from ") + place + " to there.");
}

} // namespace relievo
