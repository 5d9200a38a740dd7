// Light that comes to a pixel of linear values.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 withLight(vec4 shown, vec4 light, vec3 more)
{
    return vec3(shown.r, shown.g, shown.b) + more;
}
