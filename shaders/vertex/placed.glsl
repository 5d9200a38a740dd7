// A vertex of the mesh where it is drawn, and what the mesh says of it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 vertexPosition;
layout(location = 1) in vec3 vertexNormal;
layout(location = 3) in vec3 vertexDPdu;
layout(location = 4) in vec3 vertexDPdv;
layout(location = 5) in vec3 vertexPush; // the way out that all vertices of a place share, so that hard edges do not tear

struct Placed {
    vec3 position; // m
    vec3 normal;
    vec3 push;
    vec3 alongU; // texture Jacobian, m per UV of the mesh
    vec3 alongV;
    vec3 fall; // what morph targets add to the curvature ...
    float fallScale; // ... and what joints make of the sum
};
