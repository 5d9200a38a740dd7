// Looking at a curved surface (Oliveira and Policarpo 2005, An Efficient Representation for Surface Details; RTM report, section 4.4): near a
// point it falls below its tangent plane by a quadric, so the ray of sight may leave the relief again, and where it does so without a hit the
// pixel is past the outline. Ours has the quadric's mixed term, which the papers leave out.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
in vec3 curvature; // fall = x du^2 + y dv^2 + z du dv, m, du and dv in UVs of the mesh

float stretch = 1.0f; // of the search ray: its whole length over the way down to the depth of the relief below a plane

float fallOver(vec2 duv)
{
    vec2 d = meshFromTexture * duv;
    float fall = curvature.x * d.x * d.x + curvature.y * d.y * d.y + curvature.z * d.x * d.y;
    return gl_FrontFacing ? fall : -fall;
}

// The ray's bend per t^2, in depths of the relief.
float bendOf(Ray ray, float depth)
{
    float k = fallOver(ray.duv) / max(depth, 1e-12f);
    return abs(k) < 1e7f ? k : 0.0f;
}

// Its depth is t - k t^2: it comes to the floor, or out of the relief again when it bends more than that.
Ray sightRay(Frame frame, vec3 toEye, float depth)
{
    Ray ray = rayInto(frame, textureUv, toEye, depth);
    float k = bendOf(ray, depth);
    bool leaves = k > 0.25f;
    stretch = leaves ? 1.0f / k : 2.0f / (1.0f + sqrt(1.0f - 4.0f * k));
    float bend = k * stretch * stretch;
    curve = vec3(0.0f, leaves ? 1.0f - bend : -bend, bend);
    ray.duv *= stretch;
    return ray;
}

// The frame of the surface at a shift in uv from where the ray met it.
Frame carried(Frame frame, vec2 duv)
{
    vec2 d = meshFromTexture * duv;
    vec2 slope = vec2(2.0f * curvature.x * d.x + curvature.z * d.y, 2.0f * curvature.y * d.y + curvature.z * d.x);
    slope = (gl_FrontFacing ? 1.0f : -1.0f) * (slope * meshFromTexture);
    float area = dot(frame.normal, cross(frame.gradU, frame.gradV));
    if (!(abs(area) > 1e-20f) || !(dot(slope, slope) < 1e12f))
        return frame;
    vec3 alongU = cross(frame.gradV, frame.normal) / area - frame.normal * slope.x;
    vec3 alongV = cross(frame.normal, frame.gradU) / area - frame.normal * slope.y;
    return frameOf(normalize(frame.normal + frame.gradU * slope.x + frame.gradV * slope.y), alongU, alongV);
}

// What the pixel sees: fills hit, point, and the frame there.
Surface seen(Surface surface)
{
    Ray ray = sightRay(surface.frame, surface.toEye, surface.depth);
    surface.hit = trace(ray);
    surface.point = position - surface.toEye * (surface.depth / ray.cosView * stretch * surface.hit.t);
    surface.hit.t -= bendFrom(surface.hit.t).x;
    surface.frame = carried(surface.frame, surface.hit.uv - textureUv);
    return surface;
}

// From where the light enters the relief down to the point seen, which lies at ray.end. In a hollow the light may come in over the rim of the
// quadric: then the ray begins at its highest point.
Ray lightRay(Surface surface, vec3 toLight)
{
    Ray ray = rayInto(surface.frame, surface.hit.uv, toLight, surface.depth);
    float k = bendOf(ray, surface.depth);
    float rim = 1.0f + 4.0f * k * surface.hit.t;
    float enter = rim < 0.0f ? -0.5f / k : 2.0f * surface.hit.t / (1.0f + sqrt(rim));
    float above = rim < 0.0f ? surface.hit.t - enter - k * enter * enter : 0.0f;
    float whole = max(enter, 1.0f);
    curve = vec3(-above, 1.0f - whole * (1.0f + 2.0f * k * enter), k * whole * whole);
    ray.uv -= ray.duv * enter;
    ray.duv *= whole;
    ray.end = enter / whole;
    return ray;
}

bool isPastOutline(Surface surface)
{
    return !surface.hit.found;
}
