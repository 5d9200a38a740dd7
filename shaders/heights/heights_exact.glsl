// Heights of the full-resolution map, interpolated here from the four corners: the same numbers on every machine.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float heightAt(vec2 uv)
{
    vec2 p = uv * vec2(textureSize(heightMap, 0)) - 0.5f;
    p = vec2(abs(p.x) < 1e30f ? p.x : 0.0f, abs(p.y) < 1e30f ? p.y : 0.0f);
    vec2 cell = floor(p);
    vec2 f = p - cell;
    vec4 h = storedExactly(cornersAt(cell), heightUnits);
    float top = h.x * (1.0f - f.x) + h.y * f.x;
    float bottom = h.z * (1.0f - f.x) + h.w * f.x;
    return top * (1.0f - f.y) + bottom * f.y;
}
