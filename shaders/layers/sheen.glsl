// Sheen of cloth as KHR_materials_sheen defines it: the "Charlie" distribution (Estevez and Kulla 2017), Neubelt's visibility, and what lies
// below scaled by the light that is left.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// The share of light from all around that the sheen reflects: a fit of the integral over the hemisphere.
float sheenAlbedo(float cosine)
{
    float r = max(sheenRoughness, 0.07f);
    float r2 = r * r;
    float a = r < 0.25f ? -339.2f * r2 + 161.4f * r - 25.9f : -8.48f * r2 + 14.3f * r - 9.95f;
    float b = r < 0.25f ? 44.0f * r2 - 23.7f * r + 3.26f : 1.97f * r2 - 3.27f * r + 0.72f;
    return clamp((exp(a * cosine + b) + (r < 0.25f ? 0.0f : 0.1f * (r - 0.25f))) * 0.31830989f, 0.0f, 1.0f);
}

float belowSheen(ShadingPoint point, float cosine)
{
    float most = sheen * max(sheenColor.r, max(sheenColor.g, sheenColor.b));
    return 1.0f - most * max(sheenAlbedo(point.nv), sheenAlbedo(clamp(cosine, 0.0f, 1.0f)));
}

vec3 sheenReflected(ShadingPoint point, vec3 toLight)
{
    float nl = clamp(dot(point.normal, toLight), 0.001f, 1.0f);
    float nh = clamp(dot(point.normal, normalize(toLight + point.toEye)), 0.0f, 1.0f);
    float sharpness = 1.0f / max(sheenRoughness * sheenRoughness, 0.005f);
    float distribution = (2.0f + sharpness) * pow(max(1.0f - nh * nh, 1e-6f), 0.5f * sharpness) * 0.5f; // times pi
    return sheenColor * (sheen * distribution * nl / (4.0f * (nl + point.nv - nl * point.nv)));
}

vec3 sheenAround(ShadingPoint point)
{
    return sheenColor * (sheen * sheenAlbedo(point.nv)) * irradiance(point.normal);
}
