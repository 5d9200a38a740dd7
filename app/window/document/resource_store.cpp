// Comparing what is loaded with what a State names.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/resource_store.h"
#include "app/window/widgets/text.h"
#include "core/maps/maps.h"
#include "core/state/techniques.h"
#include <QFileInfo>

namespace relievo {

Needs needsOf(const State& state)
{
    Needs needs{state.slots, state.mesh, state.environment, {}};
    for (std::size_t pane = 0; pane < state.panes.size(); ++pane)
        if (const TechniqueRow* technique = findTechnique(state.panes[pane].technique)) {
            const std::vector<MapWish> wishes = mapWishes(*technique, effectiveParameters(state, pane));
            needs.accelerationMaps.insert(needs.accelerationMaps.end(), wishes.begin(), wishes.end());
        }
    return needs;
}

bool ResourceStore::isLoaded(const State& state) const
{
    return ready() && resources().material->slots == state.slots && resources().meshName == state.mesh
        && resources().environmentName == state.environment && m_shown.stale.empty();
}

bool ResourceStore::isComplete(const State& state) const
{
    return isLoaded(state) && resources().accelerationMaps.missingFor(state, *resources().material).empty();
}

bool ResourceStore::locatesMesh(const State& state, const QString& file) const
{
    return m_shown.mesh && QFileInfo(file).fileName() == QFileInfo(QString::fromStdString(state.mesh)).fileName();
}

QString ResourceStore::missingMap(const State& state) const
{
    if (!isLoaded(state))
        return {};
    const auto missing = resources().accelerationMaps.missingFor(state, *resources().material);
    return missing.empty() ? QString() : qt(findBakedMap(missing.front())->label).toLower();
}

} // namespace relievo
