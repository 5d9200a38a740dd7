// Shadows between objects: the depth that the light sees, with relief displaced, in a map (RTM report, section 4.4, "Shadows"). 1 lit.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float lightPassing(Surface surface)
{
    // Off the surface by as much as a texel of the map may be wrong about it; occluders in the relief itself are the search's.
    vec3 at = surface.point + surface.frame.normal * (1.5f * shadowTexel) + lightDirection * (2.0f * shadowTexel + 0.1f * surface.depth);
    vec4 clip = shadowFromWorld * vec4(at, 1.0f);
    vec3 p = vec3(clip.x, clip.y, clip.z) * 0.5f + 0.5f;
    float texel = 1.0f / float(textureSize(shadowMap, 0).x);
    float lit = 0.0f;
    for (int i = 0; i < 4; ++i)
        lit += texture(shadowMap, p + vec3(float(i % 2) - 0.5f, float(i / 2) - 0.5f, 0.0f) * texel) * 0.25f;
    return 1.0f - shadowStrength * (1.0f - lit);
}
