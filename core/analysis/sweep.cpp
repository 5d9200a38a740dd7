// The loops of a sweep; each exact answer and each map is made once.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/sweep.h"
#include "core/maps/maps.h"
#include "core/trace/shader_on_cpu.h"
#include <chrono>
#include <map>

namespace relievo {

namespace {

struct TimedMaps {
    SearchMaps maps;
    double seconds = 0., bytesPerTexel = 0.;
};

Expected<SearchMaps> bakedAfresh(const BakedMapRow& row, const Parameters& parameters, const HeightField& heights, const Progress& progress)
{
    const auto baked = bakeMap(row, heights, parameters, progress);
    if (!baked)
        return tl::unexpected(baked.error());
    return SearchMaps{heights, accelerationMapOf(row, {std::make_shared<const BakedMap>(storedMap(row, *baked, row.bits))}, heights)};
}

Expected<TimedMaps> timedMaps(
    const TechniqueRow& technique, const Parameters& parameters, const HeightField& heights, bool fresh, const Progress& progress)
{
    const BakedMapRow* row = technique.accelerationMap.empty() ? nullptr : findBakedMap(technique.accelerationMap);
    const auto start = std::chrono::steady_clock::now();
    auto maps = fresh && row ? bakedAfresh(*row, parameters, heights, progress) : searchMaps(technique.key, parameters, &heights, progress);
    if (!maps)
        return tl::unexpected(maps.error());
    TimedMaps timed{std::move(*maps)};
    if (row)
        timed.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (timed.maps.acceleration)
        timed.bytesPerTexel += double(timed.maps.acceleration->bytes()) / double(heights.texels().size());
    if (technique.needsHeights())
        timed.bytesPerTexel += heights.storedBits() <= 16 ? 2. : 4.;
    return timed;
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

struct Question {
    std::vector<SearchRay> rays;
    std::vector<SearchHit> exact;
};

class FieldSweep {
public:
    FieldSweep(const SweepPlan& plan, std::size_t field, const Progress& progress, std::vector<SweepRow>& rows)
        : m_plan(plan)
        , m_index(field)
        , m_field(plan.fields[field])
        , m_progress(progress)
        , m_rows(rows)
    {
    }

    Expected<void> run()
    {
        for (const AngleBand band : m_plan.bands) {
            auto rays = bandRays(band, m_field.depth, m_plan.rays, m_plan.seed);
            auto exact = traceRays("reference", {}, SearchMaps{m_field.heights, {}}, rays, quiet());
            if (!exact)
                return tl::unexpected(exact.error());
            m_questions.push_back({std::move(rays), std::move(*exact)});
        }
        for (std::size_t i = 0; i < m_plan.settings.size(); ++i) {
            if (const auto measured = measure(i); !measured)
                return measured;
            m_progress.at(float(m_index * m_plan.settings.size() + i + 1) / float(m_plan.fields.size() * m_plan.settings.size()));
        }
        return {};
    }

private:
    Progress quiet() const { return {{}, m_progress.stop}; }

    Expected<const TimedMaps*> mapsFor(const TechniqueRow& technique, const Parameters& parameters)
    {
        const std::string key = mapsKey(technique, parameters);
        if (const auto found = m_maps.find(key); found != m_maps.end())
            return &found->second;
        auto made = timedMaps(technique, parameters, m_field.heights, m_plan.freshMaps, quiet());
        if (!made)
            return tl::unexpected(made.error());
        return &m_maps.emplace(key, std::move(*made)).first->second;
    }

    Expected<void> measure(std::size_t setting)
    {
        const TechniqueRow& technique = *m_plan.settings[setting].technique;
        Parameters parameters = m_plan.settings[setting].parameters;
        parameters.depth = float(m_field.depth);
        const auto maps = mapsFor(technique, parameters);
        if (!maps)
            return tl::unexpected(maps.error());
        for (std::size_t band = 0; band < m_questions.size(); ++band) {
            const auto& [rays, exact] = m_questions[band];
            const auto hits = traceRays(technique.key, parameters, (*maps)->maps, atMesh(technique, rays), quiet());
            if (!hits)
                return tl::unexpected(hits.error());
            m_rows.push_back(
                {setting, m_index, band, compareHits(m_field.heights, rays, *hits, exact), (*maps)->seconds, (*maps)->bytesPerTexel});
        }
        return {};
    }

    const SweepPlan& m_plan;
    std::size_t m_index;
    const SweepField& m_field;
    const Progress& m_progress;
    std::vector<SweepRow>& m_rows;
    std::vector<Question> m_questions;
    std::map<std::string, TimedMaps> m_maps;
};

} // namespace

Expected<std::vector<SweepRow>> sweep(const SweepPlan& plan, const Progress& progress)
{
    std::vector<SweepRow> rows;
    for (std::size_t field = 0; field < plan.fields.size(); ++field)
        if (const auto done = FieldSweep(plan, field, progress, rows).run(); !done)
            return tl::unexpected(done.error());
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
