// View: how far the depth found is from the exact first hit, as a share of the relief's depth.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "exact/depth_difference.glsl"

float viewValue(Surface surface)
{
    return abs(depthDifference(surface));
}
