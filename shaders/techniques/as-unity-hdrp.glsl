// As Unity's High Definition Render Pipeline draws pixel displacement: layers (_PPDMinSamples and _PPDMaxSamples are the step counts), then up to
// three secant steps, which end within 0.01 of the depth. The angle that the layers follow is that of the view in a space stretched by the depth,
// whose tangent is |duv|: shallow relief gets few layers at any view. By its published formula (PerPixelDisplacement); it fades out by mip level, which the finest never does.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "engines/layers.glsl"

Hit trace(Ray ray)
{
    int layers = max(int(mix(float(minSteps), float(maxSteps), atan(length(ray.duv)) * 0.63661977f)), 1);
    Layers found = layersDown(ray.uv, ray.duv, float(layers), layers + 1, false);
    float t = found.inside;
    for (int i = 0; i < 3; ++i) {
        t = betweenLayers(found);
        float gap = 1.0f - t - heightAt(ray.uv + ray.duv * t);
        ++found.fetches;
        record(kSecant, t);
        if (abs(gap) <= 0.01f)
            break;
        if (gap < 0.0f) {
            found.inside = t;
            found.gapInside = gap;
        } else {
            found.outside = t;
            found.gapOutside = gap;
        }
    }
    return Hit(ray.uv + ray.duv * t, t, true, found.fetches);
}
