// Normals from a height field.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/progress.h"
#include "core/image/height_field.h"
#include "core/image/image.h"
#include <glm/vec2.hpp>
#include <vector>

namespace relievo {

// Slopes of the height map: dh/du and dh/dv per tile, interleaved, width * height pairs. Central differences of the bilinear surface
// over one texel to each side, under the field's wrap mode.
std::vector<glm::vec2> slopesOf(const HeightField& field);

// Tangent-space normal map of the same size: 3 channels U16, n / 2 + 1/2, OpenGL style (green up the image).
// depthInTiles: black-to-white distance as a share of the tile's width (the parameter `depth`). From slopesOf; the tile counts as
// square whatever its size in texels.
// Stops early when cancelled (the rest is flat).
Image normalFromHeight(const HeightField& field, float depthInTiles, const Progress& progress = {});
// The same as F32.
Image normalsOf(const HeightField& field, float depthInTiles, const Progress& progress = {});

} // namespace relievo
