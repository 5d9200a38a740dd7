// How far a ray goes on until it meets the cone below it (Dummer 2006; GPU Gems 3, listing 18-3).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// above: height over the cone's apex; ratio: the cone's radius per height; travel: the ray's way in uv over the full depth; rise: how fast
// heights rise by the bend of the surface, per depth.
float coneLeap(float above, float ratio, float travel, float rise)
{
    return travel > 0.0f ? above * ratio / (ratio * (1.0f + rise) + travel) : above / (1.0f + rise);
}
