// The table of search techniques: one row and one shader file each.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/parameters.h"
#include <array>
#include <string_view>

namespace relievo {

struct TechniqueRow {
    std::string_view key;
    std::string_view label;
    std::string_view file; // under shaders/, "" for the CPU-only reference
    std::string_view maps; // map kinds it cannot do without, separated by spaces
    std::string_view bound; // row of kMaps that it searches with, read through boundAt and its like; "" for none
    std::string_view parameters; // rows of kParameters marked "technique" that it reads
    std::string_view paper;
    bool displaces; // the picture moves: the mesh is pushed out for the midlevel
    bool searches; // runs along the ray (so it can cast shadows); else the picture is only shifted or not at all
    bool canMiss; // may return found == false
    bool isExact; // finds the true first hit of the bilinear surface
    std::string_view help;
};

inline constexpr auto kTechniques = std::to_array<TechniqueRow>({
    {"flat", "Flat", "techniques/flat.glsl", "", "", "", "-", false, false, false, false,
        "No relief: colour and roughness on the smooth mesh."},
    {"bump", "Bump", "techniques/bump.glsl", "", "", "", "Blinn 1978, Simulation of Wrinkled Surfaces", false, false, false, false,
        "Normals only: light reacts to the relief, the picture does not move. The normal map, or normals made from the height map."},
    {"parallax", "Parallax", "techniques/parallax.glsl", "height", "", "offsetLimiting heightMips",
        "Kaneko et al. 2001, Detailed Shape Representation with Parallax Mapping; Welsh 2004 (offset limiting)", true, false, false, false,
        "One step along the view by the height under the surface point: cheap, right only for gentle slopes."},
    {"steep", "Steep parallax", "techniques/steep.glsl", "height", "", "minSteps maxSteps heightMips silhouettes shadows shadowBias",
        "McGuire and McGuire 2005, Steep Parallax Mapping", true, true, true, false,
        "Linear search; the first sample inside is the answer, so it shows steps."},
    {"pom", "Parallax occlusion", "techniques/pom.glsl", "height", "", "minSteps maxSteps heightMips silhouettes shadows shadowBias",
        "Tatarchuk 2006, Dynamic Parallax Occlusion Mapping with Approximate Soft Shadows", true, true, true, false,
        "Linear search, then one secant step: what most engines call parallax occlusion mapping."},
    {"interval", "Interval", "techniques/interval.glsl", "height", "",
        "minSteps maxSteps refineSteps heightMips silhouettes shadows shadowBias",
        "Risser, Shah, Pattanaik 2007, Faster Relief Mapping Using the Secant Method", true, true, true, false,
        "Linear search, then secant steps, which close in faster than halvings where the surface is smooth."},
    {"relief", "Relief", "techniques/relief.glsl", "height", "", "minSteps maxSteps refineSteps heightMips silhouettes shadows shadowBias",
        "Policarpo, Oliveira, Comba 2005, Real-Time Relief Mapping on Arbitrary Polygonal Surfaces, section 3", true, true, false, false,
        "Linear search whose step count follows the viewing angle, then bisection of the step that went inside."},
    {"relief-fixed", "Relief, fixed steps", "techniques/relief-fixed.glsl", "height", "",
        "doublePrecision heightMips silhouettes shadows shadowBias", "Policarpo 2004, Relief Mapping in a Pixel Shader using Binary Search",
        true, true, false, false, "The first relief mapping: 10 linear steps and 6 halvings whatever the view, or 20 and 5."},
    {"contact", "Contact refinement", "techniques/contact.glsl", "height", "",
        "minSteps maxSteps heightMips silhouettes shadows shadowBias", "Riccardi 2019, Contact Refinement Parallax Mapping", true, true,
        false, false,
        "Linear search, then the step that went inside is searched again in as many small steps: no halvings, no miss within that step."},
    {"sphere", "Sphere tracing", "techniques/sphere.glsl", "height", "distance",
        "leapSteps safeBalls heightMips silhouettes shadows shadowBias",
        "Donnelly 2005, Per-Pixel Displacement Mapping with Distance Functions (GPU Gems 2, chapter 8)", true, true, false, false,
        "Leaps by a volume of distances: much memory, and thin relief is blurred by the volume's size."},
    {"cone", "Cone stepping", "techniques/cone.glsl", "height", "cone", "leapSteps refineSteps heightMips silhouettes shadows shadowBias",
        "Dummer 2006, Cone Step Mapping", true, true, false, false,
        "Leaps by a map of empty cones. The cones know texels only: between them a leap may end inside."},
    {"cone-quad", "Quad cones", "techniques/cone-quad.glsl", "height", "cone-quad",
        "leapSteps refineSteps heightMips silhouettes shadows shadowBias",
        "Policarpo and Oliveira 2007, Relaxed Cone Stepping for Relief Mapping (GPU Gems 3, chapter 18)", true, true, false, false,
        "Cone stepping with a cone for each of four directions: wider leaps for two fetches a step."},
    {"cone-relaxed", "Relaxed cones", "techniques/cone-relaxed.glsl", "height", "cone-relaxed",
        "leapSteps refineSteps lastBracket heightMips silhouettes shadows shadowBias",
        "Policarpo and Oliveira 2007, Relaxed Cone Stepping for Relief Mapping (GPU Gems 3, chapter 18), listing 18-3", true, true, false,
        false, "Wider cones that a ray may enter the relief in, then bisection: the favourite of relief mapping in games."},
    {"cone-robust", "Robust cones", "techniques/cone-robust.glsl", "height", "cone-robust",
        "leapSteps refineSteps provenStep heightMips silhouettes shadows shadowBias",
        "Ban, Valasek, Balint, Vad 2024, Robust Cone Step Mapping", true, true, false, false,
        "Relaxed cones made safe for bilinear heights, nearly: never less than a step to the cell's border."},
    {"pyramid", "Maximum pyramid", "techniques/pyramid.glsl", "height", "pyramid", "heightMips silhouettes shadows",
        "Tevs, Ihrke, Seidel 2008, Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering", true, true, false,
        true, "Exact: down a pyramid of maxima to the cell, which is solved in closed form."},
    {"cell-cone", "Cell cones", "techniques/cell-cone.glsl", "height", "cell-cone", "heightMips silhouettes shadows",
        "This program's own: cones and boxes over the bilinear cells, with proof", true, true, false, true,
        "Exact, with fewer fetches than the pyramid: leaps by boxes and cones of four nested nodes, cells solved in closed form."},
    {"reference", "Reference", "", "height", "", "", "Exact: ray against each bilinear cell in turn, double precision", true, true, false,
        true, "The exact answer that all others are measured against. CPU only."},
});

const TechniqueRow* findTechnique(std::string_view key); // nullptr when unknown

// Whether the row is of the search, the technique lists it, and it changes what a ray at full resolution finds.
bool searchesBy(const TechniqueRow& technique, const ParameterRow& row);

// Whether `word` is one of the space-separated words of `list`.
constexpr bool listHas(std::string_view list, std::string_view word)
{
    for (std::size_t at = 0; at <= list.size();) {
        const std::size_t end = list.find(' ', at) == std::string_view::npos ? list.size() : list.find(' ', at);
        if (list.substr(at, end - at) == word)
            return true;
        at = end + 1;
    }
    return false;
}

} // namespace relievo
