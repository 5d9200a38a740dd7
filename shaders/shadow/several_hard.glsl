// Hard self-shadow of one of several lights: one ray to its middle.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float lightReaching(Surface surface, Light light)
{
    return lightIsHidden(surface, light.toLight) ? 1.0f - shadowStrength : 1.0f;
}
