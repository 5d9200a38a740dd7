// Relief objects of spheres and boxes, whose intervals are known in closed form.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/object_search.h"
#include "core/object/object_shader.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <utility>

namespace relievo::test {

// In the measure of the box, from -1 to 1.
struct Solid {
    glm::dvec3 center{0.}, half{0.5}; // of a sphere half.x is the radius
    bool isSphere = true;

    bool holds(glm::dvec3 p) const
    {
        const glm::dvec3 d = glm::abs(p - center);
        return isSphere ? glm::length(d) <= half.x : d.x <= half.x && d.y <= half.y && d.z <= half.z;
    }
    // s of start + s * unit direction along an axis.
    std::optional<std::pair<double, double>> along(glm::dvec3 start, glm::dvec3 direction) const
    {
        const glm::dvec3 to = center - start;
        const double middle = glm::dot(to, direction);
        const glm::dvec3 aside = glm::abs(to - middle * direction);
        if (isSphere) {
            const double rest = half.x * half.x - glm::dot(aside, aside);
            return rest >= 0. ? std::optional(std::pair(middle - std::sqrt(rest), middle + std::sqrt(rest))) : std::nullopt;
        }
        const double reach = glm::dot(half, glm::abs(direction));
        return aside.x <= half.x && aside.y <= half.y && aside.z <= half.z ? std::optional(std::pair(middle - reach, middle + reach))
                                                                           : std::nullopt;
    }
};

// The union along one axis, sampled at the texel centres; what does not fit into the layers is left out.
inline AxisMap mapOf(const std::vector<Solid>& solids, std::size_t axis, int width, int height, int layers)
{
    AxisMap map{width, height, layers, std::vector<Interval>(std::size_t(width) * std::size_t(height) * std::size_t(layers))};
    const AxisFrame& frame = kAxisFrames[axis];
    const auto code = [](double depth) { return std::uint16_t(std::lround(std::clamp(depth, 0., 1.) * Interval::kDeepest)); };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 start = ((2 * x + 1.) / width - 1.) * frame.u + ((2 * y + 1.) / height - 1.) * frame.v - frame.depth;
            std::vector<std::pair<double, double>> found;
            for (const Solid& solid : solids)
                if (const auto stretch = solid.along(start, frame.depth))
                    found.push_back(*stretch);
            std::ranges::sort(found);
            auto* out = map.intervals.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(layers);
            double end = -1.;
            int layer = -1;
            for (const auto& [from, to] : found) {
                if (from > end && ++layer < layers)
                    out[layer].front = code(0.5 * from);
                end = std::max(end, to);
                if (layer < layers)
                    out[layer].back = code(0.5 * end);
            }
        }
    return map;
}

inline ReliefObject objectOf(const std::vector<Solid>& solids, int size, int layers)
{
    ReliefObject object;
    for (std::size_t axis = 0; axis < 3; ++axis)
        object.axes[axis] = mapOf(solids, axis, size, size, layers);
    return object;
}

// A box of 2 x 1 x 3 m, turned, away from the origin.
inline void place(ReliefObject& object)
{
    const glm::dvec3 x = glm::normalize(glm::dvec3(1., 2., 0.5)), y = glm::normalize(glm::cross(x, glm::dvec3(0., 0., 1.)));
    object.center = {4., -2., 1.};
    object.half = {1. * x, 0.5 * y, 1.5 * glm::cross(x, y)};
}

// Evenly over the sphere.
inline glm::dvec3 evenDirection(std::mt19937& random)
{
    std::normal_distribution<double> value;
    return glm::normalize(glm::dvec3(value(random), value(random), value(random)));
}

// m, of the box.
inline double leastSize(const ReliefObject& object)
{
    return 2. * std::min({glm::length(object.half[0]), glm::length(object.half[1]), glm::length(object.half[2])});
}

// Whether the answer is that of a ray which lies a ten thousandth of the box beside: at outlines and edges either is right.
inline bool isTie(const ReliefObject& object, const ObjectRayHit& found, glm::dvec3 origin, glm::dvec3 direction)
{
    const double size = leastSize(object);
    const glm::dvec3 u
        = glm::normalize(glm::cross(direction, std::abs(direction.y) < 0.9 ? glm::dvec3(0., 1., 0.) : glm::dvec3(1., 0., 0.)));
    const glm::dvec3 v = glm::cross(direction, u);
    for (int i = 0; i < 16; ++i) {
        const double angle = i * std::numbers::pi / 8., by = (i % 2 == 0 ? 1e-4 : 3e-5) * size;
        const auto beside = firstHit(object, origin + by * (std::cos(angle) * u + std::sin(angle) * v), direction);
        if (bool(beside) == found.found && (!beside || std::abs(beside->t - found.t) < 1e-3 * size))
            return true;
    }
    return false;
}

} // namespace relievo::test
