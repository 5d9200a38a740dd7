// Fragment stage of pictures shown in one place: one of two, parted by a line, or their difference; any of it enlarged.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
// firstPicture, secondPicture. composition, 0: corner and size of the place, pixels, y up. 1: corner and size of what is seen of the pictures, shares, y up. 2: the wipe's line: a point
// on it and its normal towards the second picture, pixels, y up. 3: how (Composition::How), gain, width of the line in pixels.
layout(location = 0) out vec4 fragment;

void main()
{
    vec2 at = gl_FragCoord.xy - composition[0].xy;
    vec2 uv = composition[1].xy + composition[1].zw * at / composition[0].zw;
    vec3 first = texture(firstPicture, uv).rgb;
    vec3 second = texture(secondPicture, uv).rgb;
    float how = composition[3].x, gain = composition[3].y;
    vec3 shown = how < 0.5f ? first : second;
    if (how > 1.5f) {
        float side = dot(at - composition[2].xy, composition[2].zw);
        float beyond = abs(side) - composition[3].z; // of the bright line, with a dark seam of its width on either side
        shown = side < 0.0f ? first : second;
        shown = mix(vec3(0.05f), shown, clamp(beyond - 0.5f * composition[3].z + 0.5f, 0.0f, 1.0f));
        shown = mix(vec3(0.95f), shown, clamp(beyond + 0.5f * composition[3].z + 0.5f, 0.0f, 1.0f));
    }
    if (how > 2.5f)
        shown = abs(second - first) * gain;
    if (how > 3.5f)
        shown = vec3(0.5f) + 0.5f * (second - first) * gain;
    fragment = vec4(clamp(shown, 0.0f, 1.0f), 1.0f);
}
