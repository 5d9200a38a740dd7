// Compressed triangles and numbers of glTF files, decoded by the helper process: broken ones can end it, never the editor.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/image/files/imageio_protocol.h"
#include <span>
#include <string>
#include <vector>

namespace relievo {

// The bytes that the helper answers with (imageio_protocol.h); `size` of the requests is filled in. `name` stands in errors.
Expected<std::vector<std::byte>> decodeMeshopt(
    const imageio::MeshoptRequest& request, std::span<const std::byte> compressed, const std::string& name);
Expected<std::vector<std::byte>> decodeDraco(
    const imageio::DracoRequest& request, std::span<const std::byte> compressed, const std::string& name);

} // namespace relievo
