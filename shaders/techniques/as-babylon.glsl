// As Babylon draws parallax occlusion: n = 15 + 11 V.z layers, but 15 samples whatever n is. What lies deeper than 15 / n of the depth is cut
// off flat there: 0.58 of it seen from straight above, 0.66 at 45 degrees, 0.80 at 70. It reads on when it has found.
// Babylon 9.35, run: its texture coordinates are these to 0.0003.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/secant.glsl"

Hit trace(Ray ray)
{
    float layers = 15.0f + 11.0f * ray.cosView;
    float t = 0.0f;
    float outside = 0.0f;
    float gapOutside = 0.0f;
    bool found = false;
    for (int i = 1; i <= 15; ++i) {
        float gap = 1.0f - t - heightAt(ray.uv + ray.duv * t);
        if (found)
            continue;
        record(kLinear, t);
        found = gap < 0.0f;
        if (found) {
            t = secantOf(outside, t, gapOutside, gap);
        } else {
            outside = t;
            gapOutside = gap;
            t = float(i) / layers;
        }
    }
    record(found ? kSecant : kLinear, t);
    return Hit(ray.uv + ray.duv * t, t, true, 15);
}
