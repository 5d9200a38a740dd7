// Tone curve "aces": Hill's fit of the ACES reference and output transforms for sRGB screens (Stephen Hill, 2016), without a change of exposure.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 toned(vec3 color)
{
    vec3 a = vec3(dot(color, vec3(0.59719f, 0.35458f, 0.04823f)), dot(color, vec3(0.07600f, 0.90834f, 0.01566f)),
        dot(color, vec3(0.02840f, 0.13383f, 0.83777f)));
    a = min(a, vec3(1e6f)); // the quotient of squares stays finite
    a = (a * (a + 0.0245786f) - 0.000090537f) / (a * (0.983729f * a + 0.4329510f) + 0.238081f);
    return vec3(dot(a, vec3(1.60475f, -0.53108f, -0.07367f)), dot(a, vec3(-0.10208f, 1.10813f, -0.00605f)),
        dot(a, vec3(-0.00327f, -0.07276f, 1.07602f)));
}
