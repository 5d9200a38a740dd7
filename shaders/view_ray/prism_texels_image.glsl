// The mesh's texels in rows of 1024: ES 3.00 has no buffers.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec4 prismTexel(int i)
{
    return texelFetch(prismImage, ivec2(i & 1023, i >> 10), 0);
}
