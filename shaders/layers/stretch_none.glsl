// Highlights of the body are as wide in all directions.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 bodyReflected(Surface surface, ShadingPoint point, vec3 toLight)
{
    return reflected(point, toLight);
}

vec3 bodyAround(Surface surface, ShadingPoint point)
{
    return reflectedSurroundings(point);
}
