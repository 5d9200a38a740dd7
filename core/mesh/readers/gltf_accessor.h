// Reading glTF accessors with every bound checked.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include <string>
#include <tiny_gltf.h>
#include <vector>

namespace relievo {

// The elements of accessor `index` as floats, `components` each (3 for positions); integers are normalized when the accessor
// says so, sparse values are put in place. Errors name the accessor and what it breaks.
Expected<std::vector<float>> readFloats(const tinygltf::Model& model, int index, int components, const std::string& where);

// The same for indices: one unsigned number an element.
Expected<std::vector<std::uint32_t>> readIndices(const tinygltf::Model& model, int index, const std::string& where);

} // namespace relievo
