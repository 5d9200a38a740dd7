// How high the relief stands around a point of it: the map of horizons (Max 1988, Horizon Mapping: Shadows for Bump-mapped Surfaces), whose
// layers hold four azimuths each, from +u towards +v, as slopes that no depth is in: s / (s + 8) of s heights per tile (kHalfSlope in
// core/maps/surface/horizon.h).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
int azimuthCount()
{
    return 4 * textureSize(horizonMap, 0).z;
}

vec4 horizonTexel(Surface surface, int layer)
{
    return textureLod(horizonMap, vec3(surface.hit.uv, float(layer)), mapLevel(surface.footprint + horizonMapLevels));
}

vec4 slopesOf(vec4 stored)
{
    vec4 share = min(stored, vec4(0.99999f));
    return 8.0f * share / (1.0f - share);
}

// Towards a way in uv, between the two azimuths of the map on either side of it: heights per tile.
float horizonTowards(Surface surface, vec2 way)
{
    int count = azimuthCount();
    float place = atan(way.y, way.x) * (float(count) / 6.2831853f);
    int first = (int(floor(place)) + count) % count;
    int second = (first + 1) % count;
    vec4 before = horizonTexel(surface, first / 4);
    vec4 after = before;
    if (second / 4 != first / 4)
        after = horizonTexel(surface, second / 4);
    return slopesOf(vec4(mix(before[first % 4], after[second % 4], place - floor(place)))).x;
}
