// The contract of every technique: what a search gets and what it returns (ARCHITECTURE.md, "The contract of a technique").
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct Ray {
    vec2 uv; // where the ray meets the polygon, t = 0
    vec2 duv; // change of uv from t = 0 to t = 1
    float cosView; // |N.V|, in (0, 1]
    float end; // the search ends at this t: 1, or the depth of the point that a shadow ray comes to
};
struct Hit {
    vec2 uv;
    float t; // 0 on the polygon, 1 deepest
    bool found;
    int fetches; // texture reads of the search
};
bool gaveUp = false; // whether the search has ended before it knew the answer, as its rounds are bounded; its hit means nothing then
