// Up to four lights, directional or near.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 reflectedLights(Surface surface, ShadingPoint point)
{
    vec3 sum = vec3(0.0f);
    for (int i = 0; i < int(lightCount); ++i) {
        Light light = lightAt(i, surface.point);
        bool arrives = max(max(light.arriving.r, light.arriving.g), light.arriving.b) > 0.0f;
        if (arrives && dot(point.normal, light.toLight) > 0.0f)
            sum += shone(surface, point, light.toLight) * light.arriving * shareArriving(surface, light);
    }
    return sum;
}
