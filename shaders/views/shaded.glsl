// View: the lit material.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 viewColor(Surface surface)
{
    return shade(surface);
}
