// Halving an interval whose start lies outside the relief and whose end lies inside.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

Hit bisected(Ray ray, Hit hit, float outside, float inside, int halvings)
{
    for (int i = 0; i < halvings; ++i) {
        float middle = 0.5f * (outside + inside);
        ++hit.fetches;
        if (1.0f - heightOn(ray, middle) <= middle)
            inside = middle;
        else
            outside = middle;
    }
    hit.t = inside;
    hit.uv = ray.uv + ray.duv * inside;
    return hit;
}
