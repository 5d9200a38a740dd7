// The built-in meshes, by name; core/mesh/shapes makes them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string_view>

namespace relievo {

// Made by formula, largest size 1 m, centred, y up.
inline constexpr std::array<std::string_view, 10> kShapes
    = {"plane", "sphere", "cylinder", "torus", "box", "teapot", "spheres", "character", "room", "knight"};

} // namespace relievo
