// Soft self-shadow, of a light with a size.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "shadow/shadow_disc.glsl"

float lightReaching(Surface surface)
{
    return 1.0f - shadowStrength * (1.0f - shareReaching(surface, lightDirection, tan(0.5f * radians(lightSize))));
}
