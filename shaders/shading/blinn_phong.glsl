// Blinn-Phong shading, as the relief mapping papers light their pictures: ambient, diffuse and a highlight by the half vector.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct ShadingPoint {
    vec3 normal;
    vec3 toEye;
    vec3 diffuse;
    vec3 highlight;
    Sky sky;
};

ShadingPoint shadingPointOf(Surface surface)
{
    vec2 uv = surface.hit.uv;
    vec3 n = reliefNormal(surface);
    return ShadingPoint(n, surface.toEye, colorAt(uv, surface.footprint) * tint, specularAt(uv, surface.footprint) * specular,
        skyOver(surface, n));
}

// What is reflected of a light whose irradiance over pi is 1, as a share.
vec3 reflected(ShadingPoint point, vec3 toLight)
{
    float nh = max(dot(point.normal, normalize(toLight + point.toEye)), 0.0f);
    return point.diffuse * dot(point.normal, toLight) + point.highlight * pow(nh, shininess);
}

vec3 reflectedSurroundings(ShadingPoint point)
{
    return point.diffuse * skyLight(point.sky);
}
