// Where rays on a grid, all along one axis of a box, cross a triangle: exactly once where triangles share an edge or a corner.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace relievo {

// Rays in columns and rows, through the centres (i + 0.5) / size of [0, 1]; rows from rowFrom on until before rowTo are asked.
struct RayGrid {
    int width = 0, height = 0, rowFrom = 0, rowTo = 0;
};

// A crossing: the ray's number, and what of each corner (they add up to 1).
struct RayCrossing {
    int x = 0, y = 0;
    glm::dvec3 weights{0.};
    bool enters = false; // u x v = depth, and the triangle is counter-clockwise from outside
};

// Calls found(RayCrossing) for each ray that meets the triangle of corners at u, v (within [0, 1], or a little outside). Corners are
// rounded to 1/4096 of the rays' distance and edges are decided in whole numbers, as if each ray lay aside by less than any number: so a
// closed surface is entered as often as it is left, whatever lies on its edges. A triangle that is seen from its edge is not met.
template <class Found> void forCrossings(const RayGrid& grid, const std::array<glm::dvec2, 3>& corners, Found found)
{
    constexpr std::int64_t unit = 4096;
    struct Point {
        std::int64_t x, y;
    };
    std::array<Point, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
        p[i] = {std::llround(corners[i].x * double(grid.width * unit)), std::llround(corners[i].y * double(grid.height * unit))};
    const auto side = [](Point a, Point b, std::int64_t x, std::int64_t y) { return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x); };
    const std::int64_t area = side(p[0], p[1], p[2].x, p[2].y);
    if (area == 0)
        return;
    const std::array<std::size_t, 3> order = area > 0 ? std::array<std::size_t, 3>{0, 1, 2} : std::array<std::size_t, 3>{0, 2, 1};
    const Point a = p[order[0]], b = p[order[1]], c = p[order[2]];
    const auto isWithin = [&](Point from, Point to, std::int64_t value) {
        return value > 0 || (value == 0 && (to.y < from.y || (to.y == from.y && to.x > from.x)));
    };
    const auto firstRay = [](std::int64_t low) { return int((std::max<std::int64_t>(low - unit / 2, 0) + unit - 1) / unit); };
    const auto lastRay = [](std::int64_t high, int end) { return int(std::min<std::int64_t>((high + unit / 2) / unit - 1, end - 1)); };
    const auto [lowX, highX] = std::minmax({a.x, b.x, c.x});
    const auto [lowY, highY] = std::minmax({a.y, b.y, c.y});
    const int fromX = firstRay(lowX), toX = lastRay(highX, grid.width);
    for (int y = std::max(firstRay(lowY), grid.rowFrom), toY = lastRay(highY, grid.rowTo); y <= toY; ++y) {
        bool wasIn = false;
        for (int x = fromX; x <= toX; ++x) {
            const std::int64_t rayX = x * unit + unit / 2, rayY = y * unit + unit / 2;
            const std::int64_t ab = side(a, b, rayX, rayY), bc = side(b, c, rayX, rayY), ca = side(c, a, rayX, rayY);
            if (!isWithin(a, b, ab) || !isWithin(b, c, bc) || !isWithin(c, a, ca)) {
                if (wasIn)
                    break;
                continue;
            }
            wasIn = true;
            const double whole = double(ab + bc + ca);
            RayCrossing crossing{x, y, {}, area < 0};
            crossing.weights[int(order[0])] = double(bc) / whole;
            crossing.weights[int(order[1])] = double(ca) / whole;
            crossing.weights[int(order[2])] = double(ab) / whole;
            found(crossing);
        }
    }
}

} // namespace relievo
