// Mip levels of maps: by the pixel's size.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float mapLevel(float level)
{
    return max(0.0f, level);
}
