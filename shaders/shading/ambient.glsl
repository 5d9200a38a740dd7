// Light from the surroundings by formula, for programs that have no prefiltered panorama: bright above, dim below.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 irradiance(vec3 normal)
{
    return mix(vec3(0.25f, 0.24f, 0.23f), vec3(0.95f, 1.0f, 1.05f), 0.5f + 0.5f * normal.y);
}

vec3 reflection(vec3 direction, float rough)
{
    float horizon = mix(0.05f, 1.0f, rough); // a matt surface sees both
    return mix(vec3(0.25f, 0.24f, 0.23f), vec3(0.95f, 1.0f, 1.05f), smoothstep(-horizon, horizon, direction.y));
}
