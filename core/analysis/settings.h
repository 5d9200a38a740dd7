// The settings that techniques are measured with, derived from the parameters their rows list.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/state/parameters.h"
#include "core/state/state.h"
#include "core/state/techniques.h"
#include <array>
#include <span>
#include <string>
#include <vector>

namespace relievo {

struct SearchSetting {
    const TechniqueRow* technique = nullptr; // never null in what these functions return
    std::string label; // "Relief 32+6", "Parallax, offset limiting"
    std::string series; // the same without the steps: what a curve joins
    Parameters parameters;
};

inline constexpr std::array<int, 6> kReportSteps = {8, 16, 32, 64, 128, 256};
inline constexpr std::array<int, 16> kTuneSteps = {2, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512};

// `base` with every step count of the search that the row lists set to each of `steps` (refineSteps stays), and each of these again with
// every switch of the search that the row lists turned over. A technique without steps or switches has one setting.
// heightMips is always off: what is measured is the search at full resolution.
std::vector<SearchSetting> settingsOf(const TechniqueRow& row, const Parameters& base, std::span<const int> steps);

// One setting a technique, for pictures of each: `base` as it is.
SearchSetting plainSetting(const TechniqueRow& row, const Parameters& base);

// What the GPU draws most exactly: a technique that is exact and has a shader, else relief with as many steps as there may be.
SearchSetting mostExactSetting(const Parameters& base);

// The State with its first pane, and no other, showing the setting: its technique and the parameters of the search that this lists.
State withSetting(const State& state, const SearchSetting& setting);

// The value of every parameter of the search that the setting's technique lists, "minSteps=32 maxSteps=32 refineSteps=6".
std::string parametersText(const SearchSetting& setting);

// The techniques that keys name; all with a shader file but engines' (isChoice) when there are none. Errors: an unknown key, reference.
Expected<std::vector<const TechniqueRow*>> techniquesNamed(std::span<const std::string> keys);

} // namespace relievo
