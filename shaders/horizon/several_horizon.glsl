// Self-shadow of one of several lights by horizons, soft where it has a size.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float lightReaching(Surface surface, Light light)
{
    return 1.0f - shadowStrength * (1.0f - shareAbove(surface, light.toLight, light.radius));
}
