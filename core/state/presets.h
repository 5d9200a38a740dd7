// The presets that come with the program, and presets in files.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/state_json.h"
#include <array>
#include <string_view>

namespace relievo {

struct PresetRow {
    std::string_view key;
    std::string_view label;
    std::string_view json; // a partial State
    std::string_view help;
};

inline constexpr auto kPresets = std::to_array<PresetRow>({
    {"preview", "Preview",
        R"({"relievo":1,"parameters":{"minSteps":4,"maxSteps":16,"refineSteps":4,"shadows":false},"panes":[{"technique":"relief"}]})",
        "Few steps and no shadows: for slow machines and small sizes."},
    {"game", "Game",
        R"({"relievo":1,"parameters":{"minSteps":8,"maxSteps":32,"refineSteps":5,"shadows":true},"panes":[{"technique":"relief"}]})",
        "What engines ship: 8 to 32 steps and five refinements."},
    {"paper", "Paper 2005",
        R"({"relievo":1,"parameters":{"minSteps":10,"maxSteps":40,"refineSteps":6,"shadows":true,"shading":"blinn-phong"},"panes":[{"technique":"relief"}]})",
        "Relief mapping and Blinn-Phong light as in Policarpo, Oliveira and Comba 2005."},
    {"fine", "Fine",
        R"({"relievo":1,"parameters":{"minSteps":64,"maxSteps":256,"refineSteps":8,"shadows":true},"panes":[{"technique":"relief"}]})",
        "Many steps: for stills and for judging the others."},
});

// nameOrFile: a key of kPresets, or a JSON file. Errors: neither.
Expected<StateRead> readPreset(const State& base, const std::string& nameOrFile);

} // namespace relievo
