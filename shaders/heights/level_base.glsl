// The search reads the finest level.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
int searchLevel()
{
    return 0;
}
vec2 searchSize()
{
    return vec2(textureSize(heightMap, 0));
}
