// The pieces that the definition of a relief object is made of: quarters of cells, and the bilinear depths on each.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/relief_object.h"
#include <algorithm>
#include <optional>

namespace relievo {

// A depth on a quarter: c + x kx + y ky + x y kxy, with x, y in texels from the cell's first corner; in 0..1 along the axis.
struct Bilinear {
    double c = 0., x = 0., y = 0., xy = 0.;
    double at(double px, double py) const { return c + x * px + y * py + xy * px * py; }
};
struct Layer {
    Bilinear front, back;
    bool isThin = false; // front and back are the same everywhere
};

// A quarter of a cell, by its number in halves of texels: column i reaches from i / (2 width) to (i + 1) / (2 width).
struct Quarter {
    int column = 0, row = 0;
    // The cell's first corner, in texels; -1 in the outermost quarters.
    int cellX() const { return (column + 1) / 2 - 1; }
    int cellY() const { return (row + 1) / 2 - 1; }
};

// Layer k there; nothing where it is empty.
inline std::optional<Layer> layerOn(const AxisMap& map, Quarter quarter, int k)
{
    const auto corner = [&](int dx, int dy) -> const Interval& {
        return map.at(std::clamp(quarter.cellX() + dx, 0, map.width - 1), std::clamp(quarter.cellY() + dy, 0, map.height - 1), k);
    };
    const Interval &a = corner(0, 0), &b = corner(1, 0), &c = corner(0, 1), &d = corner(1, 1);
    constexpr double unit = 1. / Interval::kDeepest;
    if (a.isSolid() && b.isSolid() && c.isSolid() && d.isSolid()) {
        const auto between = [](double k00, double k10, double k01, double k11) {
            return Bilinear{k00 * unit, (k10 - k00) * unit, (k01 - k00) * unit, (k11 - k10 - k01 + k00) * unit};
        };
        const auto isThin = [](const Interval& i) { return i.front == i.back; };
        return Layer{between(a.front, b.front, c.front, d.front), between(a.back, b.back, c.back, d.back),
            isThin(a) && isThin(b) && isThin(c) && isThin(d)};
    }
    const Interval& nearest = map.at(quarter.column / 2, quarter.row / 2, k);
    if (!nearest.isSolid())
        return {};
    return Layer{{nearest.front * unit}, {nearest.back * unit}, nearest.front == nearest.back};
}

} // namespace relievo
