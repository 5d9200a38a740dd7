// Vertex stage of the mesh: pushes the surface out so that the midlevel lies on the mesh (design.md section 3).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 vertexPosition;
layout(location = 1) in vec3 vertexNormal;
layout(location = 2) in vec2 vertexUv;
layout(location = 3) in vec3 vertexDPdu;
layout(location = 4) in vec3 vertexDPdv;
layout(location = 5) in vec3 vertexPush; // the way out that all vertices of a place share, so that hard edges do not tear
out vec3 position;
out vec3 surfaceNormal;
out vec2 textureUv;
out vec3 dPdu;
out vec3 dPdv;

void main()
{
    position = vertexPosition + vertexPush * pushOut;
    surfaceNormal = vertexNormal;
    textureUv = textureFromMesh * vertexUv + textureShift;
    // The Jacobian per unit of texture uv: columns times the inverse of the material's turn and tiling.
    dPdu = vertexDPdu * meshFromTexture[0][0] + vertexDPdv * meshFromTexture[0][1];
    dPdv = vertexDPdu * meshFromTexture[1][0] + vertexDPdv * meshFromTexture[1][1];
    gl_Position = clipFromWorld * vec4(position, 1.0f);
}
