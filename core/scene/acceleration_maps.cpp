// Making acceleration maps and looking them up.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/acceleration_maps.h"
#include "core/image/material.h"
#include <algorithm>

namespace relievo {

namespace {
// Calls visit(technique, parameters) for each pane whose technique searches with an acceleration map.
template <class Visit> void eachWish(const State& state, const Visit& visit)
{
    for (std::size_t pane = 0; pane < state.panes.size(); ++pane)
        if (const TechniqueRow* technique = findTechnique(state.panes[pane].technique); technique && !technique->accelerationMap.empty())
            visit(*technique, effectiveParameters(state, pane));
}
} // namespace

AccelerationMaps::Key AccelerationMaps::keyOf(const TechniqueRow& technique, const Parameters& parameters)
{
    return {technique.accelerationMap, parameters.wrap};
}

Expected<AccelerationMaps::Map> AccelerationMaps::of(
    const TechniqueRow& technique, const Parameters& parameters, const Material& material) const
{
    if (technique.accelerationMap.empty())
        return nullptr;
    const std::string label(technique.label);
    if (!material.height)
        return failure(label, "this technique needs a height map and the material has none", "Assign one, or choose Flat or Bump");
    const auto found = m_made.find(keyOf(technique, parameters));
    if (found == m_made.end() || found->second.heights != material.height->identity()
        || (parameters.heightMips && !found->second.allLevels))
        return failure(
            ErrorCode::NotReady, label, "the map that it searches with is not made yet", "Wait until it is, or choose the technique again");
    return found->second.map;
}

Expected<void> AccelerationMaps::make(
    const TechniqueRow& technique, const Parameters& parameters, const Material& material, const Progress& progress)
{
    if (!material.height || of(technique, parameters, material))
        return {};
    const HeightField field = material.height->withWrap(parameters.wrap);
    auto map = makeAccelerationMap(technique.accelerationMap, field, parameters, parameters.heightMips, progress);
    if (!map)
        return tl::unexpected(map.error());
    m_made[keyOf(technique, parameters)] = {std::move(*map), field.identity(), parameters.heightMips};
    return {};
}

Expected<void> AccelerationMaps::makeFor(const State& state, const Material& material, const Progress& progress)
{
    const float all = float(std::max(missingFor(state, material).size(), std::size_t(1)));
    float done = 0.f;
    Expected<void> result;
    eachWish(state, [&](const TechniqueRow& technique, const Parameters& parameters) {
        if (!result || of(technique, parameters, material))
            return;
        result = make(technique, parameters, material, progress.part(done / all, (done + 1.f) / all));
        done += 1.f;
    });
    return result;
}

std::vector<std::string_view> AccelerationMaps::missingFor(const State& state, const Material& material) const
{
    std::set<Key> missing;
    eachWish(state, [&](const TechniqueRow& technique, const Parameters& parameters) {
        if (material.height && !of(technique, parameters, material))
            missing.insert(keyOf(technique, parameters));
    });
    std::vector<std::string_view> rows;
    for (const auto& [row, wrap] : missing)
        rows.push_back(row);
    return rows;
}

void AccelerationMaps::keepOnlyOf(const State& state, const Material& material)
{
    std::set<Key> wanted;
    eachWish(state, [&](const TechniqueRow& technique, const Parameters& parameters) {
        if (of(technique, parameters, material))
            wanted.insert(keyOf(technique, parameters));
    });
    std::erase_if(m_made, [&](const auto& made) { return !wanted.contains(made.first); });
}

bool AccelerationMaps::holds(const AccelerationMap* map) const
{
    return std::ranges::any_of(m_made, [&](const auto& made) { return made.second.map.get() == map; });
}

} // namespace relievo
