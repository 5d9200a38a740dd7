// The relief takes nothing from the light of the surroundings.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "horizon/sky.glsl"

Sky skyOver(Surface surface, vec3 normal)
{
    return Sky(1.0f, normal);
}
