// Fragment stage: the picture of what glows, at about half the size: the mean over the rectangle that a pixel of it covers, so that no light
// is lost at any size. glowPlace: in its first and second number, the rectangle's size, pixels; at most three.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "glow/excess.glsl"
layout(location = 0) out vec4 fragment;

void main()
{
    vec2 each = vec2(glowPlace.x, glowPlace.y);
    vec2 from = (gl_FragCoord.xy - 0.5f) * each;
    vec2 to = min(from + each, vec2(textureSize(lightPicture, 0)));
    ivec2 first = ivec2(from);
    vec3 sum = vec3(0.0f);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            ivec2 pixel = first + ivec2(x, y);
            vec2 share = min(to, vec2(pixel) + 1.0f) - max(from, vec2(pixel));
            if (share.x > 0.0f && share.y > 0.0f)
                sum += excessOf(texelFetch(lightPicture, pixel, 0).rgb) * (share.x * share.y);
        }
    fragment = vec4(sum / (each.x * each.y), 1.0f);
}
