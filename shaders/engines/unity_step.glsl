// Unity's height map without HDRP: one step by the height under the point, uv += (h A - A / 2) V.xy / (V.z + 0.42), where A, the material's
// Parallax, is the depth held within 0.005 and 0.08 of the tile. Mid-grey lies on the mesh, so t counts from half the depth above it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Hit drawnByUnity(Ray ray)
{
    float sine = sqrt(max((1.0f - ray.cosView) * (1.0f + ray.cosView), 0.0f));
    float way = length(ray.duv);
    float amplitude = clamp(way * ray.cosView / max(sine, 1e-20f), 0.005f, 0.08f);
    float stretch = way > 0.0f ? amplitude * sine / way : ray.cosView; // of the ray's way: A V.xy beside duv
    float share = (0.5f - heightAt(ray.uv)) * stretch / (ray.cosView + 0.42f);
    record(kOffset, clamp(0.5f + share, 0.0f, 1.0f));
    return Hit(ray.uv + ray.duv * share, clamp(0.5f + share, 0.0f, 1.0f), true, 1);
}
