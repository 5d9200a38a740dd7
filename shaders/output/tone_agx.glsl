// Tone curve "agx": Sobotka's AgX, its sigmoid as the polynomial of Wrensch (Minimal AgX Implementation, 2023).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 toned(vec3 color)
{
    vec3 inset = vec3(dot(color, vec3(0.842479062f, 0.0784335999f, 0.0792237451f)), dot(color, vec3(0.0423282422f, 0.878468636f, 0.0791661274f)),
        dot(color, vec3(0.0423756549f, 0.0784336f, 0.879142973f)));
    vec3 x = clamp((log2(max(inset, vec3(1e-10f))) + 12.47393f) / 16.5f, vec3(0.0f), vec3(1.0f)); // from -12.47393 to 4.026069 stops
    vec3 x2 = x * x;
    vec3 x4 = x2 * x2;
    vec3 y = 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4 - 6.868f * x2 * x + 0.4298f * x2 + 0.1191f * x - 0.00232f;
    vec3 outset = vec3(dot(y, vec3(1.19687900f, -0.0980208811f, -0.0990297440f)), dot(y, vec3(-0.0528968517f, 1.15190313f, -0.0989611768f)),
        dot(y, vec3(-0.0529716355f, -0.0980434501f, 1.15107367f)));
    return pow(max(outset, vec3(0.0f)), vec3(2.2f)); // the curve ends in a screen's values
}
