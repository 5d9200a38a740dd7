// Nodes of a pyramid in two pictures of 8 bits, their upper and their lower bytes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "bounds/bounds_scale.glsl"

ivec2 boundSize()
{
    return textureSize(heightMap, 0);
}
float boundTexel(ivec2 texel)
{
    float high = floor(texelFetch(boundHighMap, texel, 0).r * 255.0f + 0.5f);
    return (high * 256.0f + floor(texelFetch(boundLowMap, texel, 0).r * 255.0f + 0.5f)) / 65535.0f;
}
