// No vignette.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 throughLens(vec3 color, vec3 fromEye)
{
    return color;
}
