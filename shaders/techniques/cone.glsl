// Cone step mapping: each step goes to the border of the empty cone that stands on the relief below the ray.
// Dummer 2006, Cone Step Mapping: An Iterative Ray-Heightfield Intersection Algorithm. Its cones know texel centres only, so a step may
// end inside the bilinear surface; such a step is halved.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/bisection.glsl"
#include "search/cone_leap.glsl"

Hit trace(Ray ray)
{
    Hit hit = Hit(ray.uv, 0.0f, true, 0);
    float travel = length(ray.duv);
    float outside = 0.0f;
    for (int i = 0; true; ++i) {
        vec4 bound = boundAt(ray.uv + ray.duv * hit.t);
        ++hit.fetches;
        float above = 1.0f - hit.t - bound.x + bendFrom(hit.t).x;
        recordRead(kCone);
        if (above <= 0.0f)
            return bisected(ray, hit, outside, hit.t, hit.t > 0.0f ? refineSteps : 0);
        if (i >= leapSteps)
            break; // the end of the last leap was still looked at
        float ratio = bound.y * bound.y * boundScale().y;
        outside = hit.t;
        hit.t += coneLeap(above, ratio, travel, bendRise(outside));
        record(kCone, min(hit.t, ray.end));
        if (hit.t >= ray.end) {
            hit.t = ray.end;
            hit.found = endsOnFloor(ray);
            break;
        }
    }
    hit.uv = ray.uv + ray.duv * hit.t;
    return hit;
}
