// Reading and writing parameters for one pane or all.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/editing.h"
#include "core/state/lights.h"
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
    return condition.holdsFor(on ? int(*on) : std::get<int>(value));
}

// Whether the row is shown for pane `index`.
bool holdsIn(const State& state, std::size_t index, const ParameterRow& row)
{
    const TechniqueRow* technique = findTechnique(state.panes[index].technique);
    const bool byTechnique = !row.shown.byTechnique || (technique && technique->parameters.contains(row));
    const bool inUse
        = !row.shown.when || holds(state, index, *row.shown.when) || (row.shown.orWhen && holds(state, index, *row.shown.orWhen));
    return byTechnique && !row.shown.inAnimationBar && inUse;
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

namespace {
// What is compared most, in that order.
constexpr std::string_view kCompared[] = {"parallax", "relief", "cell-cone", "pom", "bump", "steep"};

// Where lights are, which goes with a camera.
bool placesLight(const ParameterRow& row)
{
    return std::ranges::any_of(kLights, [&](const LightMembers& light) {
        return row.member == Member(light.yaw) || row.member == Member(light.pitch) || row.member == Member(light.distance);
    });
}

const ParameterRow& rowOf(const Member& member)
{
    return kParameters[indexOf(member)];
}

void keepLights(Pane& pane, const Parameters& lit)
{
    const auto keep
        = [&](const Member& member) { pane.overrides.insert_or_assign(std::string(rowOf(member).key), get(lit, rowOf(member))); };
    for (const LightMembers& light : kLights) {
        if (isLit(lit, light))
            keep(light.yaw), keep(light.pitch);
        if (isNear(lit, light))
            keep(light.distance);
    }
}

bool isShownBy(const State& state, std::string_view technique)
{
    return std::ranges::find(state.panes, technique, &Pane::technique) != state.panes.end();
}
} // namespace

void setPaneCount(State& state, std::size_t count)
{
    state.panes.resize(std::clamp(count, std::size_t(1), std::min(kMaxPanes, state.panes.size())));
    while (state.panes.size() < std::min(count, kMaxPanes)) {
        Pane next = state.panes.back();
        const auto* fresh = std::ranges::find_if(kCompared, [&](std::string_view key) { return !isShownBy(state, key); });
        next.technique = fresh == std::end(kCompared) ? next.technique : *fresh;
        state.panes.push_back(next);
    }
}

void swapPanes(State& state, std::size_t one, std::size_t other)
{
    std::swap(state.panes[one], state.panes[other]);
}

void duplicatePane(State& state, std::size_t pane)
{
    if (state.panes.size() < kMaxPanes)
        state.panes.insert(state.panes.begin() + std::ptrdiff_t(pane) + 1, Pane(state.panes[pane]));
}

void closePane(State& state, std::size_t pane)
{
    if (state.panes.size() > 1)
        state.panes.erase(state.panes.begin() + std::ptrdiff_t(pane));
}

void setLinked(State& state, std::size_t pane, bool linked)
{
    if (linked == isLinked(state, pane))
        return;
    Pane& own = state.panes[pane];
    const Parameters lit = effectiveParameters(state, pane);
    own.camera = linked ? std::nullopt : std::optional(state.camera);
    if (!linked)
        return keepLights(own, lit);
    for (const ParameterRow& row : kParameters)
        if (placesLight(row))
            own.overrides.erase(std::string(row.key));
}

std::vector<const ParameterRow*> ownValues(const State& state, std::size_t pane)
{
    std::vector<const ParameterRow*> rows;
    for (const ParameterRow& row : kParameters)
        if (isOverridden(state, row, pane) && (isLinked(state, pane) || !placesLight(row)))
            rows.push_back(&row);
    return rows;
}

void shareOwnValues(State& state, std::size_t pane)
{
    for (const ParameterRow* row : ownValues(state, pane))
        assign(state, *row, shownValue(state, *row, pane), kAllPanes);
}

void dropOwnValues(State& state, std::size_t pane)
{
    for (const ParameterRow* row : ownValues(state, pane))
        clearOverride(state, *row, pane);
}

void FurtherPanes::show(State& state, std::size_t count)
{
    const std::size_t further = state.panes.size() - 1;
    m_last.resize(std::max(m_last.size(), further));
    std::copy(state.panes.begin() + 1, state.panes.end(), m_last.begin());
    for (std::size_t i = further; i < m_last.size() && state.panes.size() < count; ++i)
        state.panes.push_back(m_last[i]);
    setPaneCount(state, count);
}

} // namespace relievo
