// How far a picture of relief on a mesh is from the displaced mesh itself: outline and depth. Pixels that see backs do not count.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/report.h"
#include "core/trace/displaced_mesh.h"
#include "render/windowless.h"

namespace relievo {

// Whether the displaced mesh answers better than a search in the plane: for every mesh but the built-in plane. Needs a height map.
bool hasMeshReference(const State& state, const Resources& resources);

// What the pane's own camera sees of the displaced mesh, in a picture of that size. Needs no context.
// coarse: told when the micro-triangles are larger than wanted.
Expected<SeenDistances> exactDistances(const State& state, std::size_t pane, const Resources& resources, int width, int height,
    Warnings& coarse, const Progress& progress = {});

// The State's first pane with its own camera. Full resolution, mip levels off. Needs a current context and a height map.
Expected<MeshRow> meshErrors(Renderer& renderer, const State& state, const Resources& resources, const SeenDistances& exact);

// Outline, depth and cost of what the group "On the mesh" and shadows change, one at a time, from the State with all of them off, searched
// by cell-cone in five views around the mesh. timed: also the times of frames.
Expected<MeshSection> measureOnMesh(Renderer& renderer, const State& state, const Resources& resources, int width, int height, bool timed,
    Warnings& coarse, const Progress& progress = {});

} // namespace relievo
