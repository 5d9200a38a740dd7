// The table of baked maps: everything that is computed from a height field and stored.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/error.h"
#include "core/image/height_field.h"
#include "core/image/image.h"
#include "core/progress.h"
#include "core/state/parameters.h"
#include <array>
#include <string_view>

namespace relievo {

struct MapRow {
    std::string_view key;
    std::string_view label;
    std::string_view unit;
    int channels;
    Image (*bake)(const HeightField& field, const Parameters& parameters, const Progress& progress);
    std::string_view help;
};

Image bakeNormal(const HeightField& field, const Parameters& parameters, const Progress& progress);

inline constexpr auto kMaps = std::to_array<MapRow>({
    {"normal", "Normal", "unit vector / 2 + 1/2", 3, bakeNormal,
        "Tangent-space normals of the height map at the State's depth, OpenGL style."},
});

const MapRow* findMap(std::string_view key); // nullptr when unknown

// The row's map of a field. Cancelled: error with what == "cancelled". Out of memory: an error that says so.
Expected<Image> bakeMap(const MapRow& row, const HeightField& field, const Parameters& parameters, const Progress& progress = {});

// The image in another precision: bits 8, 16 or 32 (float). Values keep their meaning; rounding is to nearest.
Image withBits(const Image& image, int bits);

} // namespace relievo
