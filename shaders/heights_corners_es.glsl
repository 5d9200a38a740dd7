// The four corners of a cell in GLSL ES 3.00, which has no gather.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec4 cornersAt(vec2 cell)
{
    return cornersOf(ivec2(cell), textureSize(heightMap, searchLevel()), searchLevel());
}
