// No clear coat.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float coatShare(Surface surface)
{
    return 0.0f;
}

vec3 coatReflected(Surface surface, vec3 toLight)
{
    return vec3(0.0f);
}

vec3 coatAround(Surface surface)
{
    return vec3(0.0f);
}
