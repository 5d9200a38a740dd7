// Tangent-space normals from the height map by central differences over one texel of the level shown.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 tangentNormalAt(vec2 uv, float footprint)
{
    float level = max(0.0f, footprint + heightMapLevels);
    vec2 texel = exp2(level) / vec2(textureSize(heightMap, 0));
    float dhdu = textureLod(heightMap, uv + vec2(texel.x, 0.0f), level).r - textureLod(heightMap, uv - vec2(texel.x, 0.0f), level).r;
    float dhdv = textureLod(heightMap, uv + vec2(0.0f, texel.y), level).r - textureLod(heightMap, uv - vec2(0.0f, texel.y), level).r;
    // depth is a share of the tile's width, so slopes are rises per travel on a square tile; up in the image is -v.
    return normalize(vec3(-depth * dhdu / (2.0f * texel.x), depth * dhdv / (2.0f * texel.y), 1.0f));
}
