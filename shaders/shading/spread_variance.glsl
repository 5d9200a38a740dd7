// Normals that differ within a pixel widen its highlight: the variance that the length of their mean tells of (as a von Mises-Fisher lobe)
// is added to that of GGX, up to a bound (Tokuyoshi and Kaplanyan 2019, Improved Geometric Specular Antialiasing).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "shading/normal_length.glsl"

float spreadRoughness(float rough, Surface surface)
{
    float straight = normalLength(surface);
    float variance = (1.0f - straight * straight) / (3.0f * straight - straight * straight * straight);
    return sqrt(sqrt(min(rough * rough * rough * rough + min(2.0f * variance, 0.18f), 1.0f)));
}
