// The relief's normal where the search landed, in world space, from slopesAt(): the normal map, or the height map's own slopes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// slopesAt gives the surface's rise along image right and image up as tangent-space normal (x, y, z), OpenGL style.
vec3 reliefNormal(Surface surface)
{
    vec3 n = tangentNormalAt(surface.hit.uv, surface.footprint);
    n = vec3(n.x * normalStrength, n.y * normalStrength, n.z);
    vec3 tangent = surface.frame.gradU;
    vec3 bitangent = -surface.frame.gradV; // image up: v runs down
    float lengths = dot(tangent, tangent) * dot(bitangent, bitangent);
    if (lengths == 0.0f)
        return surface.frame.normal;
    // Normal maps know nothing of stretch: their axes are the unit directions of the texture's.
    return normalize(surface.frame.normal * n.z + normalize(tangent) * n.x + normalize(bitangent) * n.y);
}
