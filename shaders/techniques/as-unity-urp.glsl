// As Unity's Universal Render Pipeline draws the Lit shader's height map. By its published formula (ParallaxOffset1Step).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "engines/unity_step.glsl"

Hit trace(Ray ray)
{
    return drawnByUnity(ray);
}
