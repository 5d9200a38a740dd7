// The search ray behind a point of a picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/scene/resources.h"
#include "core/trace/ray.h"
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

namespace relievo {

// At full resolution (a picture with heightMips reads coarser heights far away), as shaders/surface/surface.glsl makes it where the eye's
// ray meets the mesh: at the frame between the corners of the first triangle hit.
struct PickedRay {
    SearchRay ray; // straight: where `bends`, the picture's own ray follows the surface
    double depth = 0.; // D there, m
    double distance = 0.; // from the eye to where it meets the mesh, m
    bool isPlain = false; // a part without relief: nothing is searched
    bool bends = false; // the pane's silhouettes bend the ray, or cut it into prisms
};
// at: share of the pane's picture from its upper left corner, in [0, 1]; aspect: width / height of it. Nothing where no mesh is.
std::optional<PickedRay> pickedRay(const State& state, std::size_t pane, const Resources& resources, glm::vec2 at, float aspect);

// Those at the middles of the pixels of a grid over the picture, row by row from the top; each triangle is looked at once, so that many of
// both cost little.
std::vector<std::optional<PickedRay>> pickedRays(
    const State& state, std::size_t pane, const Resources& resources, glm::ivec2 grid, float aspect, const Progress& progress = {});

} // namespace relievo
