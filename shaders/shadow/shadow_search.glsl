// Self-shadow: the same search, sent from the light down to the depth of the point seen and no further (Policarpo, Oliveira, Comba 2005,
// section 3, figure 10).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool lightIsHidden(Surface surface, vec3 toLight)
{
    if (dot(surface.frame.normal, toLight) <= 0.0f)
        return true; // it comes from behind the surface
    Ray ray = lightRay(surface, toLight);
    LightEnd end = endBeforePoint(LightWay(ray, 1.0f, true, 0.0f));
    ray.end = end.end;
    return !end.faces || (ray.end > 0.0f && trace(ray).found);
}
