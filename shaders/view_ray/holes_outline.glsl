// Pixels past the outline are cut out; what is not opaque shows what is behind it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool isHole(Surface surface)
{
    return isPastOutline(surface.hit);
}
