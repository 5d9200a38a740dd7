// Looking at a surface taken for flat: the view ray and the ray from the light are straight.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Ray viewRay(Frame frame, vec3 toEye, float depth)
{
    return rayInto(frame, textureUv, toEye, depth);
}

// What the pixel sees: fills hit and point.
Surface searched(Surface surface)
{
    Ray ray = viewRay(surface.frame, surface.toEye, surface.depth);
    surface.hit = trace(ray);
    surface.point = position - surface.toEye * (surface.depth / ray.cosView * (surface.hit.t - meshDepth));
    return surface;
}

// From where the light enters the relief down to the point seen, which lies at ray.end.
Ray lightRay(Surface surface, vec3 toLight)
{
    Ray ray = rayInto(surface.frame, surface.hit.uv, toLight, surface.depth);
    ray.uv -= ray.duv * surface.hit.t;
    ray.end = surface.hit.t;
    return ray;
}

bool isPastOutline(Hit hit)
{
    return false;
}
