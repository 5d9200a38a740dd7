// How far a picture of relief on a mesh is from the displaced mesh itself: outline and depth. Pixels that see backs do not count.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/report.h"
#include "core/scene/exact_distances.h"
#include "render/windowless.h"

namespace relievo {

// The State's first pane with its own camera. Full resolution, mip levels off. Needs a current context and a height map.
Expected<MeshRow> meshErrors(
    Renderer& renderer, const State& state, Resources& resources, const std::shared_ptr<const ExactDistances>& exact);

// Outline, depth and cost of what the group "On the mesh" and shadows change, one at a time, from the State with all of them off, searched
// by cell-cone in five views around the mesh. timed: also the times of frames.
Expected<MeshSection> measureOnMesh(Renderer& renderer, const State& state, Resources& resources, int width, int height, bool timed,
    Warnings& coarse, const Progress& progress = {});

// The same for silhouettes by prisms alone.
Expected<MeshRow> measurePrisms(
    Renderer& renderer, const State& state, Resources& resources, int width, int height, Warnings& coarse, const Progress& progress = {});

} // namespace relievo
