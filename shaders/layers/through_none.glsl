// No light goes through.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float throughShare()
{
    return 0.0f;
}

vec3 lightThrough(Surface surface, ShadingPoint point)
{
    return vec3(0.0f);
}
