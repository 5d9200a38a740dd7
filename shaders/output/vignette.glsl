// Natural vignetting: a simple lens passes light by the fourth power of the cosine of the field angle.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 throughLens(vec3 color, vec3 fromEye)
{
    float cosine = dot(fromEye, lookDirection);
    return color * mix(1.0f, cosine * cosine * cosine * cosine, vignette);
}
