// The tile ends: beyond its borders their texels go on.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool clamped()
{
    return true;
}
