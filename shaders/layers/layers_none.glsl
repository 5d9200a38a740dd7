// Nothing lies over the shading model.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 shone(Surface surface, ShadingPoint point, vec3 toLight)
{
    return reflected(point, toLight);
}

vec3 shoneAround(Surface surface, ShadingPoint point)
{
    return reflectedSurroundings(point);
}
