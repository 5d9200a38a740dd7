// Vertex stage of passes over every pixel: one triangle.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
void main()
{
    gl_Position = vec4(gl_VertexID == 1 ? 3.0f : -1.0f, gl_VertexID == 2 ? 3.0f : -1.0f, 0.0f, 1.0f);
}
