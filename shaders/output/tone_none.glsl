// Tone curve "none": what is brighter than the screen is cut off.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 toned(vec3 color)
{
    return color;
}
