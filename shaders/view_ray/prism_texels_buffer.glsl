// The mesh's texels in a buffer.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec4 prismTexel(int i)
{
    return texelFetch(prismMap, i);
}
