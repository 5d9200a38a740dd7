// Textures of a scene in one OpenGL context, uploaded when a program first reads them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/scene/source.h"
#include "render/gl/gl_objects.h"
#include "render/gl/program.h"
#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

// A height field as a texture with linear filtering and mip levels: R16 when its source had at most 16 bits (exact, and not
// filtered in 8-bit fixed point as R8 is on some rasterisers), R32F else.
Texture uploadHeight(const HeightField& field, bool mips = true);

// A bound map as textures of its kind: floats with linear filter, whole numbers, or a volume. Wrap mode as given.
struct SearchUpload {
    Texture texture;
    GLenum target = GL_TEXTURE_2D;
    std::string_view sampler; // the name it has in shaders
    std::vector<glm::vec4> scales;
};
SearchUpload uploadSearchTexture(const SearchTexture& map, Wrap wrap);
void bindSearchTexture(const LinkedProgram& program, const SearchUpload& upload, int unit);

class Uploads {
public:
    // Forgets what belongs to other resources than these.
    void hold(const Resources& resources);

    // Binds the maps, the environment and their sizes that the program reads; uploads those that are missing.
    // bound: row of kMaps and texture of the technique, or nothing.
    void bindMaps(const LinkedProgram& program, Wrap wrap, std::string_view boundKey, const std::shared_ptr<const SearchTexture>& bound);

    // Resources::seen, for a program that reads it.
    void bindSeen(const LinkedProgram& program);

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
    Texture m_seen;
    std::shared_ptr<const SeenDistances> m_uploadedSeen;
    std::array<Map, 2> m_slopes; // of the height map by wrap, for materials without a normal map
    std::shared_ptr<const void> m_uploadedSlopes; // of which height map
    struct UploadedBound {
        std::shared_ptr<const SearchTexture> map;
        SearchUpload upload;
    };
    std::map<Resources::BoundKey, UploadedBound> m_bounds;
    Texture m_environment;
};

} // namespace relievo
