// A clear coat as KHR_materials_clearcoat defines it: a layer with an index of refraction of 1.5, as smooth as the mesh itself.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float coatShare(Surface surface)
{
    float grazing = 1.0f - clamp(abs(dot(surface.frame.normal, surface.toEye)), 0.0f, 1.0f);
    float grazing2 = grazing * grazing;
    return clearcoat * (0.04f + 0.96f * grazing2 * grazing2 * grazing);
}

// GGX with Smith's visibility, times the cosine and pi.
vec3 coatReflected(Surface surface, vec3 toLight)
{
    vec3 n = surface.frame.normal;
    float nl = dot(n, toLight);
    float nv = clamp(dot(n, surface.toEye), 0.001f, 1.0f);
    if (nl <= 0.0f)
        return vec3(0.0f);
    float nh = clamp(dot(n, normalize(toLight + surface.toEye)), 0.0f, 1.0f);
    float rough = max(clearcoatRoughness, 0.045f);
    float alpha2 = rough * rough * rough * rough;
    float d = nh * nh * (alpha2 - 1.0f) + 1.0f;
    float visibility = 0.5f / (nl * sqrt(nv * nv * (1.0f - alpha2) + alpha2) + nv * sqrt(nl * nl * (1.0f - alpha2) + alpha2));
    return vec3(alpha2 / (d * d) * visibility * nl);
}

vec3 coatAround(Surface surface)
{
    return reflection(reflect(-surface.toEye, surface.frame.normal), clearcoatRoughness);
}
