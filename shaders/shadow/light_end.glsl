// A shadow ray on its way down to the point seen, and where it ends.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
struct LightWay {
    Ray ray;
    float fall; // how much it sinks for each unit of t
    bool atPoint; // it ends at the point, not where the way to it goes on
    float room; // what is still to be taken off where it goes on
};
struct LightEnd {
    float end; // of the ray
    float room;
    bool faces; // the point's patch faces the light
};
