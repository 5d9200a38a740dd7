// Codes of cell cones in two pictures of 8 bits: their upper and their lower bytes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "bounds/bounds_scale.glsl"

uvec4 cellCodes(ivec2 node)
{
    return uvec4(floor(texelFetch(boundHighMap, node, 0) * 255.0f + 0.5f)) * 256u + uvec4(floor(texelFetch(boundLowMap, node, 0) * 255.0f + 0.5f));
}
