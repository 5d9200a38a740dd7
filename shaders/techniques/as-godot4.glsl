// As Godot 4 draws a StandardMaterial3D with deep parallax: heightmap_scale is 100 times the depth, its layers are the step counts.
// Godot 4.6, run: its texture coordinates are these to 0.0003 where the height map has no mipmaps.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "engines/godot_deep.glsl"

Hit trace(Ray ray)
{
    return drawnByGodot(ray);
}
