// Pixels that would be cut out are drawn, for the view that shows them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool isHole(Surface surface)
{
    return false;
}
