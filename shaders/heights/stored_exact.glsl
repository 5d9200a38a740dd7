// Texels to the last bit: what drivers decode whole numbers to is right to within rounding only, and a search of many steps makes a rounding
// error large.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// units: the largest whole number that the texture stores, which stands for 1; 0: it stores floats.
vec4 storedExactly(vec4 texel, float units)
{
    return units > 0.0f ? floor(texel * units + 0.5f) / units : texel;
}
