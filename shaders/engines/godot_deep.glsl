// Godot's deep parallax, 3 and 4 alike: layers by the angle, their count not rounded. The view vector is not divided by its height, so that the
// depth drawn is the depth times the cosine of the angle.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "engines/layers.glsl"

Hit drawnByGodot(Ray ray)
{
    return drawnInLayers(ray, ray.cosView, mix(float(maxSteps), float(minSteps), ray.cosView), true);
}
