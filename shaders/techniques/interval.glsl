// Interval mapping: linear search, then secant steps that keep the half with the change of sign.
// Risser, Shah, Pattanaik 2007, Faster Relief Mapping Using the Secant Method, Journal of Graphics Tools 12(3).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/secant.glsl"
#include "search/steps.glsl"

Hit trace(Ray ray)
{
    Hit hit = Hit(ray.uv + ray.duv * ray.end, ray.end, false, 1);
    int steps = stepsFor(ray);
    float outside = 0.0f;
    float inside = ray.end;
    float gapOutside = max(1.0f - heightOn(ray, 0.0f), 0.0f);
    record(kLinear, 0.0f);
    float gapInside = 0.0f;
    for (int i = 1; i <= steps && !hit.found; ++i) {
        float t = stepAt(ray, i, steps);
        float gap = 1.0f - t - heightOn(ray, t);
        ++hit.fetches;
        record(kLinear, t);
        if (gap <= 0.0f) {
            hit.found = true;
            inside = t;
            gapInside = gap;
        } else {
            outside = t;
            gapOutside = gap;
        }
    }
    if (!hit.found)
        return hit;
    hit.t = secantOf(outside, inside, gapOutside, gapInside);
    for (int i = 0; i < refineSteps; ++i) {
        float gap = 1.0f - hit.t - heightOn(ray, hit.t);
        ++hit.fetches;
        record(kSecant, hit.t);
        if (gap <= 0.0f) {
            inside = hit.t;
            gapInside = gap;
        } else {
            outside = hit.t;
            gapOutside = gap;
        }
        hit.t = secantOf(outside, inside, gapOutside, gapInside);
    }
    record(kSecant, hit.t);
    hit.uv = ray.uv + ray.duv * hit.t;
    return hit;
}
