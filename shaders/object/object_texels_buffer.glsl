// The intervals of a relief object, from a buffer.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec2 objectTexel(int i)
{
    vec4 texel = texelFetch(objectMap, i);
    return vec2(texel.x, texel.y);
}
