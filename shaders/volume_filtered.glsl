// The distance volume by the texture unit's filter. It is coarse already: one level serves all.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float distanceAt(vec3 p)
{
    return textureLod(distanceMap, p, 0.0f).r;
}
