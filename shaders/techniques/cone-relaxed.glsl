// Relaxed cone stepping: cones that a ray may enter the relief in but not leave it, then bisection.
// Policarpo and Oliveira 2007, GPU Gems 3, chapter 18, listing 18-3. As printed: a fixed number of cone steps, then halvings of all
// the way from the surface, whether the ray is inside or not; rays that were still outside stop short and thin relief before the last
// step can be lost. lastBracket: halve the last step only, and only when it went inside.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/bisection.glsl"
#include "search/cone_leap.glsl"

Hit trace(Ray ray)
{
    Hit hit = Hit(ray.uv, 0.0f, true, 0);
    float travel = length(ray.duv);
    float outside = 0.0f;
    for (int i = 0; i < leapSteps || lastBracket; ++i) {
        vec4 bound = boundAt(ray.uv + ray.duv * hit.t);
        ++hit.fetches;
        float above = clamp(1.0f - hit.t - bound.x + bendFrom(hit.t).x, 0.0f, 1.0f);
        recordRead(kCone);
        if (lastBracket && above <= 0.0f)
            return bisected(ray, hit, outside, hit.t, hit.t > 0.0f ? refineSteps : 0);
        if (lastBracket && (i >= leapSteps || hit.t >= ray.end))
            break; // after the last leap its end is still looked at
        float ratio = bound.y * bound.y * boundScale().y;
        outside = hit.t;
        hit.t = min(ray.end, hit.t + coneLeap(above, ratio, travel, bendRise(outside)));
        record(kCone, hit.t);
    }
    hit.found = endsOnFloor(ray) || hit.t < ray.end;
    hit.uv = ray.uv + ray.duv * hit.t;
    if (lastBracket)
        return hit;

    float all = hit.t;
    float range = 0.5f * all;
    float t = range;
    for (int i = 0; i < refineSteps; ++i) {
        float at = t;
        ++hit.fetches;
        range *= 0.5f;
        t += at < 1.0f - heightOn(ray, at) ? range : -range;
        recordHalving(t - range, t + range, at);
    }
    hit.t = t;
    hit.found = hit.found || t < all - 2.0f * range; // else no halving was inside
    hit.uv = ray.uv + ray.duv * t;
    return hit;
}
