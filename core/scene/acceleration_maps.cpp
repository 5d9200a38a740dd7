// Making acceleration maps and looking them up.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/acceleration_maps.h"
#include "core/image/material.h"
#include "core/state/lights.h"
#include <algorithm>

namespace relievo {

std::vector<MapWish> mapWishes(const TechniqueRow& technique, const Parameters& parameters)
{
    std::vector<MapWish> wishes;
    if (!technique.accelerationMap.empty())
        wishes.push_back({technique.accelerationMap, parameters.wrap, parameters.heightMips});
    if (readsHorizons(technique, parameters))
        wishes.push_back({parameters.horizonAzimuths == HorizonAzimuths::Eight ? "horizon-slopes" : "horizon-slopes-16", parameters.wrap});
    return wishes;
}

namespace {
// Calls visit(wish, parameters) for each map that a pane wants.
template <class Visit> void eachWish(const State& state, const Visit& visit)
{
    for (std::size_t pane = 0; pane < state.panes.size(); ++pane)
        if (const TechniqueRow* technique = findTechnique(state.panes[pane].technique))
            for (const Parameters parameters = effectiveParameters(state, pane); const MapWish& wish : mapWishes(*technique, parameters))
                visit(wish, parameters);
}

tl::unexpected<Error> notMade(std::string_view label, const char* what)
{
    return failure(ErrorCode::NotReady, std::string(label), what, "Wait until it is, or choose the technique again");
}
} // namespace

AccelerationMaps::Map AccelerationMaps::find(const MapWish& wish, const Material& material) const
{
    const auto found = m_made.find(keyOf(wish));
    const bool fits = found != m_made.end() && material.height && found->second.heights == material.height->identity()
        && (!wish.allLevels || found->second.allLevels);
    return fits ? found->second.map : nullptr;
}

Expected<AccelerationMaps::Map> AccelerationMaps::of(
    const TechniqueRow& technique, const Parameters& parameters, const Material& material) const
{
    if (technique.accelerationMap.empty())
        return nullptr;
    if (!material.height)
        return failure(std::string(technique.label), "this technique needs a height map and the material has none",
            "Assign one, or choose Flat or Bump");
    if (Map map = find(mapWishes(technique, parameters).front(), material))
        return map;
    return notMade(technique.label, "the map that it searches with is not made yet");
}

Expected<AccelerationMaps::Map> AccelerationMaps::horizonsOf(
    const TechniqueRow& technique, const Parameters& parameters, const Material& material) const
{
    if (!material.height || !readsHorizons(technique, parameters))
        return nullptr;
    if (Map map = find(mapWishes(technique, parameters).back(), material))
        return map;
    return notMade(technique.label, "the map of horizons that its light reads is not made yet");
}

Expected<void> AccelerationMaps::make(const MapWish& wish, const Parameters& parameters, const Material& material, const Progress& progress)
{
    const HeightField field = material.height->withWrap(wish.wrap);
    auto map = makeAccelerationMap(wish.row, field, parameters, wish.allLevels, progress);
    if (!map)
        return tl::unexpected(map.error());
    m_made[keyOf(wish)] = {std::move(*map), field.identity(), wish.allLevels};
    return {};
}

Expected<void> AccelerationMaps::make(
    const TechniqueRow& technique, const Parameters& parameters, const Material& material, const Progress& progress)
{
    const std::vector<MapWish> wishes = mapWishes(technique, parameters);
    const float all = float(wishes.size());
    for (std::size_t i = 0; i < wishes.size() && material.height; ++i)
        if (!find(wishes[i], material))
            if (auto made = make(wishes[i], parameters, material, progress.part(float(i) / all, float(i + 1) / all)); !made)
                return made;
    return {};
}

Expected<void> AccelerationMaps::makeFor(const State& state, const Material& material, const Progress& progress)
{
    const float all = float(std::max(missingFor(state, material).size(), std::size_t(1)));
    float done = 0.f;
    Expected<void> result;
    eachWish(state, [&](const MapWish& wish, const Parameters& parameters) {
        if (!result || !material.height || find(wish, material))
            return;
        result = make(wish, parameters, material, progress.part(done / all, (done + 1.f) / all));
        done += 1.f;
    });
    return result;
}

std::vector<std::string_view> AccelerationMaps::missingFor(const State& state, const Material& material) const
{
    std::set<Key> missing;
    eachWish(state, [&](const MapWish& wish, const Parameters&) {
        if (material.height && !find(wish, material))
            missing.insert(keyOf(wish));
    });
    std::vector<std::string_view> rows;
    for (const auto& [row, wrap] : missing)
        rows.push_back(row);
    return rows;
}

void AccelerationMaps::keepOnlyOf(const State& state, const Material& material)
{
    std::set<Key> wanted;
    eachWish(state, [&](const MapWish& wish, const Parameters&) {
        if (find(wish, material))
            wanted.insert(keyOf(wish));
    });
    std::erase_if(m_made, [&](const auto& made) { return !wanted.contains(made.first); });
}

bool AccelerationMaps::holds(const AccelerationMap* map) const
{
    return std::ranges::any_of(m_made, [&](const auto& made) { return made.second.map.get() == map; });
}

} // namespace relievo
