// Robust cone step mapping: relaxed cones of 3 x 3 texels, and never less than a step to the border of the bilinear cell.
// Ban, Valasek, Balint, Vad 2024, Robust Cone Step Mapping (EGSR). provenStep: measures the ray by |du| + |dv| instead of its length,
// by which cones of texels that nothing rises above bound the bilinear surface between them too; relaxed cones it only makes safer.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/bisection.glsl"
#include "search/cone_leap.glsl"

Hit trace(Ray ray)
{
    Hit hit = Hit(ray.uv, 0.0f, true, 0);
    vec2 size = searchSize();
    vec2 slope = ray.duv * size;
    float travel = provenStep ? abs(ray.duv.x) + abs(ray.duv.y) : length(ray.duv);
    float outside = 0.0f;
    for (int i = 0; true; ++i) {
        vec2 uv = ray.uv + ray.duv * hit.t;
        vec4 bound = boundAt(uv);
        ++hit.fetches;
        float above = 1.0f - hit.t - bound.x + bendFrom(hit.t).x;
        recordRead(kCone);
        if (above <= 0.0f)
            return bisected(ray, hit, outside, hit.t, hit.t > 0.0f ? refineSteps : 0);
        if (i >= leapSteps)
            break; // the end of the last leap was still looked at
        float ratio = bound.y * bound.y * boundScale().y;
        vec2 p = uv * size - 0.5f;
        p = p - floor(p);
        float toWallU = slope.x != 0.0f ? ((slope.x > 0.0f ? 1.0f : 0.0f) - p.x) / slope.x : 2.0f;
        float toWallV = slope.y != 0.0f ? ((slope.y > 0.0f ? 1.0f : 0.0f) - p.y) / slope.y : 2.0f;
        outside = hit.t;
        float leap = coneLeap(above, ratio, travel, bendRise(outside));
        hit.t += max(leap, min(toWallU, toWallV) + 1e-5f); // their constant, in depth
        record(kCone, min(hit.t, ray.end));
        if (hit.t >= ray.end) {
            hit.t = ray.end;
            hit.found = endsOnFloor(ray);
            if (hit.found) // the floor: inside without asking
                return bisected(ray, hit, outside, 1.0f, refineSteps);
            break;
        }
    }
    hit.uv = ray.uv + ray.duv * hit.t;
    return hit;
}
