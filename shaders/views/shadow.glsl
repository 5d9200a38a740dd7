// View: the shadow alone, white where the light reaches.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 viewColor(Surface surface)
{
    return vec3(min(lightReaching(surface), lightPassing(surface)));
}
