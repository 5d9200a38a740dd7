// As Unity's High Definition Render Pipeline draws pixel displacement: 5 to 15 layers, then up to three secant steps, which end within 0.01 of the
// depth. The angle that the layers follow is that of the view in a space stretched by the depth, tan = |duv|: shallow relief gets few layers at any
// view. By its published formula (PerPixelDisplacement); it fades out by mip level, which the finest never does.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "engines/layers.glsl"

Hit trace(Ray ray)
{
    int layers = clamp(int(mix(5.0f, 15.0f, atan(length(ray.duv)) * 0.63661977f)), 5, 15);
    Layers found = layersDown(ray.uv, ray.duv, float(layers), layers + 1, false);
    float t = found.inside;
    for (int i = 0; i < 3; ++i) {
        t = betweenLayers(found);
        float gap = 1.0f - t - heightAt(ray.uv + ray.duv * t);
        ++found.fetches;
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
