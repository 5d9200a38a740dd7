// The relief keeps a share of the surroundings' light away, and what arrives comes from where it is open: the bent normal.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "horizon/sky_open.glsl"

Sky skyOver(Surface surface, vec3 normal)
{
    return openSky(surface, normal);
}
