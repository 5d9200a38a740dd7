// Self-shadow on a mesh as it is: the light is followed from prism to prism.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "shadow/prism_light.glsl"

bool lightIsHidden(Surface surface, vec3 toLight)
{
    float depth = gl_FrontFacing ? surface.depth : -surface.depth;
    return isHiddenFrom(seenTriangle, surface.hit.uv, surface.hit.t, surface.point, toLight, depth);
}
