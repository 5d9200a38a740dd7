// Tone curve "neutral": Khronos PBR Neutral tone mapper (2024): identity up to 0.8 less a little Fresnel, then compressed and desaturated.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 toned(vec3 color)
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
