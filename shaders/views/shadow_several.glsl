// View: the shadow alone, of several lights: the share that arrives of all that would without shadows and cones.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 viewColor(Surface surface)
{
    float arriving = 0.0f;
    float all = 0.0f;
    for (int i = 0; i < int(lightCount); ++i) {
        Light light = lightAt(i, surface.point);
        all += light.whole;
        arriving += dot(light.arriving, vec3(1.0f)) * shareArriving(surface, light);
    }
    return vec3(all > 0.0f ? arriving / all : 0.0f);
}
