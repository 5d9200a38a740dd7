// The linear search that engines share: layers at equal depths, the first that is not above the relief, and the line between its sample and the
// one before. An engine's flat mesh is where its ray begins; it cuts no silhouettes and always ends on something.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "search/secant.glsl"

struct Layers {
    float outside; // depth of the last sample above the relief, share of the search's way
    float inside; // ... and of the first that is not
    float gapOutside; // ray height minus relief height there
    float gapInside;
    int fetches;
};

// Samples at 0, 1 / layers ... last / layers of the way. touching: a sample on the relief itself ends the search; else it goes on.
Layers layersDown(vec2 uv, vec2 way, float layers, int last, bool touching)
{
    Layers found = Layers(0.0f, 0.0f, 0.0f, 0.0f, 0);
    for (int i = 0; i <= last; ++i) {
        found.inside = float(i) / layers;
        found.gapInside = 1.0f - found.inside - heightAt(uv + way * found.inside);
        ++found.fetches;
        record(kLinear, found.inside);
        if (touching ? found.gapInside <= 0.0f : found.gapInside < 0.0f)
            break;
        found.outside = found.inside;
        found.gapOutside = found.gapInside;
    }
    return found;
}

float betweenLayers(Layers found)
{
    return min(secantOf(found.outside, found.inside, found.gapOutside, found.gapInside), 1.0f);
}

// What is drawn when an engine walks only `share` of the ray's way for the full depth: the texture found at depth t of its search is that of the
// view ray at share * t, so there the eye sees it.
Hit drawnInLayers(Ray ray, float share, float layers, bool readsAgain)
{
    vec2 way = ray.duv * share;
    recordShare(share);
    Layers found = layersDown(ray.uv, way, layers, int(layers) + 1, true);
    if (readsAgain) { // the sample before is not kept but read once more
        found.gapOutside = 1.0f - found.outside - heightAt(ray.uv + way * found.outside);
        ++found.fetches;
    }
    float t = share * betweenLayers(found);
    recordShare(1.0f);
    record(kSecant, t);
    return Hit(ray.uv + ray.duv * t, t, true, found.fetches);
}
