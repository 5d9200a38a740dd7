// Writes the corners of a mesh and the tangents made for them, for tests/clients/mikktspace.sh to compare.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/frames/tangents.h"
#include "core/mesh/mesh.h"
#include <cstdio>
#include <fstream>

using namespace relievo;

// tangent_bench MESH OUT: twelve floats a corner: position, normal, u, v up, tangent.
int main(int count, char** arguments)
{
    if (count != 3)
        return std::fputs("tangent_bench MESH OUT\n", stderr), 2;
    const Expected<Mesh> mesh = openMesh(arguments[1]);
    if (!mesh)
        return std::fprintf(stderr, "%s\n", message(mesh.error()).c_str()), 1;
    std::ofstream out(arguments[2], std::ios::binary);
    const std::vector<glm::vec4> tangents = cornerTangents(*mesh);
    for (std::size_t i = 0; i < tangents.size(); ++i) {
        const Vertex& v = mesh->vertices[mesh->indices[i]];
        const float corner[12] = {v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z, v.uv.x, -v.uv.y,
            tangents[i].x, tangents[i].y, tangents[i].z, tangents[i].w};
        out.write(reinterpret_cast<const char*>(corner), sizeof corner);
    }
}
