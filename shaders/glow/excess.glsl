// How much of a light glows: what its brightest channel has above the threshold, after the exposure, in its own hue.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 excessOf(vec3 light)
{
    vec3 exposed = light * exposureFactor;
    float most = max(exposed.r, max(exposed.g, exposed.b));
    return light * (max(most - bloomThreshold, 0.0f) / max(most, 1e-20f));
}
