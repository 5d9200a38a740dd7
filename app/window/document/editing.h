// Whom the panel's edits reach: both panes, or one pane by its overrides. Pure functions of the State, without widgets.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/state.h"
#include <optional>
#include <string_view>

namespace relievo {

enum class Scope { Both, A, B };

// The value that the panel shows for a row, and whether it is a pane's own.
Value shownValue(const State& state, const ParameterRow& row, Scope scope);
bool isOverridden(const State& state, const ParameterRow& row, Scope scope); // Both: in any pane

// Sets it for both panes (their own values of it go) or for one. The ranges of heat maps are always set for both, so that what
// stands side by side can be compared; only files and the command line give panes ranges of their own.
void assign(State& state, const ParameterRow& row, const Value& value, Scope scope);
void clearOverride(State& state, const ParameterRow& row, Scope scope); // Both: in all panes

// The default for both; for one pane: back to what both have.
void reset(State& state, const ParameterRow& row, Scope scope);

// Whether the row has a line in the panel: what no pane's technique uses is not shown (ParameterRow::shown).
bool isShown(const State& state, const ParameterRow& row);

// One pane or two; the second begins as the first with another technique.
void setPaneCount(State& state, int count);

// Turns the second pane on and off, and brings it back as it last was.
class SecondPane {
public:
    void show(State& state, bool on);
    void forget() { m_last.reset(); } // another document begins

private:
    std::optional<Pane> m_last;
};

} // namespace relievo
