// A tree by halves along the longest side, and solid angles.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/bake/winding.h"
#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

namespace relievo {

namespace {
constexpr std::uint32_t kLeaf = 8; // triangles
constexpr double kFar = 2.; // radii

glm::dvec3 middleOf(const Winding::Triangle& t)
{
    return (t[0] + t[1] + t[2]) / 3.;
}

double solidAngle(const Winding::Triangle& t, glm::dvec3 point)
{
    const glm::dvec3 a = t[0] - point, b = t[1] - point, c = t[2] - point;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    return 2. * std::atan2(glm::dot(a, glm::cross(b, c)), below);
}
} // namespace

Winding::Winding(std::vector<Triangle> triangles) : m_triangles(std::move(triangles))
{
    m_nodes.reserve(m_triangles.size() / 2 + 1);
    if (!m_triangles.empty())
        build(0, std::uint32_t(m_triangles.size()));
}

std::uint32_t Winding::build(std::uint32_t first, std::uint32_t count)
{
    const auto number = std::uint32_t(m_nodes.size());
    Node node{first, count, 0, {}, {}, 0.};
    glm::dvec3 low = m_triangles[first][0], high = low;
    double weights = 0.;
    for (std::uint32_t i = first; i < first + count; ++i) {
        const Triangle& t = m_triangles[i];
        for (const glm::dvec3& corner : t) {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
        const glm::dvec3 area = 0.5 * glm::cross(t[1] - t[0], t[2] - t[0]);
        const double weight = glm::length(area);
        node.area += area;
        node.center += weight * middleOf(t);
        weights += weight;
    }
    node.center = weights > 0. ? node.center / weights : 0.5 * (low + high);
    node.radius = glm::length(glm::max(high - node.center, node.center - low));
    m_nodes.push_back(node);
    if (count > kLeaf) {
        const glm::dvec3 size = high - low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t half = count / 2;
        const auto begin = m_triangles.begin() + std::ptrdiff_t(first);
        std::nth_element(begin, begin + half, begin + count,
            [axis](const Triangle& a, const Triangle& b) { return middleOf(a)[axis] < middleOf(b)[axis]; });
        build(first, half);
        m_nodes[number].right = build(first + half, count - half);
    }
    return number;
}

double Winding::below(std::uint32_t number, glm::dvec3 point) const
{
    const Node& node = m_nodes[number];
    const glm::dvec3 to = node.center - point;
    const double square = glm::dot(to, to);
    if (square > kFar * kFar * node.radius * node.radius)
        return glm::dot(node.area, to) / (square * std::sqrt(square));
    if (node.right != 0)
        return below(number + 1, point) + below(node.right, point);
    double sum = 0.;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        sum += solidAngle(m_triangles[i], point);
    return sum;
}

double Winding::at(glm::dvec3 point) const
{
    return isEmpty() ? 0. : below(0, point) / (4. * std::numbers::pi);
}

} // namespace relievo
