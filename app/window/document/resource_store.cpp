// Comparing what is loaded with what a State names.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/resource_store.h"
#include "app/window/widgets/text.h"
#include "core/maps/maps.h"
#include <QFileInfo>
#include <algorithm>

namespace relievo {

Needs needsOf(const State& state)
{
    Needs needs{state.slots, state.mesh, state.environment, {}};
    for (std::size_t pane = 0; pane < state.panes.size(); ++pane)
        if (const TechniqueRow* technique = findTechnique(state.panes[pane].technique); technique && !technique->bound.empty()) {
            const Parameters parameters = effectiveParameters(state, pane);
            needs.bounds.emplace_back(technique->bound, wrapOf(parameters), parameters.heightMips);
        }
    return needs;
}

bool ResourceStore::isLoaded(const State& state) const
{
    return ready() && resources().material->slots == state.slots && resources().meshName == state.mesh
        && resources().environmentName == state.environment && !isBack(m_shown);
}

bool ResourceStore::isComplete(const State& state) const
{
    return isLoaded(state) && missingBounds(state, resources()).empty();
}

bool ResourceStore::locatesMesh(const State& state, const QString& file) const
{
    return m_shown.mesh && QFileInfo(file).fileName() == QFileInfo(QString::fromStdString(state.mesh)).fileName();
}

QString ResourceStore::missingMap(const State& state) const
{
    if (!isLoaded(state))
        return {};
    const auto missing = missingBounds(state, resources());
    const auto map = missing.empty() ? kMaps.end() : std::ranges::find(kMaps, missing.begin()->first, &MapRow::key);
    return map == kMaps.end() ? QString() : qt(map->label).toLower();
}

} // namespace relievo
