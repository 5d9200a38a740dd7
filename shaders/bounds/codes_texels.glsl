// Codes of cell cones, read texel by texel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "bounds/bounds_scale.glsl"

uvec4 cellCodes(ivec2 node)
{
    return texelFetch(cellMap, node, searchLevel());
}
