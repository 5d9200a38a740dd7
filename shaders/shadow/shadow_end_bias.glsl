// Where the shadow ray of a search that may miss by some ends: the user's bias above the point.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float shadowRoom(vec2 uv)
{
    return shadowBias; // share of the depth
}

// Takes the point's own surroundings off the ray's end. room: what of shadowRoom() is still to be taken off; fall: how much the ray sinks for
// each unit of t.
bool endsBeforePoint(inout Ray ray, inout float room, float fall, bool atPoint)
{
    fall = max(fall, 1e-12f);
    float without = min(room / fall, ray.end);
    room -= without * fall;
    ray.end -= without;
    return true;
}
