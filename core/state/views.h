// The table of views: what a pane can show of the material.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/parameters.h"
#include <array>
#include <string_view>

namespace relievo {

struct ViewRow {
    std::string_view key;
    std::string_view label;
    std::string_view file; // under shaders/
    std::string_view unit; // of the numbers of a heat map's legend; "" for pictures
    bool isHeat; // drawn with the colour-blind-safe heat map and a legend
    bool isColor; // encoded as sRGB, light after exposure and tone curve; else values are shown as they are
    bool isAgainstExact; // compares with the exact first hit: needs a height map, searches at full resolution
    std::string_view help;
};

inline constexpr auto kViews = std::to_array<ViewRow>({
    {"shaded", "Shaded", "views/shaded.glsl", "", false, true, false, "The lit material."},
    {"color", "Base color", "views/color.glsl", "", false, true, false, "Base color where the search lands, unlit."},
    {"normal", "Normal", "views/normal.glsl", "", false, false, false, "World-space normal, as n / 2 + 1/2."},
    {"depth", "Depth", "views/depth.glsl", "depth", true, false, false, "Depth that the search found: 0 on the surface, 1 deepest."},
    {"fetches", "Fetches", "views/fetches.glsl", "fetches", true, false, false, "Texture reads of the search at each pixel."},
    {"shadow", "Shadow", "views/shadow.glsl", "", false, false, false, "Shadow alone: white lit, black shadowed."},
    {"position", "Position", "views/position.glsl", "", false, false, false,
        "World-space position of the point seen in metres, x red, y green, z blue; for float pictures."},
    {"outline", "Outline", "views/outline.glsl", "", false, false, false, "What silhouettes cut off the mesh, in red."},
    {"invalid", "Invalid", "views/invalid.glsl", "pixels", true, false, false,
        "Pixels whose light is not a number, from broken meshes or maps. There should be none."},
    {"error", "Error", "views/error.glsl", "depth", true, false, true,
        "Difference from the exact answer at full resolution, as a share of the depth: of the depth found from the exact first hit on a "
        "plane, of the point seen from the displaced mesh itself on others."},
    {"overshoot", "Overshoot", "views/overshoot.glsl", "depth", true, false, true,
        "How far the search goes through the first surface of the flat relief, as a share of the depth; 0 where it stops at it or before."},
});

const ViewRow* findView(std::string_view key); // nullptr when unknown

// The value at the bright end of a heat view, in its unit.
float heatRange(const Parameters& parameters, std::string_view view);

} // namespace relievo
