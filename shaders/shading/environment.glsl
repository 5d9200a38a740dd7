// Light from the surroundings: a cube map whose levels are prefiltered by roughness, the last one for matt surfaces.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 turned(vec3 direction)
{
    return vec3(environmentTurn.x * direction.x - environmentTurn.y * direction.z, direction.y,
        environmentTurn.y * direction.x + environmentTurn.x * direction.z);
}

vec3 irradiance(vec3 normal)
{
    return textureLod(environmentMap, turned(normal), 5.0f).rgb;
}

vec3 reflection(vec3 direction, float rough)
{
    return textureLod(environmentMap, turned(direction), rough * 4.0f).rgb;
}
