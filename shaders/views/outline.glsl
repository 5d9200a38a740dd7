// View: what the silhouette cuts off, in red, over the surface in grey.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 viewColor(Surface surface)
{
    if (isPastOutline(surface.hit))
        return vec3(0.86f, 0.21f, 0.18f);
    float light = 0.25f + 0.6f * clamp(dot(surface.frame.normal, surface.toEye), 0.0f, 1.0f);
    return vec3(light * (1.0f - 0.5f * surface.hit.t));
}
