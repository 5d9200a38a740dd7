// Tangent-space normals of the material's normal map.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 tangentNormalAt(vec2 uv, float footprint)
{
    vec3 n = normalAt(uv, footprint) * 2.0f - 1.0f;
    return vec3(n.x, n.y, max(n.z, 1e-3f));
}
