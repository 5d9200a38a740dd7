// Fragment stage: a picture of what glows at half or at twice its size, by a tent of its texels: all weights that one has add up alike.
// glowPlace: in its third and fourth number, the size of a pixel that is written, as a share of the picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
layout(location = 0) out vec4 fragment;

void main()
{
    vec2 texel = 1.0f / vec2(textureSize(glowPicture, 0));
    vec2 uv = gl_FragCoord.xy * vec2(glowPlace.z, glowPlace.w);
    vec3 sum = vec3(0.0f);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            sum += textureLod(glowPicture, uv + vec2(float(x), float(y)) * texel, 0.0f).rgb
                * (float((2 - abs(x)) * (2 - abs(y))) / 16.0f);
    fragment = vec4(sum, 1.0f);
}
