// Reading and writing parameters for one pane or all.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/editing.h"
#include "core/state/techniques.h"
#include <algorithm>

namespace relievo {
namespace {
bool inScope(std::size_t pane, Scope scope)
{
    return !scope || pane == *scope;
}

bool holdsIn(const State& state, std::size_t index, const ParameterRow& row);

// A condition on a parameter that is not shown itself does not hold.
bool holds(const State& state, std::size_t index, const Condition& condition)
{
    const ParameterRow& other = kParameters[indexOf(condition.member)];
    if (!holdsIn(state, index, other))
        return false;
    const Value value = get(effectiveParameters(state, index), other);
    const bool* on = std::get_if<bool>(&value);
    return on ? *on == (condition.value != 0) : std::get<int>(value) == condition.value;
}

// Whether the row is shown for pane `index`.
bool holdsIn(const State& state, std::size_t index, const ParameterRow& row)
{
    const TechniqueRow* technique = findTechnique(state.panes[index].technique);
    const bool byTechnique = !row.shown.byTechnique || (technique && technique->parameters.contains(row));
    return byTechnique && !row.shown.inAnimationBar && (!row.shown.when || holds(state, index, *row.shown.when));
}
} // namespace

Value shownValue(const State& state, const ParameterRow& row, Scope scope)
{
    if (!scope)
        return get(state.parameters, row);
    return get(effectiveParameters(state, std::min(*scope, state.panes.size() - 1)), row);
}

bool isOverridden(const State& state, const ParameterRow& row, Scope scope)
{
    for (std::size_t i = 0; i < state.panes.size(); ++i)
        if (inScope(i, scope) && state.panes[i].overrides.contains(std::string(row.key)))
            return true;
    return false;
}

void assign(State& state, const ParameterRow& row, const Value& value, Scope scope)
{
    if (!scope || row.sharedByPanes) {
        clearOverride(state, row, kAllPanes);
        return set(state.parameters, row, value);
    }
    for (std::size_t i = 0; i < state.panes.size(); ++i)
        if (inScope(i, scope))
            state.panes[i].overrides.insert_or_assign(std::string(row.key), value);
}

void clearOverride(State& state, const ParameterRow& row, Scope scope)
{
    for (std::size_t i = 0; i < state.panes.size(); ++i)
        if (inScope(i, scope))
            state.panes[i].overrides.erase(std::string(row.key));
}

void reset(State& state, const ParameterRow& row, Scope scope)
{
    if (!scope || row.sharedByPanes)
        assign(state, row, get(Parameters{}, row), kAllPanes);
    else
        clearOverride(state, row, scope);
}

bool isShown(const State& state, const ParameterRow& row)
{
    for (std::size_t i = 0; i < state.panes.size(); ++i)
        if (holdsIn(state, i, row))
            return true;
    return false;
}

void setPaneCount(State& state, std::size_t count)
{
    state.panes.resize(std::clamp(count, std::size_t(1), std::min(kMaxPanes, state.panes.size())));
    while (state.panes.size() < std::min(count, kMaxPanes)) {
        Pane next = state.panes.back();
        next.technique = next.technique == "parallax" ? "relief" : "parallax"; // the pair that is compared most
        state.panes.push_back(next);
    }
}

void FurtherPanes::show(State& state, bool on)
{
    if (state.panes.size() > 1)
        m_last.assign(state.panes.begin() + 1, state.panes.end());
    setPaneCount(state, on ? std::max(state.panes.size(), std::size_t(2)) : 1);
    if (on && !m_last.empty()) {
        state.panes.resize(1);
        state.panes.insert(state.panes.end(), m_last.begin(), m_last.end());
    }
}

} // namespace relievo
