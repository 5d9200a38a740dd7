// What the eye sees of a lit surface: lights, surroundings, its own light.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 shade(Surface surface)
{
    vec2 uv = surface.hit.uv;
    ShadingPoint point = shadingPointOf(surface);
    float occlusion = mix(1.0f, aoAt(uv, surface.footprint), aoStrength);
    return reflectedLights(surface, point) + shoneAround(surface, point) * (environmentIntensity * occlusion)
        + emissionAt(uv, surface.footprint) * (emission * emittedShare(point));
}
