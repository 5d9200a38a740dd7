// From linear radiance to the screen: exposure, a tone curve, sRGB. Of colours that are not lit sRGB alone.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// The sRGB curve by square roots, which cost a fifth of pow: a least-squares fit of ours, within a tenth of an 8-bit step.
vec3 encodeSrgb(vec3 color)
{
    color = clamp(color, vec3(0.0f), vec3(1.0f));
    vec3 root = sqrt(color);
    vec3 curve = 0.83374029f * root + 0.29812332f * sqrt(root) - 0.05531710f * color - 0.07690754f;
    return mix(curve, color * 12.92f, vec3(lessThanEqual(color, vec3(0.0031308f))));
}

vec3 toDisplay(vec3 color)
{
#ifdef UNLIT
    return encodeSrgb(color);
#else
    return encodeSrgb(toned(max(color * exposureFactor, vec3(0.0f))));
#endif
}
