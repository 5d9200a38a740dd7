// Phong's model mixed with reflection and refraction of the surroundings, as the listing of the thesis on derivative-based relief mapping has
// it: a map whose channels are the shininess, the ratio of refraction and how much of a mirror the surface is; what is not opaque refracts.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct ShadingPoint {
    vec3 normal;
    vec3 toEye;
    vec3 diffuse;
    vec3 highlight;
    float shininess;
    float eta;
    float mirror;
    float opaque;
    Sky sky;
};

ShadingPoint shadingPointOf(Surface surface)
{
    vec2 uv = surface.hit.uv;
    vec3 optics = opticsAt(uv, surface.footprint);
    vec3 n = reliefNormal(surface);
    return ShadingPoint(n, surface.toEye, colorAt(uv, surface.footprint) * tint,
        specularAt(uv, surface.footprint) * specular, max(255.0f * optics.r, 1.0f), 2.0f * optics.g, optics.b,
        opacityAt(uv, surface.footprint), skyOver(surface, n));
}

// Share of Phong's colour in what is seen.
float emittedShare(ShadingPoint point)
{
    return point.opaque * (1.0f - point.mirror);
}

// What is reflected of a light whose irradiance over pi is 1, as a share.
vec3 reflected(ShadingPoint point, vec3 toLight)
{
    float rv = max(dot(reflect(-toLight, point.normal), point.toEye), 0.0f);
    return (point.diffuse * dot(point.normal, toLight) + point.highlight * pow(rv, point.shininess)) * emittedShare(point);
}

vec3 reflectedSurroundings(ShadingPoint point)
{
    vec3 away = reflect(-point.toEye, point.normal);
    vec3 through = refract(-point.toEye, point.normal, point.eta);
    if (dot(through, through) < 0.5f) // total reflection, which the listing makes the direction 0 of
        through = away;
    vec3 seen = mix(reflection(through, 0.0f), point.diffuse * skyLight(point.sky), point.opaque);
    float nv = max(dot(point.normal, point.toEye), 0.0f);
    return mix(seen, reflection(away, 0.0f) * reflectedShare(point.sky, nv, 0.0f), point.mirror);
}
