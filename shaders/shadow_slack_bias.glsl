// How far above a point its occluders must lie, as a share of the depth: the user's bias, for searches that miss by some of it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float shadowSlack(Ray ray)
{
    return shadowBias;
}
