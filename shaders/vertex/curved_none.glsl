// The search takes the surface for flat around each pixel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Placed curved(Placed at)
{
    return at;
}
