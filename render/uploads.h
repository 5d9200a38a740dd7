// Textures and buffers of a scene in one OpenGL context, uploaded when a program first reads them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/source.h"
#include "render/gl_objects.h"
#include "render/program.h"
#include <array>
#include <memory>
#include <string>

namespace relievo {

// A height field as a texture with linear filtering and mip levels: R16 when its source had at most 16 bits (exact, and not
// filtered in 8-bit fixed point as R8 is on some rasterisers), R32F else.
Texture uploadHeight(const HeightField& field, bool mips = true);

class Uploads {
public:
    // Forgets what belongs to other resources than these.
    void hold(const Resources& resources);

    // Binds the maps, the environment and their sizes that the program reads; uploads those that are missing.
    void bindMaps(const LinkedProgram& program, Wrap wrap);

    // Draws all triangles of the mesh. Attribute locations are those of mesh_vertex.glsl.
    // pushed: with the directions of core/mesh/push.h, which are made only then.
    void drawMesh(bool pushed);

    // How many textures lie in the context: tests see that nothing unused is uploaded.
    int textureCount() const;

private:
    struct Map {
        Texture texture;
        float levels = 0.f; // log2 of the longest side
    };
    const Map& map(MapKind kind);
    const Map& slopes(Wrap wrap);
    static void bindMap(const LinkedProgram& program, const std::string& sampler, const Map& map, Wrap wrap, int unit);

    Resources m_resources;
    std::array<std::shared_ptr<const void>, kMapKindCount> m_uploadedMaps; // whose pixels lie in m_maps
    std::array<Map, kMapKindCount> m_maps;
    Map m_slopes; // of the height map, for materials without a normal map
    std::shared_ptr<const void> m_uploadedSlopes;
    Wrap m_slopesWrap = Wrap::Repeat;
    Texture m_environment;
    VertexArray m_vertexArray;
    Buffer m_vertices, m_indices, m_push;
};

} // namespace relievo
