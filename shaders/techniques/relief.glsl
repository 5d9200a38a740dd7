// Relief mapping: linear search for the first sample inside the relief, then bisection of that step.
// Policarpo, Oliveira, Comba 2005, Real-Time Relief Mapping on Arbitrary Polygonal Surfaces, section 3. The step count follows
// the angle as there ("delta varies from fragment to fragment as function of the angle between VD' and the normal").
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/bisection.glsl"
#include "search/steps.glsl"

Hit trace(Ray ray)
{
    Hit hit = Hit(ray.uv + ray.duv * ray.end, ray.end, false, 0);
    int steps = stepsFor(ray);
    float outside = 0.0f;
    for (int i = 1; i <= steps; ++i) {
        float t = stepAt(ray, i, steps);
        float height = heightOn(ray, t);
        ++hit.fetches;
        record(kLinear, t);
        if (1.0f - height <= t) {
            hit.found = true;
            return bisected(ray, hit, outside, t, refineSteps);
        }
        outside = t;
    }
    return hit;
}
