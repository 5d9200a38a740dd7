// Heights that are packed as a code into the bytes of red, green and blue, as terrain tiles and old tools store them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include "core/state/map_slots.h"
#include <optional>
#include <string>
#include <string_view>

namespace relievo {

enum class HeightCode {
    None,
    Terrarium, // r * 256 + g + b / 256 - 32768 metres
    TerrainRgb, // (r * 65536 + g * 256 + b) / 10 - 10000 metres
    HighLow, // r is the high byte of 16 bits, g the low one
    LowHigh, // the other way round
    Bytes24, // r, g and b are 24 bits, the highest first
};
std::string_view nameOf(HeightCode code); // for messages

// Only codes that are certain: the low byte makes up for the rounding of the high one, which no colour does. Images of 8 bits that are read
// as a whole (Channel::Rgb).
HeightCode heightCodeOf(const Image& image, Channel channel);

// One channel: F32 in metres for the first two, U16 for two bytes, F32 in [0, 1] for three.
Image decodedHeights(const Image& image, HeightCode code);

} // namespace relievo
