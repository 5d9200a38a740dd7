// Acceleration maps of the finest level, interpolated here: the same numbers on every machine.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec4 boundAt(vec2 uv)
{
    ivec2 size = textureSize(boundMap, 0);
    vec2 p = uv * vec2(size) - 0.5f;
    p = vec2(abs(p.x) < 1e30f ? p.x : 0.0f, abs(p.y) < 1e30f ? p.y : 0.0f);
    vec2 f = p - floor(p);
    ivec2 low = wrappedTexel(ivec2(floor(p)), size);
    ivec2 high = wrappedTexel(ivec2(floor(p)) + 1, size);
    vec4 a = storedExactly(texelFetch(boundMap, low, 0), boundUnits);
    vec4 b = storedExactly(texelFetch(boundMap, ivec2(high.x, low.y), 0), boundUnits);
    vec4 c = storedExactly(texelFetch(boundMap, ivec2(low.x, high.y), 0), boundUnits);
    vec4 d = storedExactly(texelFetch(boundMap, high, 0), boundUnits);
    vec4 top = a * (1.0f - f.x) + b * f.x;
    vec4 bottom = c * (1.0f - f.x) + d * f.x;
    return top * (1.0f - f.y) + bottom * f.y;
}
