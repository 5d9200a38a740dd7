// How far above a point its occluders must lie: for exact searches a fiftieth of a texel along the ray, enough that rounding does not find
// the point itself. An occluder nearer than that in the point's own cell is lost.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float shadowSlack(Ray ray)
{
    vec2 texels = ray.duv * searchSize();
    return 0.02f / max(length(texels), 0.02f) + 2e-6f;
}
