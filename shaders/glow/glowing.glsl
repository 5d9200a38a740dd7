// Fragment stage: the picture with its glow. A share of what glows is taken from where it is and spread around it. glowPlace: the
// picture's lower left corner in the whole one, pixels, and the size of a pixel there, as a share of it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "glow/smooth.glsl"
#include "glow/excess.glsl"
layout(location = 0) out vec4 fragment;

void main()
{
    vec4 shown = texelFetch(shownPicture, ivec2(gl_FragCoord.xy), 0);
    vec4 light = texelFetch(lightPicture, ivec2(gl_FragCoord.xy), 0);
    vec2 uv = (gl_FragCoord.xy + vec2(glowPlace)) * vec2(glowPlace.z, glowPlace.w);
    vec3 light3 = vec3(light.r, light.g, light.b);
    fragment = vec4(withLight(shown, light, (smoothAt(uv) - excessOf(light3)) * bloom), shown.a);
}
