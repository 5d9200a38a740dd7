// Cone maps in two pictures of 8 bits, their upper and their lower bytes, interpolated here.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec4 boundOfTexel(ivec2 texel)
{
    return (floor(texelFetch(boundHighMap, texel, 0) * 255.0f + 0.5f) * 256.0f + floor(texelFetch(boundLowMap, texel, 0) * 255.0f + 0.5f)) / 65535.0f;
}

vec4 boundAt(vec2 uv)
{
    ivec2 size = textureSize(boundHighMap, 0);
    vec2 p = uv * vec2(size) - 0.5f;
    p = vec2(abs(p.x) < 1e30f ? p.x : 0.0f, abs(p.y) < 1e30f ? p.y : 0.0f);
    vec2 f = p - floor(p);
    ivec2 low = wrappedTexel(ivec2(floor(p)), size);
    ivec2 high = wrappedTexel(ivec2(floor(p)) + 1, size);
    vec4 top = boundOfTexel(low) * (1.0f - f.x) + boundOfTexel(ivec2(high.x, low.y)) * f.x;
    vec4 bottom = boundOfTexel(ivec2(low.x, high.y)) * (1.0f - f.x) + boundOfTexel(high) * f.x;
    return top * (1.0f - f.y) + bottom * f.y;
}
