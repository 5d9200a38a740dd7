// The animations of a glTF file.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/animation/gltf_nodes.h"

namespace relievo {

struct GltfClips {
    std::vector<AnimationClip> clips;
    std::vector<bool> moves; // of each of GltfNodes::nodes: whether it or one above it has an animated place
    std::size_t broken = 0; // channels that were left out
    std::size_t unsorted = 0; // channels whose keys were not in the order of time
};

// where: the file.
GltfClips readClips(const tinygltf::Model& model, const GltfNodes& nodes, const std::string& where);

} // namespace relievo
