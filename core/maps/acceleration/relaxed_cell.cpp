// Exit points on the edges of a cell and on the hyperbola across it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/acceleration/relaxed_cell.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo {

namespace {
constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kArcKeep = 0.999;
constexpr int kArcHalvings = 12;

double ratioOf(double squaredDistance, double rise)
{
    return rise > 0. ? std::sqrt(squaredDistance) / rise : kNone;
}

// Smallest of sqrt(A^2 + (s B)^2) / (n + g s) over s in [from, to]: the derivative vanishes at s = g A^2 / (n B^2).
double edgeRatio(double squaredA, double squaredB, double n, double g, double from, double to)
{
    const auto at = [&](double s) { return ratioOf(squaredA + squaredB * s * s, n + g * s); };
    double best = std::min(at(from), at(to));
    if (n > 0. && g > 0.)
        best = std::min(best, at(std::clamp(g * squaredA / (n * squaredB), from, to)));
    return best;
}

// The hyperbola X Y = k, where the surface rises n + b X + c Y above the apex.
struct Arc {
    double k, n, b, c, squaredDu, squaredDv;

    double squaredDistance(double x) const { return squaredDu * x * x + squaredDv * (k / x) * (k / x); }
    double rise(double x) const { return n + b * x + c * k / x; }
    double ratio(double x) const { return ratioOf(squaredDistance(x), rise(x)); }

    // No point with X in [from, to] has a smaller ratio: nearest point over highest point.
    double bound(double from, double to) const
    {
        const double nearest = std::clamp(std::sqrt(k * std::sqrt(squaredDv / squaredDu)), from, to);
        double highest = std::max(rise(from), rise(to));
        if (b < 0. && c < 0.)
            highest = std::max(highest, rise(std::clamp(std::sqrt(k * c / b), from, to)));
        return ratioOf(squaredDistance(nearest), highest);
    }
    double smallest(double from, double to, double best, int halvings) const
    {
        const double low = bound(from, to);
        if (low >= kArcKeep * best || halvings == 0)
            return low;
        const double middle = std::sqrt(from * to);
        best = std::min(best, ratio(middle));
        return std::min(smallest(from, middle, best, halvings - 1), smallest(middle, to, best, halvings - 1));
    }
};
} // namespace

double relaxedRatio(const RelaxedCell& cell, double apex)
{
    const double h00 = double(cell.corners.h00), h10 = double(cell.corners.h10), h01 = double(cell.corners.h01);
    const double d = h00 - h10 - h01 + double(cell.corners.h11);
    const double x0 = cell.x, y0 = cell.y, x1 = x0 + 1., y1 = y0 + 1.;
    const double b = h10 - h00 - d * y0, c = h01 - h00 - d * x0, a = h00 - b * x0 - c * y0 - d * x0 * y0;
    if (a - d * (d < 0. ? x1 * y1 : x0 * y0) <= 1.)
        return kNone;

    // Exit points have X Y < most or X Y > least.
    const double most = d > 0. ? (a - 1.) / d : kNone;
    double least = d < 0. ? (1. - a) / -d : 0.;
    if (least < 1e-9)
        least = 0.;
    const double squaredDu = cell.du * cell.du, squaredDv = cell.dv * cell.dv;
    double best = kNone;
    const double leastY = x0 > 0. ? least / x0 : least > 0. ? kNone : 0., mostY = x0 > 0. ? most / x0 : kNone;
    if (std::max(y0, leastY) <= std::min(y1, mostY))
        best = std::min(
            best, edgeRatio(squaredDu * x0 * x0, squaredDv, a + b * x0 - apex, c + d * x0, std::max(y0, leastY), std::min(y1, mostY)));
    const double leastX = y0 > 0. ? least / y0 : least > 0. ? kNone : 0., mostX = y0 > 0. ? most / y0 : kNone;
    if (std::max(x0, leastX) <= std::min(x1, mostX))
        best = std::min(
            best, edgeRatio(squaredDv * y0 * y0, squaredDu, a + c * y0 - apex, b + d * y0, std::max(x0, leastX), std::min(x1, mostX)));
    if (least > x0 * y0) {
        const Arc arc{least, a + d * least - apex, b, c, squaredDu, squaredDv};
        const double from = std::max(x0, least / y1), to = std::min(x1, leastX);
        if (from <= to)
            best = std::min(best, arc.smallest(from, to, std::min({best, arc.ratio(from), arc.ratio(to)}), kArcHalvings));
    }
    return best;
}

} // namespace relievo
