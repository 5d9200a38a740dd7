// A clear coat over sheen over a body that may let light through, with highlights that may be stretched, as glTF's extensions
// KHR_materials_clearcoat, _sheen, _transmission and _anisotropy lay them over each other.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 shone(Surface surface, ShadingPoint point, vec3 toLight)
{
    ShadingPoint body = point;
    body.diffuse *= 1.0f - throughShare();
    vec3 color = bodyReflected(surface, body, toLight) * belowSheen(point, dot(point.normal, toLight)) + sheenReflected(point, toLight);
    return color * (1.0f - coatShare(surface)) + coatReflected(surface, toLight) * coatShare(surface);
}

vec3 shoneAround(Surface surface, ShadingPoint point)
{
    ShadingPoint body = point;
    body.diffuse *= 1.0f - throughShare();
    vec3 color = (bodyAround(surface, body) + lightThrough(surface, point)) * belowSheen(point, point.nv) + sheenAround(point);
    return color * (1.0f - coatShare(surface)) + coatAround(surface) * coatShare(surface);
}
