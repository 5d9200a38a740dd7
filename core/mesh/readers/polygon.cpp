// Polygons to triangles: fans where they are convex, cut ears where they are not.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/readers/raw_mesh.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace relievo {

namespace {
using Corner = RawMesh::Corner;
using Plane = std::vector<glm::dvec2>; // the polygon seen along its normal, counter-clockwise

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Plane flattened(const RawMesh& raw, std::span<const Corner> polygon)
{
    glm::dvec3 normal(0.0); // Newell's
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a(raw.positions[polygon[i].position]), b(raw.positions[polygon[(i + 1) % polygon.size()].position]);
        normal += glm::dvec3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
    }
    const double length = glm::length(normal);
    if (!(length > 0.0) || !std::isfinite(length))
        return {};
    normal /= length;
    const glm::dvec3 axis = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 right = glm::normalize(glm::cross(axis, normal)), up = glm::cross(normal, right);
    Plane plane;
    for (const Corner& corner : polygon) {
        const glm::dvec3 p(raw.positions[corner.position]);
        plane.emplace_back(glm::dot(p, right), glm::dot(p, up));
    }
    return plane;
}

double leastTurn(const Plane& plane)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < plane.size(); ++i)
        least = std::min(least, turn(plane[i], plane[(i + 1) % plane.size()], plane[(i + 2) % plane.size()]));
    return least;
}

// Whether corner `at` of the rest can be cut off: it turns left and no other corner lies inside.
bool isEar(const Plane& plane, const std::vector<std::size_t>& rest, std::size_t at)
{
    const std::size_t before = rest[(at + rest.size() - 1) % rest.size()], tip = rest[at], after = rest[(at + 1) % rest.size()];
    const glm::dvec2 a = plane[before], b = plane[tip], c = plane[after];
    if (turn(a, b, c) <= 0.0)
        return false;
    for (const std::size_t other : rest) {
        const glm::dvec2 p = plane[other];
        if (p == a || p == b || p == c) // a hole's bridge visits its ends twice
            continue;
        if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0)
            return false;
    }
    return true;
}
} // namespace

void addPolygon(RawMesh& raw, std::span<const Corner> polygon)
{
    if (polygon.size() < 3) {
        ++raw.shortFaces;
        return;
    }
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        raw.corners.insert(raw.corners.end(), {polygon[a], polygon[b], polygon[c]});
    };
    constexpr std::size_t kMostCorners = 1000; // cutting ears costs the cube of it
    const Plane plane = polygon.size() > 3 ? flattened(raw, polygon) : Plane{};
    const double least = leastTurn(plane);
    // A fan from a corner that lies on a straight side would hold a triangle without area.
    if (least > 0.0 || polygon.size() > kMostCorners) {
        raw.fannedPolygons += least < 0.0;
        for (std::size_t i = 2; i < polygon.size(); ++i)
            add(0, i - 1, i);
        return;
    }
    std::vector<std::size_t> rest(polygon.size());
    for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] = i;
    while (rest.size() > 3) {
        std::size_t at = 0;
        while (at < rest.size() && !isEar(plane, rest, at))
            ++at;
        at %= rest.size(); // none: the outline crosses itself, any corner does
        add(rest[(at + rest.size() - 1) % rest.size()], rest[at], rest[(at + 1) % rest.size()]);
        rest.erase(rest.begin() + std::ptrdiff_t(at));
    }
    add(rest[0], rest[1], rest[2]);
}

} // namespace relievo
