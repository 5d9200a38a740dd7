// Of the surface's own light all is seen.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float emittedShare(ShadingPoint point)
{
    return 1.0f;
}
