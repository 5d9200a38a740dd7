// Steep parallax mapping: linear search, the first sample inside the relief is the answer.
// McGuire and McGuire 2005, Steep Parallax Mapping.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/steps.glsl"

Hit trace(Ray ray)
{
    int steps = stepsFor(ray);
    for (int i = 1; i <= steps; ++i) {
        float t = stepAt(ray, i, steps);
        float height = heightOn(ray, t);
        record(kLinear, t);
        if (1.0f - height <= t)
            return Hit(ray.uv + ray.duv * t, t, true, i);
    }
    return Hit(ray.uv + ray.duv * ray.end, ray.end, false, steps);
}
