// How far from a point its occluders must lie: for exact searches a fiftieth of a texel along the ray, enough that rounding does not find
// the point itself. An occluder nearer than that in the point's own cell is lost.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float shadowSlack()
{
    return 0.02f;
}

// What of it a ray clears, for each unit of t, that sinks by `fall` meanwhile. So many texels at most that the slack is not lost to rounding.
float slackCleared(Ray ray, float fall)
{
    return clamp(length(ray.duv * searchSize()), 0.02f, 1e4f);
}
