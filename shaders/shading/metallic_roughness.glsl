// Metallic-roughness shading as glTF 2.0 defines it (GGX, Smith, Schlick), and a prefiltered environment with the analytic fit of its
// reflectance (Karis 2014, Physically Based Shading on Mobile).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct ShadingPoint {
    vec3 normal;
    vec3 toEye;
    float nv;
    vec3 diffuse;
    vec3 f0;
    float rough;
};

ShadingPoint shadingPointOf(Surface surface)
{
    vec2 uv = surface.hit.uv;
    vec3 n = reliefNormal(surface);
    vec3 base = colorAt(uv, surface.footprint) * tint;
    float rough = spreadRoughness(clamp(roughnessAt(uv, surface.footprint) * roughness, 0.045f, 1.0f), surface);
    float metal = metallicAt(uv, surface.footprint) * metallic;
    float nv = clamp(dot(n, surface.toEye), 0.001f, 1.0f);
    float step = (ior - 1.0f) / (ior + 1.0f);
    return ShadingPoint(n, surface.toEye, nv, base * (1.0f - metal), mix(vec3(step * step), base, metal), rough);
}

// Of the surface's own light.
float emittedShare(ShadingPoint point)
{
    return 1.0f;
}

// What is reflected of a light whose irradiance over pi is 1, as a share.
vec3 reflected(ShadingPoint point, vec3 toLight)
{
    float nl = dot(point.normal, toLight);
    vec3 h = normalize(toLight + point.toEye);
    float nh = clamp(dot(point.normal, h), 0.0f, 1.0f);
    float vh = clamp(dot(point.toEye, h), 0.0f, 1.0f);
    float alpha = point.rough * point.rough;
    float alpha2 = alpha * alpha;
    float d = nh * nh * (alpha2 - 1.0f) + 1.0f;
    float distribution = alpha2 / (d * d); // times 1 / pi, which the light's unit takes
    float visibility
        = 0.5f / (nl * sqrt(point.nv * point.nv * (1.0f - alpha2) + alpha2) + point.nv * sqrt(nl * nl * (1.0f - alpha2) + alpha2));
    float grazing = 1.0f - vh;
    float grazing2 = grazing * grazing;
    vec3 fresnel = point.f0 + (1.0f - point.f0) * (grazing2 * grazing2 * grazing);
    return (point.diffuse * (1.0f - fresnel) + fresnel * (distribution * visibility)) * nl;
}

vec3 reflectedSurroundings(ShadingPoint point)
{
    vec4 r = point.rough * vec4(-1.0f, -0.0275f, -0.572f, 0.022f) + vec4(1.0f, 0.0425f, 1.04f, -0.04f);
    float a004 = min(r.x * r.x, exp2(-9.28f * point.nv)) * r.x + r.y;
    vec3 reflectance = point.f0 * (-1.04f * a004 + r.z) + (1.04f * a004 + r.w);
    return point.diffuse * irradiance(point.normal) + reflectance * reflection(reflect(-point.toEye, point.normal), point.rough);
}
