// glTF files whose triangles and numbers are compressed: KHR_draco_mesh_compression and EXT_meshopt_compression.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/ground/progress.h"
#include <string>
#include <tiny_gltf.h>

namespace relievo {

// Puts what is compressed into buffers, buffer views and accessors of its own, so that the model reads like one that is not. Errors name
// `where`; cancelled: an error of that code.
Expected<void> decompress(tinygltf::Model& model, const std::string& where, const Progress& progress);

} // namespace relievo
