// Techniques x settings x fields x angle bands, measured on the CPU against the exact reference.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/metrics.h"
#include "core/analysis/ray_sets.h"
#include "core/analysis/settings.h"
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/trace/shader_on_cpu.h"
#include <map>
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

// What settings are asked: rays that begin where white lies, and of each how many pixels an error of the whole depth shifts what is seen by
// (or none). A band of angles is one, so is what is seen of a view.
struct RaySet {
    std::vector<SearchRay> rays;
    std::vector<double> pixels = {};
};

// Settings one by one on one field and the same sets of rays: exact answers and acceleration maps are made once. For one thread at a time.
class RaySweep {
public:
    // Errors: cancelled.
    static Expected<RaySweep> create(
        const HeightField& heights, std::vector<RaySet> sets, bool freshMaps = false, const Progress& progress = {});
    // A row for each set, as its band; `setting` and `field` as they are given. Errors: those of searchMaps, cancelled.
    Expected<std::vector<SweepRow>> measure(
        const SearchSetting& of, std::size_t setting, std::size_t field = 0, const Progress& progress = {});
    const std::vector<RaySet>& sets() const { return m_sets; }
    const std::vector<std::vector<SearchHit>>& exact() const { return m_exact; } // of each set

private:
    struct TimedMaps {
        SearchMaps maps;
        double seconds = 0., bytesPerTexel = 0.;
    };
    RaySweep(const HeightField& heights, std::vector<RaySet> sets, bool freshMaps);
    Expected<const TimedMaps*> mapsFor(const TechniqueRow& technique, const Parameters& parameters, const Progress& progress);
    HeightField m_heights;
    std::vector<RaySet> m_sets;
    std::vector<std::vector<SearchHit>> m_exact;
    bool m_freshMaps;
    std::map<std::string, TimedMaps> m_maps; // by what settings share them
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
