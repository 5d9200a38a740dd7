// From linear radiance to the screen: exposure, a tone curve that leaves middle colours alone, sRGB. Of colours that are not lit sRGB alone.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// Khronos PBR Neutral tone mapper (2024): identity up to 0.8 less a little Fresnel, then compressed and desaturated.
vec3 toneCurve(vec3 color)
{
    float smallest = min(color.r, min(color.g, color.b));
    float offset = smallest < 0.08f ? smallest - 6.25f * smallest * smallest : 0.04f;
    color -= offset;
    float peak = max(color.r, max(color.g, color.b));
    if (peak < 0.76f)
        return color;
    float compressed = 1.0f - 0.0576f / (peak - 0.52f);
    color *= compressed / peak;
    float desaturation = 1.0f - 1.0f / (0.15f * (peak - compressed) + 1.0f);
    return mix(color, vec3(compressed), desaturation);
}

// The sRGB curve by square roots, which cost a fifth of pow: a least-squares fit of ours, within a tenth of an 8-bit step.
vec3 encodeSrgb(vec3 color)
{
    color = clamp(color, vec3(0.0f), vec3(1.0f));
    vec3 root = sqrt(color);
    vec3 curve = 0.83374029f * root + 0.29812332f * sqrt(root) - 0.05531710f * color - 0.07690754f;
    return mix(curve, color * 12.92f, vec3(lessThanEqual(color, vec3(0.0031308f))));
}

vec3 toDisplay(vec3 color)
{
#ifdef UNLIT
    return encodeSrgb(color);
#else
    return encodeSrgb(toneCurve(max(color * exposureFactor, vec3(0.0f))));
#endif
}
