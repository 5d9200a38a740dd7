// The built-in meshes, by name; core/mesh/shapes makes them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <array>
#include <string_view>

namespace relievo {

// Made by formula, largest size 1 m, centred, y up.
inline constexpr std::array<std::string_view, 10> kShapes
    = {"plane", "sphere", "cylinder", "torus", "box", "teapot", "spheres", "character", "room", "knight"};

// "object:SHAPE" is the shape as a relief object of six sides, "object:SHAPE@1" and "@2" of one and two; baked when it is opened.
inline constexpr std::string_view kObjectOfShape = "object:";
constexpr std::string_view shapeOfObject(std::string_view mesh) // "" for other names
{
    mesh = mesh.starts_with(kObjectOfShape) ? mesh.substr(kObjectOfShape.size()) : std::string_view();
    const std::string_view shape = mesh.substr(0, mesh.find('@')), sides = mesh.substr(shape.size());
    const bool isKnown = std::ranges::count(kShapes, shape) > 0 && (sides.empty() || sides == "@1" || sides == "@2");
    return isKnown ? shape : std::string_view();
}

// Whether State::mesh names what is made by formula: there is no file behind it.
constexpr bool isBuiltInMesh(std::string_view mesh)
{
    return std::ranges::count(kShapes, mesh) > 0 || !shapeOfObject(mesh).empty();
}

} // namespace relievo
