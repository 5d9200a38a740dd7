// Fragment stage of the soft backdrop: grey, lighter behind the middle, whatever the exposure; a little noise hides its steps of 8 bits.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
in vec2 place;
layout(location = 0) out vec4 fragment;

float noise(vec2 pixel)
{
    return fract(52.9829189f * fract(dot(pixel, vec2(0.06711056f, 0.00583715f))));
}

void main()
{
    float away = length(place * vec2(0.75f, 0.9f));
    float lit = 1.0f - smoothstep(0.1f, 1.35f, away + 0.12f * place.y);
    vec3 shown = shownColor(vec3(mix(0.012f, 0.075f, lit)));
    fragment = vec4(shown + (noise(gl_FragCoord.xy) - 0.5f) / 255.0f, 1.0f);
}
