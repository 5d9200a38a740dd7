// View: how far the depth found is from the exact first hit, as a share of the relief's depth.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "exact_walk.glsl"

float viewValue(Surface surface)
{
    float exact = exactDepth(sightRay(textureFrame(), surface.toEye, surface.depth));
    return abs(surface.hit.t - (exact - bendFrom(exact).x));
}
