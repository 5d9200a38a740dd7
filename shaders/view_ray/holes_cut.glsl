// Pixels that show nothing of the surface are cut out: holes of the material, and what is past the outline.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool isHole(Surface surface)
{
    return isPastOutline(surface.hit) || opacityAt(surface.hit.uv, surface.footprint) < 0.5f;
}
