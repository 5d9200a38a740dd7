// How straight the normals of a pixel stand: the length of their mean, as the mip level holds it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float normalLength(Surface surface)
{
    const float kRounding = 0.006f; // of normals in 8 bits
    return clamp(length(normalAt(surface.hit.uv, surface.footprint) * 2.0f - 1.0f) + kRounding, 0.05f, 1.0f);
}
