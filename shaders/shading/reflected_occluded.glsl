// How much of the surroundings' reflection the relief leaves, from what it leaves of their light on a matt surface (Lagarde and de Rousiers 2014,
// Moving Frostbite to Physically Based Rendering, section 4.10.2): all of that on the roughest surface, more on a smooth one.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float reflectedShare(Sky sky, float nv, float rough)
{
    return clamp(pow(nv + sky.open, exp2(-16.0f * rough * rough - 1.0f)) - 1.0f + sky.open, 0.0f, 1.0f);
}
