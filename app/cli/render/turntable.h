// Numbered pictures of a turn: names, and the State of each.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/scene/resources.h"
#include <filesystem>
#include <string_view>

namespace relievo::cli {

enum class Turn { Camera, Light };

// "a/x.####.png" and 7 give "a/x.0007.png"; a number of more digits takes more room. Empty when the file's name holds no #.
std::filesystem::path numbered(const std::filesystem::path& pattern, int number);

// The State with its first pane's camera or light turned about the vertical axis by `share` of a whole turn: a sequence of equal shares
// loops. The camera keeps the distance at which the mesh fits from all `frames` sides, unless the State sets one.
State turned(const State& state, Turn turn, float share);
State withRoomToTurn(const State& state, const Mesh& mesh, int frames, float aspect);

} // namespace relievo::cli
