// View: whether the search went through the first surface.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "exact/depth_difference.glsl"

const float kMissed = 0.02f; // share of the relief's depth: kMissedDepth of render/measure/picture_errors.h

float viewValue(Surface surface)
{
    return depthDifference(surface) > kMissed ? 1.0f : 0.0f;
}
