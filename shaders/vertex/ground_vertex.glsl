// Vertex stage of the floor: a square around the mesh. groundPlace: see output/ground.glsl.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
out vec3 position;

void main()
{
    vec2 corner = (vec2(float(gl_VertexID % 2), float(gl_VertexID / 2)) * 2.0f - 1.0f) * groundPlace[1].w;
    position = vec3(groundPlace[0].x + corner.x, groundPlace[0].w, groundPlace[0].z + corner.y);
    gl_Position = clipFromWorld * vec4(position, 1.0f);
}
