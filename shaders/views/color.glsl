// View: base color where the search lands, unlit.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#define UNLIT

vec3 viewColor(Surface surface)
{
    return colorAt(surface.hit.uv, surface.footprint) * tint;
}
