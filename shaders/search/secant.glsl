// Where the ray would meet the relief if the gap between them were linear over a step (one step of the secant method).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// gap: ray height minus relief height; outside > 0 >= inside.
float secantOf(float outside, float inside, float gapOutside, float gapInside)
{
    float fall = gapOutside - gapInside;
    return fall > 0.0f ? outside + (inside - outside) * (gapOutside / fall) : inside;
}
