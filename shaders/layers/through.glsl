// Light that goes through: the surroundings as seen by Snell's law, taken up on the way from the point to the relief's floor (Beer and Lambert),
// so that a way of one relief depth leaves the base colour.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float throughShare()
{
    return transmission;
}

vec3 lightThrough(Surface surface, ShadingPoint point)
{
    vec3 inside = refract(-point.toEye, point.normal, 1.0f / ior);
    float way = clamp(1.0f - surface.hit.t, 0.0f, 1.0f) / max(abs(dot(inside, surface.frame.normal)), 0.05f);
    vec3 left = pow(max(point.diffuse, vec3(1e-4f)), vec3(way));
    return reflection(inside, point.rough * clamp(2.0f * ior - 2.0f, 0.0f, 1.0f)) * left * transmission;
}
