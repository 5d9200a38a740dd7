// The table of search techniques: one row and one shader file each.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
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
    {"relief", "Relief", "techniques/relief.glsl", "height", "", "minSteps maxSteps refineSteps heightMips shadows",
        "Policarpo, Oliveira, Comba 2005, Real-Time Relief Mapping on Arbitrary Polygonal Surfaces, section 3", true, true, false, false,
        "Linear search whose step count follows the viewing angle, then bisection of the step that went inside."},
    {"reference", "Reference", "", "height", "", "", "Exact: ray against each bilinear cell in turn, double precision", true, true, false,
        true, "The exact answer that all others are measured against. CPU only."},
});

const TechniqueRow* findTechnique(std::string_view key); // nullptr when unknown

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
