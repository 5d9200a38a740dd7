// View: how far the point seen is from where the displaced mesh itself is hit (core/trace/displaced_mesh.h), across the surface, as a share
// of the relief's depth; 1 where the displaced mesh leaves the pixel free.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float viewValue(Surface surface)
{
    float exact = texelFetch(exactMap, ivec2(gl_FragCoord.xy), 0).x;
    if (exact < 0.0f)
        return 0.0f; // the back of an open mesh, which has no relief of its own
    float across = clamp(dot(surface.start.normal, surface.toEye), 0.0f, 1.0f);
    return min(abs(distance(surface.point, eye) - exact) * across / max(surface.depth, 1e-9f), 1.0f);
}
