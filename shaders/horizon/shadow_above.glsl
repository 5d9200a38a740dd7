// Self-shadow without a search: a light is seen where it stands above the horizon.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "horizon/horizons.glsl"

// Share of a light's disc (radius: at distance 1) above the horizon, which is taken for level where the disc is.
float shareAbove(Surface surface, vec3 toLight, float radius)
{
    float rise = dot(surface.frame.normal, toLight);
    vec2 along = vec2(dot(toLight, surface.frame.gradU), dot(toLight, surface.frame.gradV)); // uv per m
    float reach = length(along);
    if (!(reach > 1e-12f))
        return rise > 0.0f ? 1.0f : 0.0f;
    float least = horizonTowards(surface, along / reach) * surface.depth * reach; // rise of what just passes the relief
    if (radius <= 0.0f)
        return rise > least ? 1.0f : 0.0f;
    float level = sqrt(max(1.0f - rise * rise, 1e-12f));
    float above = clamp((atan(rise, level) - atan(least, level)) / radius, -1.0f, 1.0f); // of the disc's middle
    return 0.5f + (above * sqrt(1.0f - above * above) + asin(above)) / 3.14159265f;
}
