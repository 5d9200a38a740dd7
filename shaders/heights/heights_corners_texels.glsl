// The four corners of a cell of any level, texel by texel: a gather reads the finest level only, and GLSL ES 3.00 has none.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec4 cornersAt(vec2 cell)
{
    ivec2 size = ivec2(searchSize());
    ivec2 low = wrappedTexel(ivec2(cell), size);
    ivec2 high = wrappedTexel(ivec2(cell) + 1, size);
    return vec4(texelFetch(heightMap, low, searchLevel()).r, texelFetch(heightMap, ivec2(high.x, low.y), searchLevel()).r,
        texelFetch(heightMap, ivec2(low.x, high.y), searchLevel()).r, texelFetch(heightMap, high, searchLevel()).r);
}
