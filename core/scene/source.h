// Opening what the user named, and loading what a State needs: the one way in for the window and the command line.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/environment.h"
#include "core/image/material.h"
#include "core/image/sets/texture_set.h"
#include "core/maps/acceleration/search_texture.h"
#include "core/mesh/animation/pose.h"
#include "core/mesh/mesh.h"
#include "core/state/state.h"
#include "core/state/techniques.h"
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

namespace relievo {

struct SeenDistances; // core/trace/displaced_mesh.h

// The large data behind a State. Cheap to copy; members are never null after loadResources, but `seen`.
struct Resources {
    std::shared_ptr<const Material> material;
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const Environment> environment;
    // Bound maps of the techniques in use, by row of kMaps and wrap, and what they were made from.
    struct Bound {
        std::shared_ptr<const SearchTexture> texture;
        std::shared_ptr<const void> heights; // HeightField::identity
        bool allLevels = false;
    };
    using BoundKey = std::pair<std::string, Wrap>; // two panes may wrap differently
    std::map<BoundKey, Bound> bounds;
    // Of the picture about to be drawn, for the error view on a mesh; null: that view measures the search alone.
    std::shared_ptr<const SeenDistances> seen;
    // What the State named when these were loaded: decides what must be loaded again.
    std::string meshName, environmentName;
};

// SOURCE (resources/help/command-line.md, "Sources"): "*.relievo", a folder, an image of a set, a single image, "sample:KEY", "scene:KEY"
// (presets.h), "hard:KEY" (hard_cases.h) or a mesh file that brings textures. The result is `base` with the maps (and for a project
// everything) replaced. A sample also sets its depth.
struct Opened {
    State state;
    DecodedImages images; // spares loadResources a second decode
    Warnings warnings;
    bool bringsValues = false; // parameters and technique of the State are the file's too, not only the maps
};
Expected<Opened> openSource(const std::string& source, const State& base, const Progress& progress = {});

// Whether SOURCE names something made by formula: there is no file behind it.
bool isBuiltInSource(std::string_view source);

// The pose that `clip` and `time` name; the animation repeats.
Pose poseOf(const Mesh& mesh, const Parameters& parameters);

// The wrap mode that the parameter `wrap` stands for.
Wrap wrapOf(const Parameters& parameters);

// Under which the bound map of `technique` stands in Resources::bounds.
Resources::BoundKey boundKey(const TechniqueRow& technique, const Parameters& parameters);
// The bound map of `technique`, when it fits the height map and the parameters; else nullptr: such a map is made anew, never used.
// Techniques without one: nullptr too.
std::shared_ptr<const SearchTexture> boundFor(const Resources& resources, const TechniqueRow& technique, const Parameters& parameters);
// Makes it and adds it to resources.bounds, when it is wanted and not there.
Expected<void> makeBound(Resources& resources, const TechniqueRow& technique, const Parameters& parameters, const Progress& progress = {});
// Those that the panes' techniques search with and that are not there; none without a height map.
std::set<Resources::BoundKey> missingBounds(const State& state, const Resources& resources);

// Whether `file` is a mesh by its suffix (gltf glb obj ply stl off), for drag and drop and `info`.
bool isMeshFile(const std::filesystem::path& file);
bool isProjectFile(const std::filesystem::path& file);

// Loads what changed against `previous` (which may be empty). A mesh or environment that cannot be read is an error; missing maps
// are warnings in the material. Cancelled: error with what == "cancelled".
Expected<Resources> loadResources(
    const State& state, const DecodedImages& images, const Resources& previous, const Progress& progress = {});

} // namespace relievo
