// Whom the panel's edits reach: all panes, or one pane by its overrides. Pure functions of the State, without widgets.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/state.h"
#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

namespace relievo {

// One pane, or all of them.
using Scope = std::optional<std::size_t>;
inline constexpr Scope kAllPanes = std::nullopt;

// The value that the panel shows for a row, and whether it is a pane's own.
Value shownValue(const State& state, const ParameterRow& row, Scope scope);
bool isOverridden(const State& state, const ParameterRow& row, Scope scope); // all: in any pane

// Sets it for all panes (their own values of it go) or for one. What panes share (ParameterRow::sharedByPanes) is always set for all, so
// that what stands side by side can be compared; only files and the command line give panes ranges of their own.
void assign(State& state, const ParameterRow& row, const Value& value, Scope scope);
void clearOverride(State& state, const ParameterRow& row, Scope scope); // all: in all panes

// The default for all; for one pane: back to what all have.
void reset(State& state, const ParameterRow& row, Scope scope);

// Whether the row has a line in the panel: what no pane's technique uses is not shown (ParameterRow::shown).
bool isShown(const State& state, const ParameterRow& row);

// 1 to kMaxPanes; a new one begins as the last with a technique that no pane has yet.
void setPaneCount(State& state, std::size_t count);
// Two panes change their places.
void swapPanes(State& state, std::size_t one, std::size_t other);
// The same once more, after it; not beyond kMaxPanes.
void duplicatePane(State& state, std::size_t pane);
void closePane(State& state, std::size_t pane); // not the last one
// Unlinked, a pane keeps camera and light as they are now and moves alone; linked, it follows the shared ones again.
void setLinked(State& state, std::size_t pane, bool linked);
inline bool isLinked(const State& state, std::size_t pane)
{
    return !state.panes[pane].camera;
}
// The rows that a pane has values of its own for; not the light of an unlinked one, which goes with its camera.
std::vector<const ParameterRow*> ownValues(const State& state, std::size_t pane);
// What the pane has of its own holds for all.
void shareOwnValues(State& state, std::size_t pane);
void dropOwnValues(State& state, std::size_t pane); // what all have holds for it

// Turns the panes beside the first on and off, and brings them back as they last were.
class FurtherPanes {
public:
    void show(State& state, bool on) { show(state, on ? std::max(1 + m_last.size(), std::size_t(2)) : 1); }
    void show(State& state, std::size_t count); // as many
    void forget() { m_last.clear(); } // another document begins

private:
    std::vector<Pane> m_last; // from the second on
};

} // namespace relievo
