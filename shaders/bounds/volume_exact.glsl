// The distance volume, interpolated here: the same numbers on every machine.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 volumeVoxels()
{
    return vec3(textureSize(distanceMap, 0));
}

float distanceSlice(ivec2 low, ivec2 high, vec2 f, int slice)
{
    float a = texelFetch(distanceMap, ivec3(low.x, low.y, slice), 0).r;
    float b = texelFetch(distanceMap, ivec3(high.x, low.y, slice), 0).r;
    float c = texelFetch(distanceMap, ivec3(low.x, high.y, slice), 0).r;
    float d = texelFetch(distanceMap, ivec3(high.x, high.y, slice), 0).r;
    return (a * (1.0f - f.x) + b * f.x) * (1.0f - f.y) + (c * (1.0f - f.x) + d * f.x) * f.y;
}

float distanceAt(vec3 at)
{
    ivec3 size = textureSize(distanceMap, 0);
    vec2 p = vec2(at.x, at.y) * vec2(float(size.x), float(size.y)) - 0.5f;
    p = vec2(abs(p.x) < 1e30f ? p.x : 0.0f, abs(p.y) < 1e30f ? p.y : 0.0f);
    vec2 f = p - floor(p);
    ivec2 across = ivec2(size.x, size.y);
    ivec2 low = wrappedTexel(ivec2(floor(p)), across);
    ivec2 high = wrappedTexel(ivec2(floor(p)) + 1, across);
    float depth = clamp(at.z * float(size.z) - 0.5f, 0.0f, float(size.z - 1));
    int slice = int(depth);
    float above = distanceSlice(low, high, f, slice);
    float below = distanceSlice(low, high, f, min(slice + 1, size.z - 1));
    return above + (below - above) * (depth - float(slice));
}
