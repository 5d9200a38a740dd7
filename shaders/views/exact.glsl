// What the exact search finds along a pixel's ray.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct Exact {
    bool found;
    float ahead; // of the search's hit, across the surface, share of the relief's depth; positive: that is deeper
};
