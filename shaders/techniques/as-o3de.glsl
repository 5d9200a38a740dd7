// As O3DE draws the parallax of its Standard PBR material, algorithm POM with offset 0: a fixed count of layers whatever the angle, the 32 of quality
// Medium, which the export writes. By its published formula (AdvancedParallaxMapping).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "engines/layers.glsl"

Hit trace(Ray ray)
{
    return drawnInLayers(ray, 1.0f, 32.0f, false);
}
