// View: pixels whose light is not a number, as 1. There should be none.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float viewValue(Surface surface)
{
    vec3 light = shade(surface);
    return light.r - light.r == 0.0f && light.g - light.g == 0.0f && light.b - light.b == 0.0f ? 0.0f : 1.0f;
}
