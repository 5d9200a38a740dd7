// Blinn-Phong shading, as the relief mapping papers light their pictures: ambient, diffuse and a highlight by the half vector.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 shade(Surface surface)
{
    vec2 uv = surface.hit.uv;
    vec3 n = reliefNormal(surface);
    vec3 base = colorAt(uv, surface.footprint) * tint;
    float occlusion = mix(1.0f, aoAt(uv, surface.footprint), aoStrength);
    vec3 color = base * irradiance(n) * (environmentIntensity * occlusion) + emissionAt(uv, surface.footprint) * emission;
    float nl = dot(n, lightDirection);
    if (nl > 0.0f) {
        float nh = max(dot(n, normalize(lightDirection + surface.toEye)), 0.0f);
        vec3 highlight = specularAt(uv, surface.footprint) * (specular * pow(nh, shininess));
        color += (base * nl + highlight) * lightColor * (lightIntensity * min(lightReaching(surface), lightPassing(surface)));
    }
    return color;
}
