// The four corners of a cell, texel by texel: for levels and languages without a gather.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

ivec2 wrappedTexel(ivec2 texel, ivec2 size)
{
    if (wrap == 1)
        return clamp(texel, ivec2(0), size - 1);
    // Not by %, which is undefined for negative numbers; the clamp covers the division's rounding.
    return clamp(texel - size * ivec2(floor((vec2(texel) + 0.5f) / vec2(size))), ivec2(0), size - 1);
}

vec4 cornersOf(ivec2 cell, ivec2 size, int level)
{
    ivec2 low = wrappedTexel(cell, size);
    ivec2 high = wrappedTexel(cell + 1, size);
    return vec4(texelFetch(heightMap, low, level).r, texelFetch(heightMap, ivec2(high.x, low.y), level).r,
        texelFetch(heightMap, ivec2(low.x, high.y), level).r, texelFetch(heightMap, high, level).r);
}
