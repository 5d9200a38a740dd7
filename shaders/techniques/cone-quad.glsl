// Quad-directional cone step mapping: as cone step mapping, with a cone of its own for each of four sectors of directions.
// Policarpo and Oliveira 2007, GPU Gems 3, chapter 18 (figure 18-1); the map is described in core/maps/acceleration/cone.h. Height and cones take two
// fetches.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/bisection.glsl"
#include "search/cone_leap.glsl"

Hit trace(Ray ray)
{
    Hit hit = Hit(ray.uv, 0.0f, true, 0);
    float travel = length(ray.duv);
    bool alongU = abs(ray.duv.x) >= abs(ray.duv.y);
    vec4 sector = alongU ? (ray.duv.x < 0.0f ? vec4(0.0f, 1.0f, 0.0f, 0.0f) : vec4(1.0f, 0.0f, 0.0f, 0.0f))
                         : (ray.duv.y < 0.0f ? vec4(0.0f, 0.0f, 0.0f, 1.0f) : vec4(0.0f, 0.0f, 1.0f, 0.0f));
    float scale = dot(boundScale(), sector);
    float outside = 0.0f;
    for (int i = 0; true; ++i) {
        vec2 uv = ray.uv + ray.duv * hit.t;
        float above = 1.0f - hit.t - heightAt(uv) + bendFrom(hit.t).x;
        ++hit.fetches;
        recordRead(kCone);
        if (above <= 0.0f)
            return bisected(ray, hit, outside, hit.t, hit.t > 0.0f ? refineSteps : 0);
        if (i >= leapSteps)
            break; // the end of the last leap was still looked at
        float root = dot(boundAt(uv), sector);
        ++hit.fetches;
        float ratio = root * root * scale;
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
