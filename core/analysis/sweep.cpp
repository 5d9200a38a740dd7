// The loops of a sweep; each exact answer and each map is made once.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/sweep.h"
#include "core/maps/maps.h"
#include <chrono>

namespace relievo {

namespace {

Expected<SearchMaps> bakedAfresh(const BakedMapRow& row, const Parameters& parameters, const HeightField& heights, const Progress& progress)
{
    const auto baked = bakeMap(row, heights, parameters, progress);
    if (!baked)
        return tl::unexpected(baked.error());
    return SearchMaps{heights, accelerationMapOf(row, {std::make_shared<const BakedMap>(storedMap(row, *baked, row.bits))}, heights)};
}

// What makes two settings share their maps: the technique's acceleration map and the parameters that it depends on.
std::string mapsKey(const TechniqueRow& technique, const Parameters& parameters)
{
    std::string key = std::string(technique.accelerationMap) + (technique.needsHeights() ? "/heights" : "/");
    if (const BakedMapRow* row = technique.accelerationMap.empty() ? nullptr : findBakedMap(technique.accelerationMap))
        for (const ParameterRow& parameter : kParameters)
            if (row->parameters.contains(parameter))
                key += '/' + toText(parameter, get(parameters, parameter));
    return key;
}

} // namespace

RaySweep::RaySweep(const HeightField& heights, std::vector<RaySet> sets, bool freshMaps)
    : m_heights(heights)
    , m_sets(std::move(sets))
    , m_freshMaps(freshMaps)
{
}

Expected<RaySweep> RaySweep::create(const HeightField& heights, std::vector<RaySet> sets, bool freshMaps, const Progress& progress)
{
    RaySweep sweep(heights, std::move(sets), freshMaps);
    for (const RaySet& set : sweep.m_sets) {
        auto exact = traceRays("reference", {}, SearchMaps{heights, {}}, set.rays, {{}, progress.stop});
        if (!exact)
            return tl::unexpected(exact.error());
        sweep.m_exact.push_back(std::move(*exact));
    }
    return sweep;
}

Expected<const RaySweep::TimedMaps*> RaySweep::mapsFor(
    const TechniqueRow& technique, const Parameters& parameters, const Progress& progress)
{
    const std::string key = mapsKey(technique, parameters);
    if (const auto found = m_maps.find(key); found != m_maps.end())
        return &found->second;
    const BakedMapRow* row = technique.accelerationMap.empty() ? nullptr : findBakedMap(technique.accelerationMap);
    const auto start = std::chrono::steady_clock::now();
    auto maps = m_freshMaps && row ? bakedAfresh(*row, parameters, m_heights, progress)
                                   : searchMaps(technique.key, parameters, &m_heights, progress);
    if (!maps)
        return tl::unexpected(maps.error());
    TimedMaps timed{std::move(*maps)};
    if (row)
        timed.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (timed.maps.acceleration)
        timed.bytesPerTexel += double(timed.maps.acceleration->bytes()) / double(m_heights.texels().size());
    if (technique.needsHeights())
        timed.bytesPerTexel += m_heights.storedBits() <= 16 ? 2. : 4.;
    return &m_maps.emplace(key, std::move(timed)).first->second;
}

Expected<std::vector<SweepRow>> RaySweep::measure(const SearchSetting& of, std::size_t setting, std::size_t field, const Progress& progress)
{
    const Progress quiet{{}, progress.stop};
    const auto maps = mapsFor(*of.technique, of.parameters, quiet);
    if (!maps)
        return tl::unexpected(maps.error());
    std::vector<SweepRow> rows;
    for (std::size_t set = 0; set < m_sets.size(); ++set) {
        const auto& [rays, pixels] = m_sets[set];
        const auto hits = traceRays(of.technique->key, of.parameters, (*maps)->maps, atMesh(*of.technique, rays), quiet);
        if (!hits)
            return tl::unexpected(hits.error());
        rows.push_back(
            {setting, field, set, compareHits(m_heights, rays, *hits, m_exact[set], pixels), (*maps)->seconds, (*maps)->bytesPerTexel});
    }
    return rows;
}

Expected<std::vector<SweepRow>> sweep(const SweepPlan& plan, const Progress& progress)
{
    std::vector<SweepRow> rows;
    const double steps = double(plan.fields.size() * plan.settings.size());
    for (std::size_t field = 0; field < plan.fields.size(); ++field) {
        const auto& [key, label, heights, depth] = plan.fields[field];
        std::vector<RaySet> bands;
        for (const AngleBand band : plan.bands)
            bands.push_back({bandRays(band, depth, plan.rays, plan.seed)});
        auto sweep = RaySweep::create(heights, std::move(bands), plan.freshMaps, progress);
        if (!sweep)
            return tl::unexpected(sweep.error());
        for (std::size_t i = 0; i < plan.settings.size(); ++i) {
            SearchSetting setting = plan.settings[i];
            setting.parameters.depth = float(depth);
            const auto measured = sweep->measure(setting, i, field, progress);
            if (!measured)
                return tl::unexpected(measured.error());
            rows.insert(rows.end(), measured->begin(), measured->end());
            progress.at(float(double(field * plan.settings.size() + i + 1) / steps));
        }
    }
    return rows;
}

std::vector<SweepRow> totals(const SweepPlan& plan, std::span<const SweepRow> rows)
{
    std::vector<SweepRow> all;
    for (std::size_t setting = 0; setting < plan.settings.size(); ++setting)
        for (std::size_t band = 0; band < plan.bands.size(); ++band) {
            SweepRow total{setting, kAllFields, band, overFields(rows, setting, band), 0., 0.};
            for (const SweepRow& row : rows)
                if (row.setting == setting && row.band == band) {
                    total.bakeSeconds += row.bakeSeconds;
                    total.bytesPerTexel += row.bytesPerTexel / double(plan.fields.size());
                }
            all.push_back(total);
        }
    return all;
}

HitErrors overFields(std::span<const SweepRow> rows, std::size_t setting, std::size_t band)
{
    std::vector<HitErrors> sets;
    for (const SweepRow& row : rows)
        if (row.setting == setting && (band == kAllBands || row.band == band))
            sets.push_back(row.errors);
    return together(sets);
}

} // namespace relievo
