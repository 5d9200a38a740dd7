// Parallax occlusion mapping: linear search, then one secant step through the last two samples.
// Tatarchuk 2006, Dynamic Parallax Occlusion Mapping with Approximate Soft Shadows.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/secant.glsl"
#include "search/steps.glsl"

Hit trace(Ray ray)
{
    int steps = stepsFor(ray);
    // The height at the surface is read once, for the secant of the first step.
    float gap = max(1.0f - heightOn(ray, 0.0f), 0.0f);
    record(kLinear, 0.0f);
    float outside = 0.0f;
    for (int i = 1; i <= steps; ++i) {
        float t = stepAt(ray, i, steps);
        float next = 1.0f - t - heightOn(ray, t);
        record(kLinear, t);
        if (next <= 0.0f) {
            float found = secantOf(outside, t, gap, next);
            record(kSecant, found);
            return Hit(ray.uv + ray.duv * found, found, true, i + 1);
        }
        outside = t;
        gap = next;
    }
    return Hit(ray.uv + ray.duv * ray.end, ray.end, false, steps + 1);
}
