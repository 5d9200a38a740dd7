// Nodes of a pyramid, read texel by texel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "bounds/bounds_scale.glsl"

ivec2 boundSize()
{
    return textureSize(heightMap, 0);
}
float boundTexel(ivec2 texel)
{
    return texelFetch(boundMap, texel, 0).r;
}
