// The largest picture of the glow read by a cubic B-spline, which has no steps and whose weights add up alike at any scale; in four reads
// (Sigg and Hadwiger 2005, Fast Third-Order Texture Filtering).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 smoothAt(vec2 uv)
{
    vec2 size = vec2(textureSize(glowPicture, 0));
    vec2 at = uv * size - 0.5f;
    vec2 f = fract(at);
    vec2 texel = floor(at);
    vec2 first = (1.0f - f) * (1.0f - f) * (1.0f - f) / 6.0f;
    vec2 last = f * f * f / 6.0f;
    vec2 low = 2.0f / 3.0f - f * f * (1.0f - 0.5f * f) + first; // of the first two texels; the others have the rest
    vec2 high = 1.0f - low;
    vec2 a = (texel + 0.5f - first / low) / size;
    vec2 b = (texel + 1.5f + last / high) / size;
    vec3 lower = textureLod(glowPicture, a, 0.0f).rgb * low.x + textureLod(glowPicture, vec2(b.x, a.y), 0.0f).rgb * high.x;
    vec3 upper = textureLod(glowPicture, vec2(a.x, b.y), 0.0f).rgb * low.x + textureLod(glowPicture, b, 0.0f).rgb * high.x;
    return lower * low.y + upper * high.y;
}
