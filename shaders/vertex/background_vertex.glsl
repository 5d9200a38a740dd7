// Vertex stage of the background: one triangle over the whole picture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
out vec3 direction;
out vec2 place; // in the picture, -1 to 1

void main()
{
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0f : -1.0f, gl_VertexID == 2 ? 3.0f : -1.0f);
    place = corner;
    vec4 far = worldFromClip * vec4(corner, 1.0f, 1.0f);
    direction = far.xyz / far.w - eye;
    gl_Position = vec4(corner, 1.0f, 1.0f);
}
