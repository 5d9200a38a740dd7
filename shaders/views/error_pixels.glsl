// View: the way between the place of the texture that is shown and the exact one, in pixels of the picture (footprintOf).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "exact/exact.glsl"

float viewValue(Surface surface)
{
    return surface.depth <= 0.0f ? 0.0f : length(surface.hit.uv - exactOf(surface).uv) * exp2(-surface.footprint);
}
