// View: how far the point seen is from where the displaced mesh itself is hit (core/trace/displaced_mesh.h), across the surface, as a share
// of the relief's depth; 1 where the displaced mesh leaves the pixel free. Negative where the displaced mesh is itself too coarse to tell.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
const float kSure = 0.1f; // share of what is shown that its own error may be; of half the range where less is shown

float viewValue(Surface surface)
{
    vec4 exact = texelFetch(exactMap, ivec2(gl_FragCoord.xy), 0); // distance, and how uncertain it is
    if (exact.x < 0.0f)
        return 0.0f; // the back of an open mesh, which has no relief of its own
    float across = clamp(dot(surface.start.normal, surface.toEye), 0.0f, 1.0f) / max(surface.depth, 1e-9f);
    float value = min(abs(distance(surface.point, eye) - exact.x) * across, 1.0f);
    bool isSure = exact.y * across <= kSure * max(value, 0.5f / heatScale);
    return isSure ? value : -max(value, 1e-6f);
}
