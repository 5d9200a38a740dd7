// As PlayCanvas from 2.22 on draws parallax occlusion with heightMapBase the midlevel and parallaxSamples 16: a layer for each two texels of the way, then five
// halvings. The slope is capped at 5, and where the way is shorter than three texels the relief fades out.
// PlayCanvas 2.23, run: its texture coordinates are these to 0.0005.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Hit trace(Ray ray)
{
    float sine = sqrt(max((1.0f - ray.cosView) * (1.0f + ray.cosView), 0.0f));
    float share = sine > 5.0f * ray.cosView ? 5.0f * ray.cosView / sine : 1.0f;
    vec2 way = ray.duv * share;
    float texels = length(way * vec2(textureSize(heightMap, 0)));
    float layers = clamp(0.5f * texels, 1.0f, 16.0f);
    recordShare(share);
    float t = 0.0f;
    float outside = 0.0f;
    float depthThere = 1.0f - heightAt(ray.uv);
    int fetches = 1;
    record(kLinear, 0.0f);
    for (int i = 1; i <= 16; ++i) {
        if (float(i) >= layers + 1.0f || t >= depthThere)
            break;
        outside = t;
        t = float(i) / layers;
        depthThere = 1.0f - heightAt(ray.uv + way * t);
        ++fetches;
        record(kLinear, t);
    }
    if (t >= depthThere) {
        float reach = 0.5f * (t - outside);
        t -= reach;
        for (int i = 0; i < 5; ++i) {
            float at = t;
            reach *= 0.5f;
            t += at >= 1.0f - heightAt(ray.uv + way * at) ? -reach : reach;
            ++fetches;
            recordHalving(t - reach, t + reach, at);
        }
    }
    t = share * clamp(0.5f * texels - 0.5f, 0.0f, 1.0f) * clamp(t, 0.0f, 1.0f);
    recordShare(1.0f);
    record(kOffset, t);
    return Hit(ray.uv + ray.duv * t, t, true, fetches);
}
