// View: the depth that the search found, as a share of the relief's depth.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float viewValue(Surface surface)
{
    return surface.hit.t;
}
