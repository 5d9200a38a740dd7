// How far a picture of relief on a mesh is from the displaced mesh itself: outline and depth. Pixels that see backs do not count.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/trace/displaced_mesh.h"
#include "render/windowless.h"

namespace relievo {

struct MeshErrors {
    double coverage = 0.; // pixels that only one of the two covers, share of those that either covers
    double depthRmse = 0.; // of the distance along the ray where both cover, in pixels' sizes there
    double invalid = 0.; // pixels of the picture that are not finite
};

// The State's first pane with its own camera. Full resolution, mip levels off. Needs a current context and a height map.
Expected<MeshErrors> meshErrors(
    Renderer& renderer, const State& state, const Resources& resources, const std::vector<float>& exact, int width, int height);

// Metres from the eye at each pixel of that picture, from the displaced mesh; infinity where there is nothing, NaN at backs (distancesSeen).
Expected<std::vector<float>> exactDistances(
    const State& state, const Resources& resources, int width, int height, Warnings& warnings, const Progress& progress = {});

} // namespace relievo
