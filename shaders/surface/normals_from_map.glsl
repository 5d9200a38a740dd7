// The relief's normal where the search landed, in world space, from the material's normal map.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 reliefNormal(Surface surface)
{
    vec3 n = normalAt(surface.hit.uv, surface.footprint) * 2.0f - 1.0f;
    vec3 tangent = surface.frame.gradU;
    vec3 bitangent = -surface.frame.gradV; // image up: v runs down
    if (dot(tangent, tangent) * dot(bitangent, bitangent) == 0.0f)
        return surface.frame.normal;
    // Normal maps know nothing of depth and stretch: their axes are the unit directions of the texture's.
    return normalize(surface.frame.normal * max(n.z, 1e-3f)
        + (normalize(tangent) * n.x + normalize(bitangent) * n.y) * normalStrength);
}
