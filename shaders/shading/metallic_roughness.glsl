// Metallic-roughness shading as glTF 2.0 defines it (GGX, Smith, Schlick) under one directional light, and a prefiltered
// environment with the analytic fit of its reflectance (Karis 2014, Physically Based Shading on Mobile).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 shade(Surface surface)
{
    vec2 uv = surface.hit.uv;
    vec3 n = reliefNormal(surface);
    vec3 v = surface.toEye;
    vec3 base = colorAt(uv, surface.footprint) * tint;
    float rough = clamp(roughnessAt(uv, surface.footprint) * roughness, 0.045f, 1.0f);
    float metal = metallicAt(uv, surface.footprint) * metallic;
    vec3 f0 = mix(vec3(0.04f), base, metal);
    vec3 diffuse = base * (1.0f - metal);
    float nv = clamp(dot(n, v), 0.001f, 1.0f);

    vec3 color = vec3(0.0f);
    float nl = dot(n, lightDirection);
    if (nl > 0.0f) {
        vec3 h = normalize(lightDirection + v);
        float nh = clamp(dot(n, h), 0.0f, 1.0f);
        float vh = clamp(dot(v, h), 0.0f, 1.0f);
        float alpha = rough * rough;
        float alpha2 = alpha * alpha;
        float d = nh * nh * (alpha2 - 1.0f) + 1.0f;
        float distribution = alpha2 / (d * d); // times 1 / pi, which the light's unit takes
        float visibility = 0.5f / (nl * sqrt(nv * nv * (1.0f - alpha2) + alpha2) + nv * sqrt(nl * nl * (1.0f - alpha2) + alpha2));
        float grazing = 1.0f - vh;
        float grazing2 = grazing * grazing;
        vec3 fresnel = f0 + (1.0f - f0) * (grazing2 * grazing2 * grazing);
        color = (diffuse * (1.0f - fresnel) + fresnel * (distribution * visibility)) * lightColor
            * (lightIntensity * nl * min(lightReaching(surface), lightPassing(surface)));
    }

    vec4 r = rough * vec4(-1.0f, -0.0275f, -0.572f, 0.022f) + vec4(1.0f, 0.0425f, 1.04f, -0.04f);
    float a004 = min(r.x * r.x, exp2(-9.28f * nv)) * r.x + r.y;
    vec3 reflectance = f0 * (-1.04f * a004 + r.z) + (1.04f * a004 + r.w);
    float occlusion = mix(1.0f, aoAt(uv, surface.footprint), aoStrength);
    color += (diffuse * irradiance(n) + reflectance * reflection(reflect(-v, n), rough)) * (environmentIntensity * occlusion);
    return color + emissionAt(uv, surface.footprint) * emission;
}
