// Height fields that searches fail on, made by formula at any size: what every technique is measured with.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include "core/image/samples/samples.h"
#include "core/state/map_slots.h"
#include <array>
#include <cstdint>
#include <string_view>

namespace relievo {

struct HardCaseRow {
    std::string_view key; // "needles": SOURCE "hard:needles", in map slots "sample:hard-needles"
    std::string_view label;
    // size: texels along the longer side, >= 1. Heights are floats in [0, 1] and tile. Equal size and seed give equal fields.
    HeightField (*make)(int size, std::uint32_t seed);
    bool pictured; // stands for the others where pictures of all would take too long
    std::string_view help; // what is hard about it
};

extern const std::array<HardCaseRow, 20> kHardCases;
inline constexpr int kHardCaseSize = 256; // texels a side where nothing else is said
inline constexpr float kHardCaseDepth = 0.08f; // share of the tile

const HardCaseRow* findHardCase(std::string_view key); // nullptr when unknown

// The slots that name the maps of a hard case: "sample:hard-KEY@SIZE".
MapSlots hardCaseSlots(std::string_view key, int size);

// The hard case as a material: the heights as floats (seed 1) and a grey that follows them.
Sample hardCaseSample(const HardCaseRow& row, int size);

} // namespace relievo
