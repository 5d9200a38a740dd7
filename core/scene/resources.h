// The large data behind a State, and loading what it needs: the one way for the window and the command line.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include "core/image/environment/environment.h"
#include "core/image/material.h"
#include "core/image/sets/texture_set.h"
#include "core/mesh/animation/pose.h"
#include "core/mesh/mesh.h"
#include "core/scene/acceleration_maps.h"
#include "core/state/state.h"
#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace relievo {

// How deep the relief may be: of the mesh and of the heights.
struct ReliefFit {
    float room = std::numeric_limits<float>::infinity(); // reliefRoom of the mesh, m
    float lowest = 0.f; // height of the material, in [0, 1]
    std::shared_ptr<const void> mesh, heights; // that these are of; none without a height map
};

// Cheap to copy; material, mesh and environment are never null after loadResources.
struct Resources {
    std::shared_ptr<const Material> material;
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const Environment> environment;
    AccelerationMaps accelerationMaps; // of the techniques in use
    ReliefFit fit;
    // What the State named when these were loaded: decides what must be loaded again.
    std::string meshName, environmentName;
};

// Loads what changed against `previous` (which may be empty), the acceleration maps of all panes included. A mesh or environment that
// cannot be read is an error; missing maps are warnings in the material. Cancelled: an error of that code.
Expected<Resources> loadResources(
    const State& state, const DecodedImages& images, const Resources& previous, const Progress& progress = {});

// The largest `depth` parameter at which the relief fits the mesh; infinity when any does. metresPerUV: Mesh's.
float fittingDepth(const Parameters& parameters, float metresPerUV, const ReliefFit& fit);
// "relief-too-deep": where a pane's relief is deeper than the mesh is thick, and what depth fits.
std::optional<Warning> tooDeep(const State& state, const Resources& resources);

// The pose that `clip` and `time` name; the animation repeats.
Pose poseOf(const Mesh& mesh, const Parameters& parameters);

} // namespace relievo
