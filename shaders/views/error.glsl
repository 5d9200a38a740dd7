// View: how far the depth found is from the exact first hit, as a share of the relief's depth.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "exact_walk.glsl"

float viewValue(Surface surface)
{
    if (surface.depth <= 0.0f)
        return 0.0f; // a plain part has no relief to be wrong about
    float exact = exactDepth(sightRay(textureFrame(), surface.toEye, surface.depth));
    return abs(surface.hit.t - (exact - bendFrom(exact).x));
}
