// A glTF file as tinygltf's model, its buffers loaded, nothing in it validated but the version and the extensions it needs.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <cstddef>
#include <filesystem>
#include <tiny_gltf.h>
#include <vector>

namespace relievo {

// .gltf or .glb by content, not by suffix. Errors name the file and the cure.
struct GltfDocument {
    tinygltf::Model model; // its pictures are not loaded: images hold nothing but uri and bufferView
    Warnings warnings; // "gltf-types": members of the wrong type, which are ignored
};
Expected<GltfDocument> loadGltf(const std::filesystem::path& file);

// Whether the picture is in the file itself (base64 data of any media type) or in one of its buffers.
bool holdsPicture(const tinygltf::Model& model, const tinygltf::Image& image);

// The undecoded bytes of the picture with number `picture` of its "images", when they are in the file itself or in one of its buffers.
Expected<std::vector<std::byte>> loadGltfPicture(const std::filesystem::path& file, int picture);

} // namespace relievo
