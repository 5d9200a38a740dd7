// Techniques x settings x fields x angle bands, measured on the CPU against the exact reference.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/metrics.h"
#include "core/analysis/ray_sets.h"
#include "core/analysis/settings.h"
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include <string>
#include <vector>

namespace relievo {

struct SweepField {
    std::string key, label;
    HeightField heights; // its wrap counts
    double depth; // share of the tile
};

struct SweepPlan {
    std::vector<SearchSetting> settings; // their depth is replaced by the field's
    std::vector<SweepField> fields;
    std::vector<AngleBand> bands{kAngleBands.begin(), kAngleBands.end()};
    int rays = 5000; // a field and band; the same ones for every setting
    std::uint32_t seed = 1;
    bool freshMaps = false; // bake the maps here, so that the seconds are those of the bake and not of reading a cache
};

struct SweepRow {
    std::size_t setting, field, band; // indices into the plan
    HitErrors errors;
    double bakeSeconds; // of the technique's acceleration map by the clock; 0 when it has none
    double bytesPerTexel; // height and acceleration map as they are uploaded, without mip levels of the height
};

// Rows in the order field, setting, band. Errors: those of searchMaps, cancelled.
Expected<std::vector<SweepRow>> sweep(const SweepPlan& plan, const Progress& progress = {});

// One row a setting and band over all fields of the plan: field is `kAllFields`, bakeSeconds the sum, bytesPerTexel the mean.
inline constexpr std::size_t kAllFields = std::size_t(-1);
std::vector<SweepRow> totals(const SweepPlan& plan, std::span<const SweepRow> rows);

// The rows of one setting (and band, unless it is `kAllBands`) as one.
inline constexpr std::size_t kAllBands = std::size_t(-1);
HitErrors overFields(std::span<const SweepRow> rows, std::size_t setting, std::size_t band = kAllBands);

} // namespace relievo
