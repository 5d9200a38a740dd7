// A decoded image: a rectangle of interleaved channels in the precision of its file.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

namespace relievo {

enum class PixelType : std::uint8_t { U8, U16, F32 };
constexpr std::size_t bytesOf(PixelType type)
{
    return type == PixelType::U8 ? 1 : type == PixelType::U16 ? 2 : 4;
}

// What the tags of an elevation model (GeoTIFF) say.
struct Survey {
    double texelWidth = 0; // m on the ground, at the middle of the image; 0: not told
    double metres = 1; // of one unit of the heights
    std::optional<double> noData = {}; // the number that marks gaps; may be NaN
    bool operator==(const Survey&) const = default;
};

// Row-major, row 0 at the top, channels interleaved in the order r g b a (or the single channel).
// Integer types stand for value / max in [0, 1]; F32 is as stored (half floats are widened).
struct Image {
    int width = 0, height = 0, channels = 0; // channels 1 to 4
    PixelType type = PixelType::U8;
    int storedBits = 8; // bits a channel in the file: 8, 16 (also half float), 32, or odd ones such as 10 and 12
    bool storedFloat = false;
    std::vector<std::byte> data; // width * height * channels * bytesOf(type)
    double storedMaximum = 0; // F32 made of whole numbers: the number that has become 1; else 0
    std::optional<Survey> survey = {}; // nothing for all but elevation models

    std::size_t texelCount() const { return std::size_t(width) * std::size_t(height); }

    // One channel of one texel as a float; integers are divided by their maximum. No bounds check.
    float value(int x, int y, int channel) const
    {
        const std::size_t at = (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels) + std::size_t(channel);
        switch (type) {
        case PixelType::U8:
            return float(std::to_integer<unsigned>(data[at])) / 255.f;
        case PixelType::U16: {
            std::uint16_t v;
            std::memcpy(&v, data.data() + at * 2, 2);
            return float(v) / 65535.f;
        }
        case PixelType::F32:
            break;
        }
        float v;
        std::memcpy(&v, data.data() + at * 4, 4);
        return v;
    }
};

} // namespace relievo
