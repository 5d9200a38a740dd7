// Hard self-shadow: one ray to the middle of the light.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float lightReaching(Surface surface)
{
    return lightIsHidden(surface, lightDirection) ? 1.0f - shadowStrength : 1.0f;
}
