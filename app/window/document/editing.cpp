// Reading and writing parameters for one pane or both.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/editing.h"
#include "core/state/techniques.h"
#include <algorithm>

namespace relievo {
namespace {
bool inScope(std::size_t pane, Scope scope)
{
    return scope == Scope::Both || pane == (scope == Scope::A ? 0u : 1u);
}

// Pictures side by side are compared by one range of their heat maps.
bool isShared(const ParameterRow& row)
{
    return row.key == "fetchRange" || row.key == "errorRange";
}

bool holdsIn(const State& state, std::size_t index, const ParameterRow& row);

// One word of ParameterRow::shown holds in pane `index`; a condition on a hidden parameter does not hold.
bool wordHoldsIn(const State& state, std::size_t index, const ParameterRow& row, std::string_view word)
{
    if (word == "animated") // the animation bar's
        return false;
    if (word == "technique") {
        const TechniqueRow* technique = findTechnique(state.panes[index].technique);
        return technique && listHas(technique->parameters, row.key);
    }
    const std::size_t at = word.find('=');
    const ParameterRow* other = findParameter(word.substr(0, at));
    if (!other || !holdsIn(state, index, *other))
        return false;
    const Value value = get(effectiveParameters(state, index), *other);
    const std::string_view wanted = word.substr(at + 1);
    if (std::holds_alternative<bool>(value))
        return std::get<bool>(value) == (wanted == "1");
    return std::holds_alternative<int>(value) && std::to_string(std::get<int>(value)) == wanted;
}

bool holdsIn(const State& state, std::size_t index, const ParameterRow& row)
{
    for (std::string_view rest = row.shown; !rest.empty();) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (!wordHoldsIn(state, index, row, rest.substr(0, end)))
            return false;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return true;
}
} // namespace

Value shownValue(const State& state, const ParameterRow& row, Scope scope)
{
    if (scope == Scope::Both)
        return get(state.parameters, row);
    return get(effectiveParameters(state, std::min<std::size_t>(scope == Scope::A ? 0 : 1, state.panes.size() - 1)), row);
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
    if (scope == Scope::Both || isShared(row)) {
        clearOverride(state, row, Scope::Both);
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
    if (scope == Scope::Both || isShared(row))
        assign(state, row, get(Parameters{}, row), Scope::Both);
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

void setPaneCount(State& state, int count)
{
    if (count == 2 && state.panes.size() == 1) {
        Pane second = state.panes.front();
        second.technique = second.technique == "parallax" ? "relief" : "parallax";
        state.panes.push_back(second);
    } else if (count == 1 && state.panes.size() == 2) {
        state.panes.pop_back();
    }
}

void SecondPane::show(State& state, bool on)
{
    if (state.panes.size() == 2)
        m_last = state.panes[1];
    setPaneCount(state, on ? 2 : 1);
    if (on && m_last)
        state.panes[1] = *m_last;
}

} // namespace relievo
