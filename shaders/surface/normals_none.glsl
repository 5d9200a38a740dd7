// No normal map and no height map: the smooth surface.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 reliefNormal(Surface surface)
{
    return surface.frame.normal;
}
