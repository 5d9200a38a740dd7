// How much of a light's disc the relief leaves to be seen: eight rays over it, turned from pixel to pixel so that no steps show, and from
// sample to sample so that the average of several is smooth.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float shareReaching(Surface surface, vec3 toMiddle, float radius) // of the disc, at distance 1
{
    vec3 across = normalize(cross(toMiddle, abs(toMiddle.y) < 0.9f ? vec3(0.0f, 1.0f, 0.0f) : vec3(1.0f, 0.0f, 0.0f)));
    vec3 up = cross(across, toMiddle);
    // Interleaved gradient noise (Jimenez 2014, Next Generation Post Processing in Call of Duty: Advanced Warfare).
    // sampleTurn: share of a whole turn, 0 in a picture of one sample.
    float turn = sampleTurn + fract(52.9829189f * fract(0.06711056f * gl_FragCoord.x + 0.00583715f * gl_FragCoord.y));
    float lit = 0.0f;
    for (int i = 0; i < 8; ++i) {
        // Evenly over the disc: a spiral by the golden angle (Vogel 1979).
        float angle = 2.3999632f * float(i) + 6.2831853f * turn;
        float r = radius * sqrt((float(i) + 0.5f) / 8.0f);
        vec3 toLight = normalize(toMiddle + (across * cos(angle) + up * sin(angle)) * r);
        lit += !lightIsHidden(surface, toLight) ? 0.125f : 0.0f;
    }
    return lit;
}
