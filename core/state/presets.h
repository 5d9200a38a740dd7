// The presets that come with the program, and presets in files.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/state_json.h"
#include <array>
#include <string_view>

namespace relievo {

struct PresetRow {
    std::string_view key;
    std::string_view label;
    std::string_view sample; // of kSamples: the preset is a whole scene, opened as "scene:KEY"; "" for numbers only
    std::string_view json; // a partial State
    std::string_view help;
};

inline constexpr auto kPresets = std::to_array<PresetRow>({
    {"preview", "Preview", "",
        R"({"relievo":1,"parameters":{"minSteps":4,"maxSteps":16,"refineSteps":4,"shadows":false},"panes":[{"technique":"relief"}]})",
        "Few steps and no shadows: for slow machines and small sizes."},
    {"game", "Game", "",
        R"({"relievo":1,"parameters":{"minSteps":8,"maxSteps":32,"refineSteps":5,"shadows":true},"panes":[{"technique":"relief"}]})",
        "What engines ship: 8 to 32 steps and five refinements."},
    {"paper", "Paper 2005", "",
        R"({"relievo":1,"parameters":{"minSteps":10,"maxSteps":40,"refineSteps":6,"shadows":true,"shading":"blinn-phong"},"panes":[{"technique":"relief"}]})",
        "Relief mapping and Blinn-Phong light as in Policarpo, Oliveira and Comba 2005."},
    {"fine", "Fine", "",
        R"({"relievo":1,"parameters":{"minSteps":64,"maxSteps":256,"refineSteps":8,"shadows":true},"panes":[{"technique":"relief"}]})",
        "Many steps: for stills and for judging the others."},
    {"teapot-cobbles", "Teapot, cobbles", "cobblestones",
        R"({"relievo":1,"mesh":"teapot","parameters":{"depth":0.1,"silhouettes":"prisms","depthOfHit":true,"shadows":true,"background":"gradient","ground":true},"camera":{"yaw":30,"pitch":20,"fov":35},"panes":[{"technique":"relief"}]})",
        "A pot in stones, as in Policarpo, Oliveira and Comba 2005, with silhouettes."},
    {"teapot-scales", "Teapot, scales", "scales",
        R"({"relievo":1,"mesh":"teapot","parameters":{"depth":0.08,"silhouettes":"prisms","depthOfHit":true,"shadows":true,"background":"gradient","ground":true},"camera":{"yaw":30,"pitch":20,"fov":35},"panes":[{"technique":"relief"}]})",
        "The same pot in scales."},
    {"teapot-bricks", "Teapot, bricks", "bricks",
        R"({"relievo":1,"mesh":"teapot","parameters":{"depth":0.06,"silhouettes":"prisms","depthOfHit":true,"shadows":true,"background":"gradient","ground":true},"camera":{"yaw":30,"pitch":20,"fov":35},"panes":[{"technique":"relief"}]})",
        "The same pot in bricks."},
    {"interpenetration", "Interpenetration", "cobblestones",
        R"({"relievo":1,"mesh":"spheres","parameters":{"depth":0.12,"tiling":1,"depthOfHit":true,"shadows":true,"objectShadows":true,"silhouettes":"quadric"},"camera":{"yaw":30,"pitch":40,"fov":35},"panes":[{"technique":"relief"}]})",
        "A relief plane with three spheres in it, as figure 18 of Policarpo, Oliveira and Comba 2005."},
    {"character", "Animated character", "scales",
        R"({"relievo":1,"mesh":"character","parameters":{"depth":0.06,"silhouettes":"prisms","depthOfHit":true,"shadows":true,"background":"gradient","ground":true},"camera":{"yaw":30,"pitch":10,"fov":35},"panes":[{"technique":"relief"}]})",
        "A figure that walks, with relief on its bending limbs. Play it under the picture."},
    {"tea-hour", "Tea hour", "cobblestones",
        R"({"relievo":1,"mesh":"room","parameters":{"depth":0.046,"tiling":0.6,"depthOfHit":true,"shadows":true,"objectShadows":true,"shadowMapSize":2048,"lightYaw":35,"lightPitch":38,"environmentIntensity":0.3,"background":"gradient"},"camera":{"yaw":40,"pitch":14,"fov":35,"distance":1.75,"target":[-0.03,-0.1,0]},"panes":[{"technique":"relief"}]})",
        "A room with a table, a pot and a guest, all in stones, as figure 2 of Policarpo, Oliveira and Comba 2005."},
    {"four-ways", "Four ways", "bricks",
        R"({"relievo":1,"mesh":"sphere","parameters":{"depth":0.06,"tiling":1,"lightYaw":-55,"lightPitch":35,"background":"gradient","ground":true},"camera":{"yaw":20,"pitch":15,"fov":35,"fill":0.8},"panes":[{"technique":"bump","overrides":{"shadows":false}},{"technique":"parallax","overrides":{"shadows":false}},{"technique":"relief","overrides":{"shadows":false}},{"technique":"relief","overrides":{"shadows":true}}]})",
        "Bump mapping, parallax mapping, relief mapping, and relief mapping with self-shadows, as figure 1.1 of the RTM project report."},
    {"close-up-stones", "Close-up, stones", "cobblestones",
        R"({"relievo":1,"mesh":"teapot","parameters":{"depth":0.1,"silhouettes":"prisms","depthOfHit":true,"shadows":true,"lightYaw":70,"lightPitch":25},"camera":{"yaw":48,"pitch":12,"fov":35,"distance":0.42,"target":[0.08,0.02,0.1]},"panes":[{"technique":"relief"}]})",
        "From so near that a texel fills pixels, as figure 16 of Policarpo, Oliveira and Comba 2005."},
    {"close-up-rock", "Close-up, rock", "terrain",
        R"({"relievo":1,"mesh":"teapot","parameters":{"depth":0.085,"silhouettes":"prisms","depthOfHit":true,"shadows":true,"lightYaw":-70,"lightPitch":25,"lightIntensity":1.1,"environmentIntensity":0.3},"camera":{"yaw":-25,"pitch":25,"fov":35,"distance":0.5,"target":[-0.05,0.04,0.1]},"panes":[{"technique":"relief"}]})",
        "The same of rock, as figure 17 of Policarpo, Oliveira and Comba 2005."},
    {"knight", "Chess knight", "bricks",
        R"({"relievo":1,"mesh":"object:knight","parameters":{"shadows":true,"background":"gradient","ground":true,"tint":[0.35,0.2,0.11],"lightYaw":-40},"camera":{"yaw":25,"pitch":12,"fov":35,"fill":0.85},"panes":[{"technique":"object"}]})",
        "A relief object: a knight of six depth maps on a box, searched in one pass; after figure 5.5 of the RTM project report."},
    {"knight-forms", "Knight, three forms", "bricks",
        R"({"relievo":1,"mesh":"object:knight","parameters":{"shadows":false,"background":"gradient","ground":true,"lightYaw":-40},"camera":{"yaw":40,"pitch":25,"fov":35,"fill":0.85},"panes":[{"technique":"object-sides","overrides":{"crossDiscard":false}},{"technique":"object-sides","overrides":{"crossDiscard":true}},{"technique":"object"}]})",
        "The same by sides alone, by sides that discard across each other, and in one pass: the faults of figures 5.2 and 5.5 of the RTM "
        "project report, and their cure."},
    {"dual-depth", "Dual-depth figure", "bricks",
        R"({"relievo":1,"mesh":"object:character@2","parameters":{"shadows":true,"background":"gradient","ground":true,"tint":[0.72,0.66,0.55]},"camera":{"yaw":50,"pitch":12,"fov":35,"fill":0.85},"panes":[{"technique":"object"}]})",
        "A front and a back depth on one polygon: no skins, as figure 13 of Policarpo, Oliveira and Comba 2005. Look at it from behind."},
    {"single-depth", "Single-depth figure", "bricks",
        R"({"relievo":1,"mesh":"object:character@1","parameters":{"shadows":true,"background":"gradient","ground":true,"tint":[0.72,0.66,0.55]},"camera":{"yaw":50,"pitch":12,"fov":35,"fill":0.85},"panes":[{"technique":"object"}]})",
        "The front depth alone: skins down to the back of the box, as the left of that figure. A relief on a box is seen through its sides "
        "too (Policarpo 2004)."},
});

// nameOrFile: a key of kPresets, or a JSON file. Errors: neither.
Expected<StateRead> readPreset(const State& base, const std::string& nameOrFile);

} // namespace relievo
