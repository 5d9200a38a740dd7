// As Unreal draws its material function ParallaxOcclusionMapping: Height Ratio is the depth, Reference Plane the midlevel, Min and Max Steps the
// step counts; a sample that only touches the relief is passed. By its published formula.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "engines/layers.glsl"

Hit trace(Ray ray)
{
    float layers = mix(float(maxSteps), float(minSteps), ray.cosView);
    Layers found = layersDown(ray.uv, ray.duv, layers, int(layers) + 1, false);
    float t = betweenLayers(found);
    record(kSecant, t);
    return Hit(ray.uv + ray.duv * t, t, true, found.fetches);
}
