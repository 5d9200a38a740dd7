// No sheen.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float belowSheen(ShadingPoint point, float cosine)
{
    return 1.0f;
}

vec3 sheenReflected(ShadingPoint point, vec3 toLight)
{
    return vec3(0.0f);
}

vec3 sheenAround(ShadingPoint point)
{
    return vec3(0.0f);
}
