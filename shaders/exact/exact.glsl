// What the exact search finds along a pixel's ray, searched once however often it is asked for.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct Exact {
    bool found;
    float ahead; // of the search's hit, across the surface, share of the relief's depth; positive: that is deeper
    vec2 uv; // where it is
};
Exact exactAnswer = Exact(false, 0.0f, vec2(0.0f));
bool isExactKnown = false;

Exact exactAlong(Surface surface); // exact/exact_ray.glsl or exact/exact_prisms.glsl

Exact exactOf(Surface surface)
{
    if (!isExactKnown)
        exactAnswer = exactAlong(surface);
    isExactKnown = true;
    return exactAnswer;
}
