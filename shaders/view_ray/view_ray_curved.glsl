// Looking at a curved surface (Oliveira and Policarpo 2005; RTM report, section 4.4): the view ray may leave the relief again, and where
// it does so without a hit the pixel is past the outline. Near a point the surface falls below its tangent plane by a quadric; ours has the
// mixed term, which the papers leave out.
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

// A ray sees the surface as a circle: radius and relief are told by the narrowing c = depth / radius, negative in hollows. Ways along it are
// measured by w, its shift in texture space over that of a ray into a plane down to the full depth, since that is what the search sees.
float stretch = 1.0f; // w at the end of the search along the view ray
float narrowing = 0.0f; // c of that ray

// Way in space of a w, in ways to the full depth below a plane.
float wayAt(Ray ray, float c, float w)
{
    float angle = w * c * sqrt(max(1.0f - ray.cosView * ray.cosView, 0.0f)) / ray.cosView;
    return w / (1.0f / (1.0f + angle * angle / 3.0f) + c * w);
}

// The ray comes to the floor, where it has the depth 1, or passes the circle's middle at less and leaves again. The search sees a parabola
// that begins with the same slope and ends on the floor where the ray does, or is as deep at its deepest.
Ray viewRay(Frame frame, vec3 toEye, float depth)
{
    Ray ray = rayInto(frame, textureUv, toEye, depth);
    float c = narrowingOf(ray, depth);
    float sine = sqrt(max(1.0f - ray.cosView * ray.cosView, 0.0f));
    float room = ray.cosView * ray.cosView - c * (2.0f - c);
    if (room < 0.0f) {
        stretch = 4.0f * ray.cosView * ray.cosView / ((1.0f + sine) * c);
        curve = vec3(0.0f, 1.0f - stretch, stretch);
    } else {
        float share = (2.0f - c) / ((1.0f - c) * (ray.cosView + sqrt(room)));
        stretch = share * ray.cosView * overSine(min(share * c * sine, 1.0f));
        curve = vec3(0.0f, 1.0f - stretch, stretch - 1.0f);
    }
    narrowing = c;
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
Surface searched(Surface surface)
{
    Ray ray = viewRay(surface.frame, surface.toEye, surface.depth);
    surface.hit = trace(ray);
    surface.point = position - surface.toEye * (surface.depth / ray.cosView * wayAt(ray, narrowing, stretch * surface.hit.t));
    surface.hit.t -= bendFrom(surface.hit.t).x;
    surface.frame = carried(surface.frame, surface.hit.uv - textureUv);
    return surface;
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

bool isPastOutline(Hit hit)
{
    return !hit.found || crossesBorder(textureUv, hit.uv);
}
