// View: the self-shadow alone, white where the light reaches.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 viewColor(Surface surface)
{
    return vec3(lightReaching(surface));
}
