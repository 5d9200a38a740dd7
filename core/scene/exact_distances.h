// The exact answer for one picture: how far the displaced mesh is at each pixel, and what exactly that was asked for.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/scene/resources.h"
#include "core/trace/displaced_mesh.h"
#include <memory>
#include <string>

namespace relievo {

// All that the answer depends on: whoever changes colours, techniques or ranges keeps it.
struct ExactQuestion {
    Camera camera;
    int width = 0, height = 0; // pixels
    std::string part; // State::part
    Parameters parameters; // those that affect the exact answer, the others by default
    std::shared_ptr<const void> heights, mesh; // what the data are, not compared
    bool operator==(const ExactQuestion&) const = default;
};
ExactQuestion exactQuestion(const State& state, std::size_t pane, const Resources& resources, int width, int height);

struct ExactDistances {
    ExactQuestion question;
    PixelDistances pixels;
};

// Whether the displaced mesh answers better than a search in the plane: for every mesh but the built-in plane. Needs a height map. Of a
// relief object it is the mesh that it stands for, as it is.
bool hasMeshReference(const State& state, const Resources& resources);

// What the pane's camera sees of the displaced mesh, in a picture of that size.
// coarse: told when the micro-triangles are larger than wanted. Errors: no height map, no memory, cancelled.
Expected<std::shared_ptr<const ExactDistances>> exactDistances(const State& state, std::size_t pane, const Resources& resources, int width,
    int height, Warnings& coarse, const Progress& progress = {});

// The same, made finer until its own error hardly matters or it takes too much memory; PixelDistances::uncertain says what is left of it.
Expected<std::shared_ptr<const ExactDistances>> sureDistances(const State& state, std::size_t pane, const Resources& resources, int width,
    int height, Warnings& coarse, const Progress& progress = {});

} // namespace relievo
