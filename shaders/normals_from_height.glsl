// Tangent-space normals from the height map's slopes, which lie in a texture of their own so that they have mip levels.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 tangentNormalAt(vec2 uv, float footprint)
{
    vec2 slope = textureLod(slopeMap, uv, max(0.0f, footprint + slopeMapLevels)).rg;
    // depth is a share of the tile's width, so slopes are rises per travel on a square tile; up in the image is -v.
    return normalize(vec3(-depth * slope.x, depth * slope.y, 1.0f));
}
