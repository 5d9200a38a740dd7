// What a point of the relief sees of the surroundings.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct Sky {
    float open; // share of the light that reaches a matt surface there
    vec3 toOpen; // unit, where that comes from, on average
};

// The surroundings' light on a matt surface, as irradiance() has it.
vec3 skyLight(Sky sky)
{
    return irradiance(sky.toOpen) * sky.open;
}
