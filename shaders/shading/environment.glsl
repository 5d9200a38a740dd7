// Light from the surroundings: a cube map whose levels are prefiltered by roughness (core/image/environment/prefilter.h), of 16 texels a side
// for roughness 1, and the last one, of 8, for matt surfaces.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 turned(vec3 direction)
{
    return vec3(environmentTurn.x * direction.x - environmentTurn.y * direction.z, direction.y,
        environmentTurn.y * direction.x + environmentTurn.x * direction.z);
}

float roughestLevel()
{
    return log2(float(textureSize(environmentMap, 0).x)) - 4.0f;
}

vec3 irradiance(vec3 normal)
{
    return textureLod(environmentMap, turned(normal), roughestLevel() + 1.0f).rgb;
}

vec3 reflection(vec3 direction, float rough)
{
    return textureLod(environmentMap, turned(direction), roughestLevel() * rough * (2.0f - rough)).rgb;
}
