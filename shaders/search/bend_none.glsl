// A search on a flat polygon: its ray is straight. See search/bend_quadric.glsl.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec3 bendFrom(float t) { return vec3(0.0f); }
float bendRise(float t) { return 0.0f; }
float bendLeast(float from, float to) { return 0.0f; }
float leastHeight(float z, float ahead) { return z - ahead; }
float depthRate() { return 1.0f; }
bool endsOnFloor(Ray ray) { return ray.end >= 1.0f; }
