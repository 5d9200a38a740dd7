// What a glTF file asks for and no State can hold: told, so that nobody wonders.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <optional>
#include <tiny_gltf.h>

namespace relievo {

// "not-shown": one warning for the whole file, in words; nothing where all of it is shown.
std::optional<Warning> notShown(const tinygltf::Model& model);

// How the pictures of a material repeat: by the sampler of this texture.
enum class GltfWrap { Repeat, Clamp, Other };
GltfWrap wrapOf(const tinygltf::Model& model, int texture);

// Whether the material is described by KHR_materials_pbrSpecularGlossiness alone.
bool isSpecularGlossiness(const tinygltf::Material& material);

} // namespace relievo
