// The files that pictures, maps and exports are made from: whether they are there, and that no output replaces them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/state/state.h"
#include <filesystem>
#include <vector>

namespace relievo {

// The files that a State names: maps (for a picture inside a glTF file that file), mesh, environment. What is made by formula is none.
std::vector<std::filesystem::path> filesOf(const State& state);
std::vector<std::filesystem::path> filesOf(const MapSlots& slots);

// An error when `out` is one of the files that were read, under whatever name, also through links.
Expected<void> refuseToReplace(const std::vector<std::filesystem::path>& read, const std::filesystem::path& out);

// What in a State can hardly be meant, though it can be drawn: "mesh-missing" and "environment-missing", files that are not there;
// "steps-reversed", fewest steps above most steps in a pane.
Warnings doubtsOf(const State& state);

} // namespace relievo
