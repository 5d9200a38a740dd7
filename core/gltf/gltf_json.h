// The JSON of a glTF file, checked and mended where tinygltf would stumble over it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <filesystem>
#include <tiny_gltf.h>

namespace relievo {

inline constexpr const char* kDamagedGltf = "Check the file with a glTF validator and export it again"; // the cure

struct PreparedGltf {
    std::string bytes; // of a .gltf or .glb, for tinygltf
    std::vector<tinygltf::Image> images; // taken out of the bytes; of each nothing but uri and bufferView
    Warnings warnings; // "gltf-types", as of GltfDocument
};
Expected<PreparedGltf> preparedGltf(const std::filesystem::path& file);

} // namespace relievo
