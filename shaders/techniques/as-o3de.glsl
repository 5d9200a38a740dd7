// As O3DE draws the parallax of its Standard PBR material, algorithm POM, the one that it proposes. Its quality is a fixed count whatever the
// angle, 16, 32, 64 or 128: the least that is not below the most steps. By its published formula (AdvancedParallaxMapping).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "engines/layers.glsl"

Hit trace(Ray ray)
{
    int layers = maxSteps <= 16 ? 16 : maxSteps <= 32 ? 32 : maxSteps <= 64 ? 64 : 128;
    return drawnInLayers(ray, 1.0f, float(layers), false);
}
