// View: texture reads of the search at this pixel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float viewValue(Surface surface)
{
    return float(surface.hit.fetches);
}
