// Whether the tile repeats is not known before the rays come.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
bool clamped()
{
    return wrap == 1;
}
