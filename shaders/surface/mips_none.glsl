// No mip mapping: the finest level, however far away.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float mapLevel(float level)
{
    return 0.0f;
}
