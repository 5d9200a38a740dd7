// Tone curve "filmic": Hable's curve (Uncharted 2, GDC 2010), with white at 11.2 and twice the exposure as published.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 hable(vec3 x)
{
    return (x * (0.15f * x + 0.05f) + 0.004f) / (x * (0.15f * x + 0.5f) + 0.06f) - 0.02f / 0.3f;
}

vec3 toned(vec3 color)
{
    return hable(min(2.0f * color, vec3(1e6f))) / hable(vec3(11.2f)); // the quotient of squares stays finite
}
