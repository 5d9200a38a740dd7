// The built-in materials, made by formula at any size: relief to try the editor with before any file is opened.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include "core/image/image.h"
#include "core/state/map_slots.h"
#include <array>
#include <string_view>

namespace relievo {

// size: texels along each side, >= 1. Tiles seamlessly. Heights are U16 values in [0, 1] (16 bits of precision).
struct Sample {
    Image height; // 1 channel U16
    Image color; // 3 channels U8, sRGB
    Image roughness; // 1 channel U16
    Image metallic; // 1 channel U8, or empty when nothing is metal
};

struct SampleRow {
    std::string_view key; // "bricks": used as SOURCE "sample:bricks" and in map slots
    std::string_view label;
    float depth; // sensible `depth` parameter for it, share of the tile
    Sample (*make)(int size);
    std::string_view help;
};

extern const std::array<SampleRow, 6> kSamples;
inline constexpr int kSampleSize = 1024; // texels a side where a slot does not say "@SIZE"

const SampleRow* findSample(std::string_view key); // nullptr when unknown

// The slots that name the maps of a sample: "sample:KEY" (or "sample:KEY@SIZE").
MapSlots sampleSlots(std::string_view key, int size = kSampleSize);

} // namespace relievo
