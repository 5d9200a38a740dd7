// View: the relief's normal in world space, as n / 2 + 1/2.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 viewColor(Surface surface)
{
    return reliefNormal(surface) * 0.5f + 0.5f;
}
