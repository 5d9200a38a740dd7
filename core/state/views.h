// The table of views: what a pane can show of the material.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/parameters.h"
#include <algorithm>
#include <array>
#include <string_view>

namespace relievo {

// What of the light a view computes.
enum class ViewLight { None, Shadows, All };

struct ViewRow {
    std::string_view key;
    std::string_view label;
    std::string_view file; // under shaders/
    std::string_view fileOnMesh = {}; // instead of it, where the exact answer of the displaced mesh is given; "" for the same
    std::string_view fileOfSeveral = {}; // instead of it, where there are several lights; "" for the same
    std::string_view unit = {}; // of the numbers of a heat map's legend; "" for pictures
    bool isHeat = false; // drawn with the colour-blind-safe heat map and a legend
    bool isColor = false; // encoded as sRGB, light after exposure and tone curve; else values are shown as they are
    bool isAgainstExact = false; // compares with the exact first hit: needs a height map, searches at full resolution
    ViewLight light = ViewLight::None;
    bool showsHoles = false; // what is cut out of the mesh is drawn
    float Parameters::*range = nullptr; // the value at the bright end of a heat map; nullptr: 1
    float wrongFrom = 0.02f; // of views against the exact hit: what is more than this is wrong, in the unit
    std::string_view help;
};

inline constexpr auto kViews = std::to_array<ViewRow>({
    {.key = "shaded",
        .label = "Shaded",
        .file = "views/shaded.glsl",
        .isColor = true,
        .light = ViewLight::All,
        .help = "The lit material."},
    {.key = "color",
        .label = "Base color",
        .file = "views/color.glsl",
        .isColor = true,
        .help = "Base color where the search lands, unlit."},
    {.key = "normal", .label = "Normal", .file = "views/normal.glsl", .help = "World-space normal, as n / 2 + 1/2."},
    {.key = "depth",
        .label = "Depth",
        .file = "views/depth.glsl",
        .unit = "depth",
        .isHeat = true,
        .help = "Depth that the search found: 0 on the surface, 1 deepest."},
    {.key = "fetches",
        .label = "Fetches",
        .file = "views/fetches.glsl",
        .unit = "fetches",
        .isHeat = true,
        .range = &Parameters::fetchRange,
        .help = "Texture reads of the search at each pixel."},
    {.key = "shadow",
        .label = "Shadow",
        .file = "views/shadow.glsl",
        .fileOfSeveral = "views/shadow_several.glsl",
        .light = ViewLight::Shadows,
        .help = "Shadow alone: white lit, black shadowed; of several lights the share that arrives."},
    {.key = "position",
        .label = "Position",
        .file = "views/position.glsl",
        .help = "World-space position of the point seen in metres, x red, y green, z blue; for float pictures."},
    {.key = "outline",
        .label = "Outline",
        .file = "views/outline.glsl",
        .showsHoles = true,
        .help = "What silhouettes cut off the mesh, in red."},
    {.key = "invalid",
        .label = "Invalid",
        .file = "views/invalid.glsl",
        .unit = "pixels",
        .isHeat = true,
        .light = ViewLight::All,
        .help = "Pixels whose light is not a number, from broken meshes or maps. There should be none."},
    {.key = "error",
        .label = "Error, search",
        .file = "views/error.glsl",
        .unit = "depth",
        .isHeat = true,
        .isAgainstExact = true,
        .range = &Parameters::errorRange,
        .help
        = "How wrong the search is: difference from the exact first hit along the same ray, straight, bent or through prisms, at full "
          "resolution, as a share of the depth; 1 where it misses."},
    {.key = "overshoot",
        .label = "Overshoot",
        .file = "views/overshoot.glsl",
        .unit = "depth",
        .isHeat = true,
        .isAgainstExact = true,
        .range = &Parameters::errorRange,
        .help = "How far the search goes through the first surface of the flat relief, as a share of the depth; 0 where it stops at it or "
                "before."},
    {.key = "error-mesh",
        .label = "Error, displaced mesh",
        .file = "views/error.glsl",
        .fileOnMesh = "views/error_on_mesh.glsl",
        .unit = "depth",
        .isHeat = true,
        .isAgainstExact = true,
        .range = &Parameters::errorRange,
        .help
        = "How wrong the picture is: difference of the point seen from the really displaced mesh, as a share of the depth; silhouettes "
          "and curvature count too. Grey: the displaced mesh is itself too coarse there to tell. On a plane the same as the search's."},
    {.key = "error-texels",
        .label = "Error in texels",
        .file = "views/error_texels.glsl",
        .unit = "texels",
        .isHeat = true,
        .isAgainstExact = true,
        .range = &Parameters::pixelRange,
        .wrongFrom = 0.5f,
        .help = "How many texels of the height map lie between the place that is shown and the exact one."},
    {.key = "error-pixels",
        .label = "Error in pixels",
        .file = "views/error_pixels.glsl",
        .unit = "px",
        .isHeat = true,
        .isAgainstExact = true,
        .range = &Parameters::pixelRange,
        .wrongFrom = 0.5f,
        .help
        = "By how many pixels of this picture the texture is shifted: the way between the place that is shown and the exact one, over "
          "the way that a pixel spans."},
    {.key = "missed",
        .label = "Missed",
        .file = "views/missed.glsl",
        .unit = "pixels",
        .isHeat = true,
        .isAgainstExact = true,
        .help = "Bright where the search went through the first surface: too deep by more than 2 % of the depth."},
});

const ViewRow* findView(std::string_view key); // nullptr when unknown

// The row of a key that the program itself names; a key that is none does not compile.
consteval const ViewRow& knownView(std::string_view key)
{
    return *std::ranges::find(kViews, key, &ViewRow::key);
}

// The value at the bright end of a heat view, in its unit.
inline float heatRange(const Parameters& parameters, const ViewRow& view)
{
    return view.range ? parameters.*view.range : 1.f;
}

} // namespace relievo
