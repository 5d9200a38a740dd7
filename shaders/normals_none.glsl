// No normal map and no height map: the smooth surface.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 tangentNormalAt(vec2 uv, float footprint)
{
    return vec3(0.0f, 0.0f, 1.0f);
}
