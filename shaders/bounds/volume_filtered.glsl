// The distance volume by the texture unit's filter. It is coarse already: one level serves all.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 volumeVoxels()
{
    return vec3(textureSize(distanceMap, 0));
}

float distanceAt(vec3 p)
{
    return textureLod(distanceMap, p, 0.0f).r;
}
