// The four corners of a cell of the finest level, in one gather.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// Corners of the cell between texel centres, fetched at the cell's exact centre so that no rounding of the filter can pick
// another cell: (h00, h10, h01, h11), the second index running down the image.
vec4 cornersAt(vec2 cell)
{
    vec4 gathered = textureGather(heightMap, (cell + 1.0f) / vec2(textureSize(heightMap, 0)), 0);
    return vec4(gathered.w, gathered.z, gathered.x, gathered.y);
}
