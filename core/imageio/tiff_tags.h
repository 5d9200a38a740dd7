// What a TIFF file's tags say beside the pixels: how its samples are stored, and what an elevation model measures.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include <cstdint>
#include <optional>
#include <string>

namespace relievo::imageio {

struct TiffTags {
    std::uint16_t photometric = 1; // 0: white is the smallest number
    std::uint16_t bits = 8, format = 1, samples = 1; // format: 1 whole, 2 signed, 3 float
    std::optional<Survey> survey; // of GeoTIFF files
};

// Of its first page. Nothing when it is no TIFF file.
std::optional<TiffTags> tiffTags(const std::string& file);

} // namespace relievo::imageio
