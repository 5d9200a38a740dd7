// View: how far the search goes through the first surface, as a share of the relief's depth.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "exact/depth_difference.glsl"

float viewValue(Surface surface)
{
    return max(depthDifference(surface), 0.0f);
}
