// Self-shadow of one of several lights, soft where that has a size.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "shadow/shadow_disc.glsl"

float lightReaching(Surface surface, Light light)
{
    if (light.radius > 0.0f)
        return 1.0f - shadowStrength * (1.0f - shareReaching(surface, light.toLight, light.radius));
    return lightIsHidden(surface, light.toLight) ? 1.0f - shadowStrength : 1.0f;
}
