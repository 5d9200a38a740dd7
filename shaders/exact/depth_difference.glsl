// By how much the depth found exceeds that of the exact first hit, as a share of the relief's depth; 1 where the search misses it, -1 where it finds
// what is not there.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float depthDifference(Surface surface)
{
    if (surface.depth <= 0.0f)
        return 0.0f; // a plain part has no relief to be wrong about
    Exact exact = exactOf(surface);
    bool found = !isPastOutline(surface.hit);
    if (found != exact.found)
        return found ? -1.0f : 1.0f;
    return clamp(exact.ahead, -1.0f, 1.0f);
}
