// Parallax mapping: one step along the view, as deep as the relief is under the surface point.
// Kaneko et al. 2001, Detailed Shape Representation with Parallax Mapping; offset limiting: Welsh 2004, Parallax Mapping with
// Offset Limiting (the shift is not divided by the view's height, so it never exceeds the depth).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Hit trace(Ray ray)
{
    float t = 1.0f - heightAt(ray.uv);
    float share = offsetLimiting ? t * ray.cosView : t;
    record(kOffset, t);
    return Hit(ray.uv + ray.duv * share, t, true, 1);
}
