// Contact refinement: linear search; the step that went inside is searched once more by as many, as much smaller steps.
// Riccardi 2019, Contact Refinement Parallax Mapping. The first small step inside is the answer.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/steps.glsl"

Hit trace(Ray ray)
{
    int steps = stepsFor(ray);
    float from = 0.0f;
    float span = ray.end; // of what is searched
    float inside = ray.end;
    bool found = false;
    int fetches = 0;
    for (int i = 1; i <= steps; ++i) {
        float t = from + span * (float(i) / float(steps));
        float height = heightOn(ray, t);
        ++fetches;
        record(kLinear, t);
        if (1.0f - height > t)
            continue;
        inside = t;
        if (found)
            break;
        found = true;
        span = ray.end / float(steps);
        from = max(t - span, 0.0f);
        i = 0;
    }
    return Hit(ray.uv + ray.duv * inside, inside, found, fetches);
}
