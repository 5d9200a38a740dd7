// The relief's normal where the search landed, in world space, from the height map's slopes, which lie in a texture of their own so
// that they have mip levels. The gradient of the displaced surface N - D (dh/du gradU + dh/dv gradV): right for any depth, stretch
// and skew.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 reliefNormal(Surface surface)
{
    vec2 slope = textureLod(slopeMap, surface.hit.uv, mapLevel(surface.footprint + slopeMapLevels)).rg;
    return normalize(surface.frame.normal
        - (surface.frame.gradU * slope.x + surface.frame.gradV * slope.y) * (reliefDepth * normalStrength));
}
