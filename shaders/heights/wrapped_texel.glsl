// A texel index brought into the map by the wrap mode.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

ivec2 wrappedTexel(ivec2 texel, ivec2 size)
{
    if (clamped())
        return clamp(texel, ivec2(0), size - 1);
    // Not by %, which is undefined for negative numbers; the clamp covers the division's rounding.
    return clamp(texel - size * ivec2(floor((vec2(texel) + 0.5f) / vec2(size))), ivec2(0), size - 1);
}
