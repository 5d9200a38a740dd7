// As Bevy draws a depth map by ParallaxMappingMethod::Occlusion: max_parallax_layer_count, the most steps, at grazing views, 1 layer seen from
// straight above, where the relief is interpolated between white and what lies under the point. By its published formula (parallax_mapping).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "engines/layers.glsl"

Hit trace(Ray ray)
{
    return drawnInLayers(ray, 1.0f, mix(float(maxSteps), 1.0f, ray.cosView), true);
}
