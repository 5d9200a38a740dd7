// Cone maps by the texture unit's filter, at the level that is searched.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec4 boundAt(vec2 uv)
{
    return textureLod(boundMap, uv, heightLevel);
}
