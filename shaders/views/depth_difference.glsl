// By how much the depth found exceeds that of the exact first hit, as a share of the relief's depth.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/exact_walk.glsl"

float depthDifference(Surface surface)
{
    if (surface.depth <= 0.0f)
        return 0.0f; // a plain part has no relief to be wrong about
    float exact = exactDepth(viewRay(surface.start, surface.toEye, surface.depth));
    return surface.hit.t - (exact - bendFrom(exact).x);
}
