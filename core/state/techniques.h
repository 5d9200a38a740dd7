// The table of search techniques: one row and one shader file each.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/map_slots.h"
#include "core/state/parameters.h"
#include <algorithm>
#include <array>
#include <string_view>

namespace relievo {

struct TechniqueRow {
    std::string_view key;
    std::string_view label;
    std::string_view file = {}; // under shaders/, "" for the CPU-only reference
    EnumSet<MapKind> maps = {}; // that it cannot do without
    std::string_view accelerationMap = {}; // row of kBakedMaps that it searches with, read through boundAt and its like; "" for none
    ParameterSet parameters = {}; // of those that are shown by technique, the ones that it reads
    std::string_view paper;
    bool displaces = false; // the picture moves: the mesh is pushed out for the midlevel
    bool searches = false; // runs along the ray (so it can cast shadows); else the picture is only shifted or not at all
    bool canMiss = false; // may return found == false
    bool isExact = false; // finds the true first hit of the bilinear surface
    bool readsNormals = true; // the relief shows in the light, even where the picture does not move
    std::string_view help;

    constexpr bool needsHeights() const { return maps.contains(MapKind::Height); }
};

inline constexpr auto kTechniques = std::to_array<TechniqueRow>({
    {.key = "flat",
        .label = "Flat",
        .file = "techniques/flat.glsl",
        .paper = "-",
        .readsNormals = false,
        .help = "No relief: colour and roughness on the smooth mesh."},
    {.key = "bump",
        .label = "Bump",
        .file = "techniques/bump.glsl",
        .paper = "Blinn 1978, Simulation of Wrinkled Surfaces",
        .help
        = "Normals only: light reacts to the relief, the picture does not move. The normal map, or normals made from the height map."},
    {.key = "parallax",
        .label = "Parallax",
        .file = "techniques/parallax.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::offsetLimiting, &Parameters::heightMips},
        .paper = "Kaneko et al. 2001, Detailed Shape Representation with Parallax Mapping; Welsh 2004 (offset limiting)",
        .displaces = true,
        .help = "One step along the view by the height under the surface point: cheap, right only for gentle slopes."},
    {.key = "steep",
        .label = "Steep parallax",
        .file = "techniques/steep.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps, &Parameters::heightMips, &Parameters::silhouettes,
            &Parameters::shadows, &Parameters::shadowBias},
        .paper = "McGuire and McGuire 2005, Steep Parallax Mapping",
        .displaces = true,
        .searches = true,
        .canMiss = true,
        .help = "Linear search; the first sample inside is the answer, so it shows steps."},
    {.key = "pom",
        .label = "Parallax occlusion",
        .file = "techniques/pom.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps, &Parameters::heightMips, &Parameters::silhouettes,
            &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Tatarchuk 2006, Dynamic Parallax Occlusion Mapping with Approximate Soft Shadows",
        .displaces = true,
        .searches = true,
        .canMiss = true,
        .help = "Linear search, then one secant step: what most engines call parallax occlusion mapping."},
    {.key = "interval",
        .label = "Interval",
        .file = "techniques/interval.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps, &Parameters::refineSteps, &Parameters::heightMips,
            &Parameters::silhouettes, &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Risser, Shah, Pattanaik 2007, Faster Relief Mapping Using the Secant Method",
        .displaces = true,
        .searches = true,
        .canMiss = true,
        .help = "Linear search, then secant steps, which close in faster than halvings where the surface is smooth."},
    {.key = "relief",
        .label = "Relief",
        .file = "techniques/relief.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps, &Parameters::refineSteps, &Parameters::heightMips,
            &Parameters::silhouettes, &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Policarpo, Oliveira, Comba 2005, Real-Time Relief Mapping on Arbitrary Polygonal Surfaces, section 3",
        .displaces = true,
        .searches = true,
        .help = "Linear search whose step count follows the viewing angle, then bisection of the step that went inside."},
    {.key = "relief-fixed",
        .label = "Relief, fixed steps",
        .file = "techniques/relief-fixed.glsl",
        .maps = {MapKind::Height},
        .parameters
        = {&Parameters::doublePrecision, &Parameters::heightMips, &Parameters::silhouettes, &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Policarpo 2004, Relief Mapping in a Pixel Shader using Binary Search",
        .displaces = true,
        .searches = true,
        .help = "The first relief mapping: 10 linear steps and 6 halvings whatever the view, or 20 and 5."},
    {.key = "contact",
        .label = "Contact refinement",
        .file = "techniques/contact.glsl",
        .maps = {MapKind::Height},
        .parameters = {&Parameters::minSteps, &Parameters::maxSteps, &Parameters::heightMips, &Parameters::silhouettes,
            &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Riccardi 2019, Contact Refinement Parallax Mapping",
        .displaces = true,
        .searches = true,
        .help
        = "Linear search, then the step that went inside is searched again in as many small steps: no halvings, no miss within that step."},
    {.key = "sphere",
        .label = "Sphere tracing",
        .file = "techniques/sphere.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "distance",
        .parameters = {&Parameters::leapSteps, &Parameters::safeBalls, &Parameters::heightMips, &Parameters::silhouettes,
            &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Donnelly 2005, Per-Pixel Displacement Mapping with Distance Functions (GPU Gems 2, chapter 8)",
        .displaces = true,
        .searches = true,
        .help = "Leaps by a volume of distances: much memory, and thin relief is blurred by the volume's size."},
    {.key = "cone",
        .label = "Cone stepping",
        .file = "techniques/cone.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "cone",
        .parameters = {&Parameters::leapSteps, &Parameters::refineSteps, &Parameters::heightMips, &Parameters::silhouettes,
            &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Dummer 2006, Cone Step Mapping",
        .displaces = true,
        .searches = true,
        .help = "Leaps by a map of empty cones. The cones know texels only: between them a leap may end inside."},
    {.key = "cone-quad",
        .label = "Quad cones",
        .file = "techniques/cone-quad.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "cone-quad",
        .parameters = {&Parameters::leapSteps, &Parameters::refineSteps, &Parameters::heightMips, &Parameters::silhouettes,
            &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Policarpo and Oliveira 2007, Relaxed Cone Stepping for Relief Mapping (GPU Gems 3, chapter 18)",
        .displaces = true,
        .searches = true,
        .help = "Cone stepping with a cone for each of four directions: wider leaps for two fetches a step."},
    {.key = "cone-relaxed",
        .label = "Relaxed cones",
        .file = "techniques/cone-relaxed.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "cone-relaxed",
        .parameters = {&Parameters::leapSteps, &Parameters::refineSteps, &Parameters::lastBracket, &Parameters::heightMips,
            &Parameters::silhouettes, &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Policarpo and Oliveira 2007, Relaxed Cone Stepping for Relief Mapping (GPU Gems 3, chapter 18), listing 18-3",
        .displaces = true,
        .searches = true,
        .help = "Wider cones that a ray may enter the relief in, then bisection: the favourite of relief mapping in games."},
    {.key = "cone-robust",
        .label = "Robust cones",
        .file = "techniques/cone-robust.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "cone-robust",
        .parameters = {&Parameters::leapSteps, &Parameters::refineSteps, &Parameters::provenStep, &Parameters::heightMips,
            &Parameters::silhouettes, &Parameters::shadows, &Parameters::shadowBias},
        .paper = "Ban, Valasek, Balint, Vad 2024, Robust Cone Step Mapping",
        .displaces = true,
        .searches = true,
        .help = "Relaxed cones made safe for bilinear heights, nearly: never less than a step to the cell's border."},
    {.key = "pyramid",
        .label = "Maximum pyramid",
        .file = "techniques/pyramid.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "pyramid",
        .parameters = {&Parameters::heightMips, &Parameters::silhouettes, &Parameters::shadows},
        .paper = "Tevs, Ihrke, Seidel 2008, Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering",
        .displaces = true,
        .searches = true,
        .isExact = true,
        .help = "Exact: down a pyramid of maxima to the cell, which is solved in closed form."},
    {.key = "cell-cone",
        .label = "Cell cones",
        .file = "techniques/cell-cone.glsl",
        .maps = {MapKind::Height},
        .accelerationMap = "cell-cone",
        .parameters = {&Parameters::heightMips, &Parameters::silhouettes, &Parameters::shadows},
        .paper = "This program's own: cones and boxes over the bilinear cells, with proof",
        .displaces = true,
        .searches = true,
        .isExact = true,
        .help = "Exact, with fewer fetches than the pyramid: leaps by boxes and cones of four nested nodes, cells solved in closed form."},
    {.key = "reference",
        .label = "Reference",
        .maps = {MapKind::Height},
        .paper = "Exact: ray against each bilinear cell in turn, double precision",
        .displaces = true,
        .searches = true,
        .isExact = true,
        .help = "The exact answer that all others are measured against. CPU only."},
});

const TechniqueRow* findTechnique(std::string_view key); // nullptr when unknown

// The row of a key that the program itself names; a key that is none does not compile.
consteval const TechniqueRow& knownTechnique(std::string_view key)
{
    return *std::ranges::find(kTechniques, key, &TechniqueRow::key);
}

// Whether the technique lists the row, and it changes what a ray at full resolution finds.
constexpr bool searchesBy(const TechniqueRow& technique, const ParameterRow& row)
{
    return row.affects.contains(Affects::Search) && technique.parameters.contains(row);
}

} // namespace relievo
