// The relief keeps a share of the surroundings' light away.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "horizon/sky_open.glsl"

Sky skyOver(Surface surface, vec3 normal)
{
    return Sky(openSky(surface, normal).open, normal);
}
