// Self-shadow: the same search, sent from the light down to the depth of the point seen and no further (Policarpo, Oliveira, Comba 2005,
// section 3, figure 10). shadowSlack() is what an occluder must lie above the point by.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool lightIsHidden(Surface surface, vec3 toLight)
{
    Ray ray = lightRay(surface, toLight);
    ray.end -= shadowSlack(ray);
    return ray.end > 0.0f && trace(ray).found;
}
