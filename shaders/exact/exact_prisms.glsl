// The exact first hit along the ray through prisms that the search was given.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "exact/exact.glsl"

Exact exactAlong(Surface surface)
{
    searchesExactly = true;
    PrismHit exact = walkFromPixel(surface);
    searchesExactly = false;
    float across = clamp(dot(surface.start.normal, surface.toEye), 0.002f, 1.0f);
    return Exact(exact.hit.found, dot(exact.point - surface.point, surface.toEye) * across / surface.depth, exact.hit.uv);
}
