// Light that comes to a pixel as the screen shows it: by the tone curve, over a background as it is shown. So a pixel to which none comes
// stays as it was, bit for bit; and what is not covered stays transparent.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 decodeSrgb(vec3 color)
{
    vec3 curve = pow((color + 0.055f) / 1.055f, vec3(2.4f));
    return mix(curve, color / 12.92f, vec3(lessThanEqual(color, vec3(0.04045f))));
}

vec3 withLight(vec4 shown, vec4 light, vec3 more)
{
    vec3 color = vec3(shown.r, shown.g, shown.b);
    bool isLit = light.a > 0.5f;
    vec3 before = isLit ? vec3(light.r, light.g, light.b) : vec3(0.0f);
    vec3 curve = toned(max(before * exposureFactor, vec3(0.0f)));
    vec3 curveAfter = toned(max((before + more) * exposureFactor, vec3(0.0f)));
    vec3 behind = isLit ? curve : decodeSrgb(color);
    return color + (encodeSrgb(behind + (curveAfter - curve)) - encodeSrgb(behind)) * shown.a;
}
