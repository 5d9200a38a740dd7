// Self-shadow of a relief object: the same search, from the point seen to the border of the box on its way to the light.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool lightIsHidden(Surface surface, vec3 toLight)
{
    if (dot(surface.frame.normal, toLight) <= 0.0f)
        return true; // it comes from behind the surface
    // Off the surface by more than a texel, which is as high as the walls between texels stand out of it.
    ivec4 map = objectAxes[seenSide / 2];
    float texel = max(1.0f / (length(surface.frame.gradU) * float(map.x)), 1.0f / (length(surface.frame.gradV) * float(map.y)));
    vec3 start = boxPlace(surface.point + surface.frame.normal * (1.25f * texel));
    vec3 way = boxWay(toLight);
    vec3 border = borderAlong(start, way);
    float end = min(border.x, min(border.y, border.z));
    return end > 0.0f && traceObject(ObjectRay(start, way, 0.0f, end)).found;
}
