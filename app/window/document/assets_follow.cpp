// Keeping the data in step with the document: other files after an undo, another map for another technique.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/assets.h"
#include "core/maps/maps.h"
#include <algorithm>

namespace relievo {

Assets::Needs Assets::needsOf(const State& state)
{
    Needs needs{state.slots, state.mesh, state.environment, {}};
    for (std::size_t pane = 0; pane < state.panes.size(); ++pane)
        if (const TechniqueRow* technique = findTechnique(state.panes[pane].technique); technique && !technique->bound.empty()) {
            const Parameters parameters = effectiveParameters(state, pane);
            needs.bounds.emplace_back(technique->bound, wrapOf(parameters), parameters.heightMips);
        }
    return needs;
}

// Undo, redo and pasted States name other files than those that are loaded, another technique searches with another map.
void Assets::follow(Changes what)
{
    if (what & ~(Changes(Change::Camera) | Change::Moment))
        m_messages.clear("load"); // the work goes on without what was refused
    if (what & ~(Changes(Change::Camera) | Change::Moment | Change::View | Change::Name))
        check();
}

void Assets::check()
{
    if (!ready() || !m_jobs.empty()) // the last job's end looks again
        return;
    const State& now = m_document.state();
    if (fits(now)) {
        m_followed.reset(), m_following = false;
        m_messages.clear("follow");
        return m_background.cancel(); // it is pointless
    }
    if (m_followed == needsOf(now))
        return;
    m_followed = needsOf(now);
    m_following = true;
    const QString map = holds(now) ? boundMissing() : QString(); // alone
    if (map.isEmpty())
        m_messages.clear("follow");
    else
        m_messages.setNotice("follow", tr("The picture is drawn when the %1 has been made.").arg(map));
    m_background.start(
        [this, now, previous = m_shown](const Progress& progress) -> Background::Then {
            const auto shown = loadWhatIsThere(now, {}, previous, progress);
            return [this, shown] {
                m_following = false;
                if (!shown)
                    return m_messages.set("follow", shown.error());
                take(*shown);
                check();
            };
        },
        map.isEmpty() ? tr("Loading") : tr("Making the %1").arg(map));
}

QString Assets::boundMissing() const
{
    const auto missing = missingBounds(m_document.state(), resources());
    const auto map = missing.empty() ? kMaps.end() : std::ranges::find(kMaps, missing.begin()->first, &MapRow::key);
    return map == kMaps.end() ? QString() : QString::fromUtf8(map->label.data(), qsizetype(map->label.size())).toLower();
}

void Assets::tellStopped()
{
    m_followed = needsOf(m_document.state()); // until it is chosen again
    const QString map = holds(m_document.state()) ? boundMissing() : QString();
    const QString told = map.isEmpty() ? tr("Loading was stopped; choose again what is not shown.")
                                       : tr("Making the %1 was stopped; choose the technique again.").arg(map);
    m_messages.set("follow", QList<Message>{{false, told}});
}

bool Assets::holds(const State& state) const
{
    return ready() && resources().material->slots == state.slots && resources().meshName == state.mesh
        && resources().environmentName == state.environment && !isBack(m_shown);
}

bool Assets::fits(const State& state) const
{
    return holds(state) && missingBounds(state, resources()).empty();
}

} // namespace relievo
