// The relief is equally deep everywhere.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float depthSeen(float cosView)
{
    return reliefDepth;
}
