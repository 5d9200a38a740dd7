// Where the shadow ray of a search that may miss by some ends: the user's bias above the point.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "shadow/light_end.glsl"

// Takes the point's own surroundings off the ray's end: shares of the depth.
LightEnd endBeforePoint(LightWay way)
{
    float room = way.atPoint ? shadowBias : way.room;
    float fall = max(way.fall, 1e-12f);
    float without = min(room / fall, way.ray.end);
    return LightEnd(way.ray.end - without, room - without * fall, true);
}
