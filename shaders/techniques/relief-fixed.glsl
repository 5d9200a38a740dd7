// Relief mapping with fixed steps: 10 linear tests at most and 6 halvings, or 20 and 5 ("double precision": finer steps, not wider floats).
// Policarpo 2004, Relief Mapping in a Pixel Shader using Binary Search. The last linear position is not tested there but taken for inside,
// so a ray always ends on something.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/bisection.glsl"

Hit trace(Ray ray)
{
    int steps = doublePrecision ? 20 : 10;
    Hit hit = Hit(ray.uv, 0.0f, true, 0);
    float size = ray.end / float(steps);
    float inside = ray.end;
    for (int i = 1; i < steps; ++i) {
        float t = size * float(i);
        float height = heightOn(ray, t);
        ++hit.fetches;
        record(kLinear, t);
        if (1.0f - height <= t) {
            inside = t;
            break;
        }
    }
    record(kLinear, inside);
    hit = bisected(ray, hit, inside - size, inside, doublePrecision ? 5 : 6);
    hit.found = endsOnFloor(ray) || hit.t < ray.end - 0.01f * size; // a shadow ray that got through ends on its own point
    return hit;
}
