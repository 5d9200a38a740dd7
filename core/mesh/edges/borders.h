// Where the relief on a mesh ends: open borders and hard edges, near each triangle.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

namespace relievo {

// For each triangle the borders within reach along the surface, nearest first: those of triangle i are
// segments[starts[i]] .. segments[starts[i + 1] - 1]. A segment is (from, to) in the triangle's own mesh UVs, unfolded over UV seams on the
// way, and the surface lies on its left where v points up. No segments at all: `starts` is empty as well.
struct Borders {
    std::vector<std::uint32_t> starts;
    std::vector<glm::vec4> segments;
};

// A border is an edge that edgesAcross joins to none, of a triangle with an area in UV space. reach: UV units; perTriangle: the most
// segments a triangle has; budget: that all have, beyond it the farthest of each triangle are left out.
struct BorderLimits {
    float reach = 0.5f;
    std::uint32_t perTriangle = 24;
    std::size_t budget = std::size_t(1) << 22;
};
Borders bordersOf(const Mesh& mesh, const BorderLimits& limits = {});

} // namespace relievo
