// A relief object: a box whose solid is where all of its axes agree, each axis a map of intervals along it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace relievo {

// A stretch of solid along one axis, in 65535ths of the box's length along it. Nothing is solid where back lies before front.
struct Interval {
    std::uint16_t front = kDeepest, back = 0;
    static constexpr std::uint16_t kDeepest = 65535;
    bool isSolid() const { return front <= back; }
    bool operator==(const Interval&) const = default;
};

// The intervals along one axis: row-major texels, row 0 at v = 0, the layers of a texel side by side in the order of their depth. Texel
// centres lie at (i + 0.5) / size; beyond the outermost ones everything goes on as it is there.
// Where all four corners of a cell between texel centres hold layer k, its front and back are bilinear; in all other cells each quarter is
// as its texel says, and walls stand where neighbours differ.
struct AxisMap {
    int width = 0, height = 0; // texels; 0: the object is not bounded along this axis
    int layers = 1; // 1 to kMostLayers
    std::vector<Interval> intervals; // width * height * layers

    bool isGiven() const { return width > 0; }
    const Interval& at(int x, int y, int layer) const
    {
        return intervals[(std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(layers) + std::size_t(layer)];
    }
    bool operator==(const AxisMap&) const = default;
};
inline constexpr int kMostLayers = 4;

// How the maps of an axis lie in the box: u to the right, v down and the depth inwards for who looks at its front, which faces along +x, +y
// or +z. Unit vectors in the directions of the half axes; u x v = depth.
struct AxisFrame {
    glm::dvec3 u, v, depth;
};
inline constexpr std::array<AxisFrame, 3> kAxisFrames{{
    {{0., 0., -1.}, {0., -1., 0.}, {-1., 0., 0.}},
    {{1., 0., 0.}, {0., 0., 1.}, {0., -1., 0.}},
    {{1., 0., 0.}, {0., -1., 0.}, {0., 0., -1.}},
}};

// A plain value. The half axes are at right angles to each other and of any length above 0; world space, m.
struct ReliefObject {
    glm::dvec3 center{0.};
    std::array<glm::dvec3, 3> half{{{0.5, 0., 0.}, {0., 0.5, 0.}, {0., 0., 0.5}}};
    std::array<AxisMap, 3> axes; // of x, y, z
    bool operator==(const ReliefObject&) const = default;

    // A point of the world from -1 to 1 along each half axis; a direction by the same measure.
    glm::dvec3 inBox(glm::dvec3 point) const { return directionInBox(point - center); }
    glm::dvec3 directionInBox(glm::dvec3 d) const
    {
        const auto along = [&](int i) { return glm::dot(d, half[std::size_t(i)]) / glm::dot(half[std::size_t(i)], half[std::size_t(i)]); };
        return {along(0), along(1), along(2)};
    }
};

// Whether the point lies in the box and in the intervals of every axis that is given; the surface belongs to the object.
bool isInside(const ReliefObject& object, glm::dvec3 point);

// What is wrong with it, or an error where it cannot be searched: sizes that do not fit the intervals, layers out of range, a box without
// extent, no axis at all. "back-before-front": how many intervals end before they begin, and so are empty (but for those that mean nothing
// is there: from the back to the front of the box). "layers-cross": a texel's layers are not in order.
Expected<Warnings> checkObject(const ReliefObject& object);

} // namespace relievo
