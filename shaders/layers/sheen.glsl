// Sheen of cloth as KHR_materials_sheen defines it: the "Charlie" distribution (Estevez and Kulla 2017), Neubelt's visibility, and what lies
// below scaled by the light that is left.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// The share of light from all around that the sheen reflects: a fit of ours to the integral over the hemisphere, off by at most 0.025 where
// the roughness is 0.15 and the cosine 0.08 or more.
float sheenAlbedo(float cosine)
{
    float r = clamp(sheenRoughness, 0.15f, 1.0f);
    float c = clamp(cosine, 0.08f, 1.0f);
    float a = 1.892f + r * (-8.861f + r * (12.25f - 5.875f * r));
    float b = -17.66f + r * (76.52f + r * (-124.8f + 64.91f * r));
    float d = 9.494f + r * (-65.87f + r * (141.9f - 85.78f * r));
    float e = -6.999f + r * (33.55f + r * (-69.53f + 42.95f * r));
    return clamp(exp(a + c * (b + c * (d + c * e))) - 0.002f, 0.0f, 1.0f);
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
    return sheenColor * (sheen * sheenAlbedo(point.nv)) * skyLight(point.sky);
}
