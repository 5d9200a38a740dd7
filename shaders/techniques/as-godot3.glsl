// As Godot 3 draws a SpatialMaterial with deep parallax: depth_scale is the depth, its texture the heights turned over. The formula is Godot 4's.
// Godot 3.2.3, its own shader text.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "engines/godot_deep.glsl"

Hit trace(Ray ray)
{
    return drawnByGodot(ray);
}
