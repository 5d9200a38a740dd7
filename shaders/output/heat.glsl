// The heat map of measured values: dark blue to yellow, evenly perceived and safe for colour-blind eyes (after viridis).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
const vec3 kNoHeat = vec3(0.35f); // of a value that is not known

vec3 heat(float x)
{
    x = clamp(x, 0.0f, 1.0f) * 6.0f;
    vec3 color = mix(vec3(0.267f, 0.005f, 0.329f), vec3(0.267f, 0.227f, 0.514f), clamp(x, 0.0f, 1.0f));
    color = mix(color, vec3(0.192f, 0.408f, 0.557f), clamp(x - 1.0f, 0.0f, 1.0f));
    color = mix(color, vec3(0.129f, 0.569f, 0.549f), clamp(x - 2.0f, 0.0f, 1.0f));
    color = mix(color, vec3(0.208f, 0.718f, 0.475f), clamp(x - 3.0f, 0.0f, 1.0f));
    color = mix(color, vec3(0.561f, 0.843f, 0.267f), clamp(x - 4.0f, 0.0f, 1.0f));
    return mix(color, vec3(0.992f, 0.906f, 0.145f), clamp(x - 5.0f, 0.0f, 1.0f));
}
