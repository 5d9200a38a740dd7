// The materials of a glTF file: their pictures, and which UVs they are mapped by.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include <glm/mat3x2.hpp>
#include <tiny_gltf.h>

namespace relievo {

// How a material's pictures lie on a mesh: uv = uvFromSet * (TEXCOORD_set, 1), from KHR_texture_transform.
struct TextureSpace {
    int set = 0;
    glm::mat3x2 uvFromSet{1.f, 0.f, 0.f, 1.f, 0.f, 0.f};
    bool operator==(const TextureSpace&) const = default;
    // Whether u still runs the way the file's tangents do.
    bool keepsTangents() const { return uvFromSet[0].x > 0.f && uvFromSet[0].y == 0.f && uvFromSet[1].x == 0.f && uvFromSet[1].y > 0.f; }
};

struct GltfMaterials {
    std::vector<MeshMaterial> materials; // in the order of the file; nameless ones are called "material N"
    std::vector<TextureSpace> spaces; // of each: that of its base colour, else of its normal map, and so on
    Warnings warnings; // "map-missing"; "uv-sets", "texture-transforms": a material's pictures disagree
};

// file: where pictures are looked for.
GltfMaterials readMaterials(const tinygltf::Model& model, const std::filesystem::path& file);

} // namespace relievo
