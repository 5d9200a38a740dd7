// Hard self-shadow: one ray to the middle of the light.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float lightReaching(Surface surface)
{
    if (dot(surface.frame.normal, lightDirection) <= 0.0f)
        return 1.0f - shadowStrength; // the light comes from behind the surface
    return lightIsHidden(surface, lightDirection) ? 1.0f - shadowStrength : 1.0f;
}
