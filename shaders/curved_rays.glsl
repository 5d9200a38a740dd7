// Rays on a curved surface: near a point it falls below its tangent plane by a quadric (Oliveira and Policarpo 2005, An Efficient
// Representation for Surface Details; RTM report, section 4.4). Ours has the quadric's mixed term, which the papers leave out.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
in vec3 curvature; // fall = x du^2 + y dv^2 + z du dv, m, du and dv in UVs of the mesh

float fallOver(vec2 duv)
{
    vec2 d = meshFromTexture * duv;
    float fall = curvature.x * d.x * d.x + curvature.y * d.y * d.y + curvature.z * d.x * d.y;
    return gl_FrontFacing ? fall : -fall;
}

// The lateral way down to the full depth is depth * tan(angle of view); the circle falls by half its square over the radius.
float narrowingOf(Ray ray, float depth)
{
    float slant = max(1.0f / (ray.cosView * ray.cosView) - 1.0f, 1e-3f);
    float c = 2.0f * fallOver(ray.duv) / (max(depth, 1e-12f) * slant);
    // A quadric says nothing about depths near its radius.
    return c == c ? clamp(c, -0.6f, 0.6f) : 0.0f;
}

// An angle over its sine.
float overSine(float sine)
{
    return 1.0f + sine * sine * (1.0f / 6.0f + 0.075f * sine * sine);
}

// From where the light enters the relief down to the point seen, which lies at ray.end. In a hollow the light may come in over its rim:
// then the ray begins at its highest point.
Ray lightRay(Surface surface, vec3 toLight)
{
    Ray ray = rayInto(surface.frame, surface.hit.uv, toLight, surface.depth);
    float c = narrowingOf(ray, surface.depth);
    float t = surface.hit.t;
    float room = 1.0f - c * t; // radius at the point over that of the surface
    float sine = sqrt(max(1.0f - ray.cosView * ray.cosView, 0.0f));
    float rim = 1.0f - room * room * sine * sine;
    float share = t * (2.0f - c * t) / (sqrt(max(rim, 0.0f)) + room * ray.cosView);
    float enter = max(share * ray.cosView * overSine(min(abs(share * c) * sine, 1.0f)), 1e-6f);
    float top = 0.0f;
    if (rim < 0.0f) // the way up is mirrored: w room / (1 - c w) without the bend
        top = max(t - room * enter * (1.0f + 0.5f * c * enter * sine * sine / (ray.cosView * ray.cosView)) / max(1.0f - c * enter, 0.1f), 0.0f);
    float whole = max(enter, 1.0f);
    float grow = whole / enter;
    float fall = t - top - room * enter; // of a parabola with the slope of the way at the point
    curve = vec3(-top, 1.0f - (room * enter + 2.0f * fall) * grow, fall * grow * grow);
    ray.uv -= ray.duv * enter;
    ray.duv *= whole;
    ray.end = enter / whole;
    return ray;
}
