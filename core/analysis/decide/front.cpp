// The Pareto front of settings.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/decide/front.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace relievo {

std::vector<std::size_t> paretoFront(std::span<const CostAndError> points)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::isfinite(points[i].cost) && std::isfinite(points[i].error))
            order.push_back(i);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::tuple(points[i].cost, points[i].error); });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order)
        if (points[i].error < least) {
            least = points[i].error;
            front.push_back(i);
        }
    return front;
}

} // namespace relievo
