// How much of one of several lights arrives: past the relief itself, and past other objects.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float shareArriving(Surface surface, Light light)
{
    float reaching = light.casts ? lightReaching(surface, light) : 1.0f;
    return light.passes ? min(reaching, lightPassing(surface)) : reaching;
}
