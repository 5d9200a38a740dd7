// How far above a point its occluders must lie, as a share of the depth: the user's bias, for searches that miss by some of it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
float shadowSlack()
{
    return shadowBias;
}

// What of it a ray clears, for each unit of t, that sinks by `fall` meanwhile.
float slackCleared(Ray ray, float fall)
{
    return fall;
}
