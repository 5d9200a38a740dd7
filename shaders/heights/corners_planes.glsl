// The four corners of a cell, texel by texel, of heights that lie in red and green as upper and lower byte: pictures of 8 bits hold all 16, and
// are read exactly wherever no 16-bit or float textures are at hand (WebGL2, Godot).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float heightOfTexel(ivec2 texel)
{
    vec4 bytes = floor(texelFetch(heightMap, texel, 0) * 255.0f + 0.5f);
    return (bytes.r * 256.0f + bytes.g) / 65535.0f;
}

vec4 cornersAt(vec2 cell)
{
    ivec2 size = ivec2(searchSize());
    ivec2 low = wrappedTexel(ivec2(cell), size);
    ivec2 high = wrappedTexel(ivec2(cell) + 1, size);
    return vec4(heightOfTexel(low), heightOfTexel(ivec2(high.x, low.y)), heightOfTexel(ivec2(low.x, high.y)), heightOfTexel(high));
}
