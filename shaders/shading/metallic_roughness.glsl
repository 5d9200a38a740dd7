// Metallic-roughness shading as glTF 2.0 defines it (GGX, height-correlated Smith, Schlick), with the light that is reflected more than once
// between microfacets (Fdez-Aguera 2019, A Multiple-Scattering Microfacet Model for Real-Time Image-based Lighting): what falls on a
// surface leaves it, is absorbed by its colour, or is not there.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct ShadingPoint {
    vec3 normal;
    vec3 toEye;
    float nv;
    float rough;
    vec3 f0;
    vec3 once; // shares of light from all around alike that leave towards the eye: reflected once by microfacets,
    vec3 again; // more than once,
    vec3 diffuse; // and from below the surface
    Sky sky;
};

// Shares of light from all around alike that microfacets reflect once: by a Fresnel term of 1, and by (1 - v . h)^5. Rational fits of ours
// to the integrals over visible normals, off by at most 0.0065 and 0.01 where nv is 0.07 or more.
vec2 reflectedOnce(float nv, float rough)
{
    vec3 r = vec3(1.0f, rough, rough * rough);
    vec3 v = vec3(1.0f, nv, nv * nv);
    float lost = rough * rough * (dot(vec3(0.0201f, 1.016f, -0.6599f), r) + nv * dot(vec3(7.63f, -31.05f, 54.58f), r))
        / (dot(vec3(0.1496f, 7.683f, 54.03f), v) + rough * dot(vec3(-2.758f, -69.57f, -83.92f), v)
            + rough * rough * dot(vec3(13.78f, 100.0f, 25.75f), v));
    float grazing = (1.0f - nv) * (1.0f - nv) * (1.416f - 1.821f * nv + rough * (1.649f * nv - 0.9914f))
        / (dot(vec3(1.441f, -0.5221f, 14.99f), r) + nv * dot(vec3(1.136f, -20.29f, 26.63f), r)
            + nv * nv * (dot(vec3(17.5f, -33.68f, 15.42f), r) + nv * dot(vec3(-19.13f, 96.51f, -100.0f), r)));
    return vec2(1.0f - lost, clamp(grazing, 0.0f, 1.0f - lost));
}

// The share of light from all around alike that is reflected more than once, after `once`.
vec3 reflectedAgain(vec3 f0, vec3 once, float lost)
{
    vec3 fresnel = f0 + (1.0f - f0) / 21.0f; // its mean over all directions
    return once * fresnel * lost / (1.0f - fresnel * lost);
}

// A dielectric and a metal, mixed.
ShadingPoint shadingPointOf(Surface surface)
{
    vec2 uv = surface.hit.uv;
    vec3 n = reliefNormal(surface);
    vec3 base = colorAt(uv, surface.footprint) * tint;
    float rough = spreadRoughness(clamp(roughnessAt(uv, surface.footprint) * roughness, 0.045f, 1.0f), surface);
    float metal = metallicAt(uv, surface.footprint) * metallic;
    float nv = clamp(dot(n, surface.toEye), 0.001f, 1.0f);
    float plainF0 = (ior - 1.0f) * (ior - 1.0f) / ((ior + 1.0f) * (ior + 1.0f)); // of a dielectric
    vec2 share = reflectedOnce(nv, rough);
    vec3 plain = vec3(plainF0 * (share.x - share.y) + share.y); // the dielectric's
    vec3 plainAgain = reflectedAgain(vec3(plainF0), plain, 1.0f - share.x);
    vec3 metals = base * (share.x - share.y) + share.y;
    vec3 once = mix(plain, metals, metal);
    vec3 again = mix(plainAgain, reflectedAgain(base, metals, 1.0f - share.x), metal);
    vec3 diffuse = base * (1.0f - metal) * (1.0f - plain - plainAgain);
    return ShadingPoint(n, surface.toEye, nv, rough, mix(vec3(plainF0), base, metal), once, again, diffuse, skyOver(surface, n));
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
    return (point.diffuse + fresnel * (1.0f + point.again / max(point.once, vec3(1e-6f))) * (distribution * visibility)) * nl;
}

vec3 reflectedSurroundings(ShadingPoint point)
{
    return (point.diffuse + point.again) * skyLight(point.sky)
        + point.once * reflection(reflect(-point.toEye, point.normal), point.rough) * reflectedShare(point.sky, point.nv, point.rough);
}
