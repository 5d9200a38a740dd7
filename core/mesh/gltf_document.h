// A glTF file as tinygltf's model, its buffers loaded, nothing in it validated but the version and the extensions it needs.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/error.h"
#include <cstddef>
#include <filesystem>
#include <tiny_gltf.h>
#include <vector>

namespace relievo {

// .gltf or .glb by content, not by suffix. Pictures are not loaded. Errors name the file and the cure.
struct GltfDocument {
    tinygltf::Model model;
    Warnings warnings; // "gltf-types": members of the wrong type, which are ignored
};
Expected<GltfDocument> loadGltf(const std::filesystem::path& file);

// The undecoded bytes of the picture with number `picture` of its "images", when they are in the file itself or in one of its buffers.
Expected<std::vector<std::byte>> loadGltfPicture(const std::filesystem::path& file, int picture);

} // namespace relievo
