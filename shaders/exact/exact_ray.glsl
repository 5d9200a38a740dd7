// The exact first hit along the ray that the search was given, straight or bent.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "exact/exact.glsl"

Exact exactAlong(Surface surface)
{
    Ray ray = viewRay(surface.start, surface.toEye, surface.depth);
    ray.uv -= ray.duv * meshDepth; // from where white would lie
    float t = exactDepth(ray);
    Hit hit = Hit(ray.uv + ray.duv * t, t, t < 1.0f || endsOnFloor(ray), 0);
    return Exact(!isPastOutline(hit), surface.hit.t - (t - bendFrom(t).x), hit.uv);
}
