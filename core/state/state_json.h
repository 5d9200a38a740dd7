// The State as JSON: project files (.relievo) and presets, which are partial States.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/state/state.h"
#include "core/state/techniques.h"
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace relievo {

inline constexpr int kStateVersion = 1;

// Every member, defaults too. Paths are written relative to `folder` where that is possible.
std::string toJson(const State& state, const std::filesystem::path& folder);

// Only what decides the material's look, not which files it is made of: parameters, technique of pane 0. For `export --target preset`.
std::string toPresetJson(const State& state);

// Members that the text does not name keep their value in `base`; relative paths are read from `folder`. Unknown keys (the
// first ten, then their number) and values out of range (clamped) become warnings that name the key and its place; a text that is no
// JSON, nested deeper than any State, or of a newer version, is an error.
struct StateRead {
    State state;
    Warnings warnings;
};
Expected<StateRead> fromJson(const State& base, const std::string& text, const std::filesystem::path& folder, const std::string& where);

// The parameters that the technique searches by (searchesBy): numbers, switches as booleans, choices by name.
nlohmann::ordered_json searchJson(const TechniqueRow& technique, const Parameters& parameters);

Expected<StateRead> readState(const State& base, const std::filesystem::path& file);
Expected<void> writeState(const State& state, const std::filesystem::path& file); // atomic

} // namespace relievo
