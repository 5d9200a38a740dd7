// Self-shadow of one directional light by horizons, soft where it has a size.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float lightReaching(Surface surface)
{
    return 1.0f - shadowStrength * (1.0f - shareAbove(surface, lightDirection, tan(0.5f * radians(lightSize))));
}
