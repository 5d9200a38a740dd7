// How far above a point its occluders must lie: for exact searches a fiftieth of a texel along the ray, in the point's own cell, where the
// only other root of the cell's quadratic would be a fold of that size.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float shadowSlack(Ray ray)
{
    vec2 texels = ray.duv * searchSize();
    return 0.02f / max(length(texels), 0.02f) + 2e-6f;
}
