// A vertex as it lies in the mesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
#include "vertex/placed.glsl"

Placed placed()
{
    return Placed(vertexPosition, vertexNormal, vertexPush, vertexDPdu, vertexDPdv, vec3(0.0f), 1.0f);
}
