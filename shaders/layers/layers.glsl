// A clear coat over sheen over a body that may let light through, as glTF's extensions KHR_materials_clearcoat, _sheen and _transmission lay
// them over each other.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 shone(Surface surface, ShadingPoint point, vec3 toLight)
{
    ShadingPoint body = point;
    body.diffuse *= 1.0f - throughShare();
    vec3 color = reflected(body, toLight) * belowSheen(point, dot(point.normal, toLight)) + sheenReflected(point, toLight);
    return color * (1.0f - coatShare(surface)) + coatReflected(surface, toLight) * coatShare(surface);
}

vec3 shoneAround(Surface surface, ShadingPoint point)
{
    ShadingPoint body = point;
    body.diffuse *= 1.0f - throughShare();
    vec3 color = (reflectedSurroundings(body) + lightThrough(surface, point)) * belowSheen(point, point.nv) + sheenAround(point);
    return color * (1.0f - coatShare(surface)) + coatAround(surface) * coatShare(surface);
}
