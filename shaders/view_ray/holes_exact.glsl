// Pixels are cut out where neither the search nor the exact one finds the surface: what a search misses is an error to be seen.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool isHole(Surface surface)
{
    bool isEmpty = isPastOutline(surface.hit) && (surface.depth <= 0.0f || !exactOf(surface).found);
    return isEmpty || opacityAt(surface.hit.uv, surface.footprint) < 0.5f;
}
