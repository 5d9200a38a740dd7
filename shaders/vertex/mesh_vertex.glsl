// Vertex stage of the mesh: pushes the surface out so that the midlevel lies on the mesh (ARCHITECTURE.md, "Space, sign and unit").
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
layout(location = 2) in vec2 vertexUv;
out vec3 position;
out vec3 surfaceNormal;
out vec2 textureUv;
out vec3 dPdu;
out vec3 dPdv;

void main()
{
    Placed at = curved(placed());
    position = at.position + at.push * pushOut;
    surfaceNormal = at.normal;
    textureUv = textureFromMesh * vertexUv + textureShift;
    // The Jacobian per unit of texture uv: columns times the inverse of the material's turn and tiling.
    dPdu = at.alongU * meshFromTexture[0][0] + at.alongV * meshFromTexture[0][1];
    dPdv = at.alongU * meshFromTexture[1][0] + at.alongV * meshFromTexture[1][1];
    gl_Position = clipFromWorld * vec4(position, 1.0f);
}
