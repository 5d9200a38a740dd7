// Turning a decoded file into one map of a material: the wanted channels, conventions applied.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/ground/error.h"
#include "core/image/files/image_file.h"
#include "core/image/height_field.h"
#include "core/state/map_slots.h"
#include <memory>

namespace relievo {

// A decoded file as it is shared between maps.
using DecodedFile = std::shared_ptr<const ImageRead>;

// Height as material.h wants it. `file` stands in the warnings, which are appended.
HeightField heightOf(const Image& image, const MapSlot& slot, const std::string& file, Warnings& warnings);

// Any other kind. Shares the decoded pixels when nothing must be changed. namedRelief: see reliefForm.
Expected<std::shared_ptr<const Image>> mapOf(
    MapKind kind, const DecodedFile& decoded, const MapSlot& slot, const std::string& file, bool namedRelief, Warnings& warnings);

} // namespace relievo
