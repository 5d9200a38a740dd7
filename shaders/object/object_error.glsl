// How far the object's surface is from that of the mesh that it stands for, as a share of its box's diagonal.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float viewValue(Surface surface)
{
    float exact = texelFetch(exactMap, ivec2(gl_FragCoord.xy), 0).x; // distance; negative: a back, which the object may fill
    float diagonal = 2.0f * length(vec3(worldFromBox * vec4(1.0f, 1.0f, 1.0f, 0.0f)));
    return exact < 0.0f ? -1e-6f : min(abs(distance(surface.point, eye) - exact) / diagonal, 1.0f);
}
