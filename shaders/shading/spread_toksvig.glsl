// Normals that differ within a pixel widen its highlight, by the length of their mean (Toksvig 2005, Mipmapping Normal Maps), with the
// exponent of Blinn and Phong that GGX resembles.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "shading/normal_length.glsl"

float spreadRoughness(float rough, Surface surface)
{
    float straight = normalLength(surface);
    float alpha2 = rough * rough * rough * rough;
    float exponent = max(2.0f / alpha2 - 2.0f, 0.0f);
    float less = exponent * straight / (straight + exponent * (1.0f - straight));
    return sqrt(sqrt(2.0f / (less + 2.0f)));
}
