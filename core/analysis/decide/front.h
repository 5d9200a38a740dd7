// Cost against error: the figures that settings are weighed by, and which of them nothing beats.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/metrics.h"
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace relievo {

struct FigureRow {
    std::string_view key;
    std::string_view label, unit; // of an axis
    double (*of)(const HitErrors& errors);
    double none; // what is below counts as nothing: rounding, not the search
};
inline constexpr std::array<FigureRow, 2> kCostFigures = {{
    {"fetches", "Fetches", "fetches a ray", [](const HitErrors& e) { return e.meanFetches; }, 0.1},
    {"bytes", "Bytes", "bytes fetched a ray", [](const HitErrors& e) { return e.meanBytes; }, 0.1},
}};
inline constexpr std::array<FigureRow, 3> kErrorFigures = {{
    {"depth", "Depth", "RMSE of the depth, %", [](const HitErrors& e) { return 100. * e.rmse; }, 0.01},
    {"wrong", "Wrong", "rays that are wrong, %", [](const HitErrors& e) { return 100. * e.wrongShare(); }, 0.01},
    {"pixels", "Pixels", "RMSE of the shift, pixels", [](const HitErrors& e) { return e.rmsePixels; }, 0.002},
}};

struct CostAndError {
    double cost, error;
};
// Indices of those that no other one equals or beats in both, cheapest first; of equals the first. What is not finite is beaten.
std::vector<std::size_t> paretoFront(std::span<const CostAndError> points);

} // namespace relievo
