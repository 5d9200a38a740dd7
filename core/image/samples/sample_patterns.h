// The formulas of the built-in samples: what lies at one point of the tile.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace relievo::pattern {

struct Point {
    float height; // any range: the sample is stretched to [0, 1]
    glm::vec3 color; // sRGB encoded, [0, 1]
    float roughness; // [0, 1]
    float metallic = 0.f; // [0, 1]
};

// All periodic over uv in [0, 1]^2, and smooth from texel to texel at 1024.
Point bricks(glm::vec2 uv);
Point cobblestones(glm::vec2 uv);
Point planks(glm::vec2 uv);
Point scales(glm::vec2 uv);
Point hammered(glm::vec2 uv);
Point terrain(glm::vec2 uv); // height only: its colour follows from the slopes, by terrainColor

// height in [0, 1]; slope: rise of the height over one tile's width.
Point terrainColor(glm::vec2 uv, float height, float slope);

} // namespace relievo::pattern
