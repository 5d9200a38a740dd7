// Highlights that are stretched along one direction of the surface, as KHR_materials_anisotropy defines them: GGX with a width along either
// axis (Burley 2012, Physically Based Shading at Disney; Smith's visibility after Heitz 2014), and reflections of the surroundings by a
// normal that is bent towards the eye across the scratches. What is reflected more than once is that of a surface as rough in the mean.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct Stretch {
    vec3 along; // unit, in the surface, where the highlight is wide
    vec3 across;
    vec2 alpha; // along and across
};

Stretch stretchOf(Surface surface, ShadingPoint point)
{
    // The texture's u on the surface, and up in its picture, also where it is mirrored or skewed.
    vec3 u = cross(surface.frame.gradV, surface.frame.normal);
    u = dot(u, u) > 0.0f ? normalize(u) : vec3(1.0f, 0.0f, 0.0f);
    u = dot(u, surface.frame.gradU) < 0.0f ? -u : u;
    vec3 up = cross(surface.frame.normal, u);
    up = dot(up, surface.frame.gradV) > 0.0f ? -up : up;
    float turn = radians(anisotropyRotation);
    vec3 along = u * cos(turn) + up * sin(turn);
    along -= point.normal * dot(along, point.normal);
    along = dot(along, along) > 1e-12f ? normalize(along) : u;
    float alpha = point.rough * point.rough;
    return Stretch(along, cross(point.normal, along), vec2(mix(alpha, 1.0f, anisotropyStrength * anisotropyStrength), alpha));
}

// With the shares of light from all around that microfacets as rough in the mean square reflect.
ShadingPoint stretched(ShadingPoint point, Stretch stretch)
{
    ShadingPoint body = point;
    vec2 share = reflectedOnce(point.nv, sqrt(sqrt(0.5f * dot(stretch.alpha, stretch.alpha))));
    body.once = point.f0 * (share.x - share.y) + share.y;
    body.again = reflectedAgain(point.f0, body.once, 1.0f - share.x);
    return body;
}

vec3 bodyReflected(Surface surface, ShadingPoint point, vec3 toLight)
{
    Stretch stretch = stretchOf(surface, point);
    ShadingPoint body = stretched(point, stretch);
    float nl = dot(point.normal, toLight);
    vec3 h = normalize(toLight + point.toEye);
    vec3 widths = vec3(stretch.alpha, 1.0f);
    vec3 facet = vec3(dot(stretch.along, h), dot(stretch.across, h), clamp(dot(point.normal, h), 0.0f, 1.0f)) / widths;
    float d = dot(facet, facet);
    float distribution = 1.0f / (widths.x * widths.y * d * d); // times 1 / pi, which the light's unit takes
    float eyeWay = length(vec3(dot(stretch.along, point.toEye), dot(stretch.across, point.toEye), point.nv) * widths);
    float lightWay = length(vec3(dot(stretch.along, toLight), dot(stretch.across, toLight), nl) * widths);
    float grazing = 1.0f - clamp(dot(point.toEye, h), 0.0f, 1.0f);
    float grazing2 = grazing * grazing;
    vec3 fresnel = point.f0 + (1.0f - point.f0) * (grazing2 * grazing2 * grazing);
    float visibility = 0.5f / (nl * eyeWay + point.nv * lightWay);
    return (point.diffuse + fresnel * (1.0f + body.again / max(body.once, vec3(1e-6f))) * (distribution * visibility)) * nl;
}

vec3 bodyAround(Surface surface, ShadingPoint point)
{
    Stretch stretch = stretchOf(surface, point);
    ShadingPoint body = stretched(point, stretch);
    vec3 towards = point.toEye - stretch.across * dot(point.toEye, stretch.across);
    float straight = 1.0f - anisotropyStrength * (1.0f - point.rough);
    vec3 bent = normalize(mix(towards, point.normal, straight * straight * straight * straight));
    return (point.diffuse + body.again) * skyLight(point.sky)
        + body.once * reflection(reflect(-point.toEye, bent), point.rough) * reflectedShare(point.sky, point.nv, point.rough);
}
