// The search rays of what a pane shows, so that techniques are measured on this mesh and from this side.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/analysis/sweep.h"
#include "core/scene/resources.h"
#include <glm/vec2.hpp>
#include <vector>

namespace relievo {

struct ViewGrid {
    glm::ivec2 pixels{64, 40}; // one ray each
    int height = 600; // of the picture that errors are told for, pixels
    float aspect = 1.6f; // width / height of it
    bool operator==(const ViewGrid&) const = default;
};

// From where white lies, which is where techniques that displace begin, through the pane's camera; at full resolution, straight. Parts
// without relief and the background have no rays: there may be none at all, also when cancelled.
RaySet viewRays(const State& state, std::size_t pane, const Resources& resources, const ViewGrid& grid, const Progress& progress = {});

// The first of heightLevels that has at most `side` texels a side.
HeightField reducedTo(const HeightField& field, int side);

} // namespace relievo
