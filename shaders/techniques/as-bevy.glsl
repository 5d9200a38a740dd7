// As Bevy draws a depth map by ParallaxMappingMethod::Occlusion with its 16 layers at most: 1 where it is seen from straight above, so that there
// the relief is interpolated between white and what lies under the point. By its published formula (parallax_mapping).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "engines/layers.glsl"

Hit trace(Ray ray)
{
    return drawnInLayers(ray, 1.0f, mix(16.0f, 1.0f, ray.cosView), true);
}
