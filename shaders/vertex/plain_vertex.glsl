// Vertex stage for exported shaders: position, normal and uv (v down, as glTF's) in world space; all else is found for each pixel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 vertexPosition; // m, world space
layout(location = 1) in vec3 vertexNormal;
layout(location = 2) in vec2 vertexUv;
out vec3 position;
out vec3 surfaceNormal;
out vec2 textureUv;

void main()
{
    position = vertexPosition + vertexNormal * pushOut;
    surfaceNormal = vertexNormal;
    textureUv = textureFromMesh * vertexUv + textureShift;
    gl_Position = clipFromWorld * vec4(position, 1.0f);
}
