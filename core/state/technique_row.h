// A row of the table of search techniques.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/map_slots.h"
#include "core/state/parameters.h"
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
    // The mesh is pushed out for the midlevel. Not where an engine is not told the midlevel: what it takes for zero lies on its mesh.
    bool displaces = false;
    bool searches = false; // runs along the ray; else the picture is only shifted or not at all
    bool canMiss = false; // may return found == false
    bool isExact = false; // finds the true first hit of the bilinear surface
    bool readsNormals = true; // the relief shows in the light, even where the picture does not move
    std::string_view help;
    // "Godot 4" of a technique that draws as an engine does, given the depth that an export writes, with its omissions; "" for all others.
    // Its Ray meets the engine's mesh. Its Hit's uv is the texture that the engine shows, its t where the eye sees that on the view ray: it
    // counts from where white would lie. Finest mip level only: a pane's heightMips is off.
    std::string_view engine = {};
    float zero = 1.f; // height that lies on the mesh of such a technique
    bool isOfObjects = false; // draws a relief object, and nothing else; its file defines traceObject (shaders/object/object_contract.glsl)

    constexpr bool needsHeights() const { return maps.contains(MapKind::Height); }
    constexpr bool isEngine() const { return !engine.empty(); }
    constexpr bool hasShadowsAndOutlines() const { return searches && !isEngine(); } // its search is asked for them; engines draw none
    constexpr bool hasSilhouettes() const { return hasShadowsAndOutlines() && !isOfObjects; } // the mesh can be cut away
    // Depth below white of the mesh that is drawn, share.
    constexpr float meshDepth() const { return isEngine() && !displaces ? 1.f - zero : 0.f; }
    // What the technique list is divided by.
    constexpr std::string_view group() const
    {
        return isEngine()              ? "As engines draw it"
            : isOfObjects              ? "Relief object"
            : isExact                  ? "Exact"
            : !accelerationMap.empty() ? "Search with a baked map"
            : searches                 ? "Search in steps"
                                       : "No search";
    }
};

} // namespace relievo
