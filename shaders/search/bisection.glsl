// Halving an interval whose start lies outside the relief and whose end lies inside.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

Hit bisected(Ray ray, Hit hit, float outside, float inside, int halvings)
{
    for (int i = 0; i < halvings; ++i) {
        float middle = 0.5f * (outside + inside);
        float height = heightOn(ray, middle);
        ++hit.fetches;
        if (1.0f - height <= middle)
            inside = middle;
        else
            outside = middle;
        recordHalving(outside, inside, middle);
    }
    hit.t = inside;
    hit.uv = ray.uv + ray.duv * inside;
    return hit;
}
