// Telling codes by how one byte makes up for the rounding of the other.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/height_codes.h"
#include "core/image/pixels.h"
#include <array>
#include <cmath>
#include <oneapi/tbb/parallel_for.h>

namespace relievo {
namespace {
constexpr int kFewestSteps = 8; // of a high byte, from its lowest to its highest
constexpr int kFullByte = 200; // what a low byte spans at least
constexpr std::size_t kMostTexels = std::size_t(1) << 20; // that are looked at
constexpr double kSurest = 0.08, kSlack = 0.1; // of the slope: its largest standard error, and what else it may be off by

const std::uint8_t* texel(const Image& image, int x, int y)
{
    const std::size_t at = (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * std::size_t(image.channels);
    return reinterpret_cast<const std::uint8_t*>(image.data.data()) + at;
}

// How much a byte differs from its four neighbours' mean, times four. roundTrip: it goes round, with another byte over it.
int unevenness(const Image& image, int x, int y, int channel, bool roundTrip)
{
    const std::uint8_t* at = texel(image, x, y) + channel;
    const std::ptrdiff_t right = image.channels, down = right * image.width;
    int sum = 0;
    for (const std::ptrdiff_t step : {-right, right, -down, down}) {
        const int difference = int(at[0]) - int(at[step]);
        sum += roundTrip ? int(std::int8_t(std::uint8_t(difference))) : difference;
    }
    return sum;
}

// Whether the low byte is the rest of the high one. Where the surface passes by, the high byte is uneven as it is rounded, and the rest
// makes up for it: the unevenness of one falls with that of the other, by 1 for 256. Between colours there is no such slope. Nothing: the
// bytes hardly vary.
std::optional<bool> isCode(const Image& image, int high, int low, bool isHighest)
{
    double count = 0, xx = 0, xy = 0, yy = 0;
    const int apart = int(image.texelCount() / kMostTexels) + 1; // rows
    for (int y = 1; y + 1 < image.height; y += apart)
        for (int x = 1; x + 1 < image.width; ++x) {
            const double rest = unevenness(image, x, y, low, false) / 256., whole = unevenness(image, x, y, high, !isHighest);
            ++count, xx += rest * rest, xy += rest * whole, yy += whole * whole;
        }
    if (count < 16 || xx == 0 || yy == 0)
        return std::nullopt;
    const double slope = xy / xx, error = std::sqrt(std::max(yy - slope * xy, 0.) / (xx * count));
    return error < kSurest && std::abs(slope + 1) < kSlack + 2 * error;
}

using Bytes = std::array<std::pair<int, int>, 3>; // lowest and highest of each channel
Bytes rangesOf(const Image& image)
{
    Bytes ranges;
    for (const Channel channel : {Channel::R, Channel::G, Channel::B}) {
        const auto [low, high] = rangeOf(image, channel);
        ranges[std::size_t(channel)] = {int(std::lround(low * 255)), int(std::lround(high * 255))};
    }
    return ranges;
}

template <class Texel, class Value> Image decodedBy(const Image& image, PixelType type, int bits, Value value)
{
    Image result{image.width, image.height, 1, type, bits, type == PixelType::F32, {}};
    result.data.resize(result.texelCount() * sizeof(Texel));
    Texel* out = reinterpret_cast<Texel*>(result.data.data());
    oneapi::tbb::parallel_for(0, image.height, [&](int y) {
        for (int x = 0; x < image.width; ++x)
            out[std::size_t(y) * std::size_t(image.width) + std::size_t(x)] = value(texel(image, x, y));
    });
    return result;
}

float bytes24(const std::uint8_t* t)
{
    return float(int(t[0]) << 16 | int(t[1]) << 8 | int(t[2])); // exact
}
} // namespace

std::string_view nameOf(HeightCode code)
{
    switch (code) {
    case HeightCode::None:
        break;
    case HeightCode::Terrarium:
        return "in red, green and blue (Terrarium, metres)";
    case HeightCode::TerrainRgb:
        return "in red, green and blue (Terrain-RGB, metres)";
    case HeightCode::HighLow:
        return "as high byte in red and low byte in green";
    case HeightCode::LowHigh:
        return "as low byte in red and high byte in green";
    case HeightCode::Bytes24:
        return "as 24 bits in red, green and blue";
    }
    return {};
}

HeightCode heightCodeOf(const Image& image, Channel channel)
{
    if (image.type != PixelType::U8 || image.channels < 3 || channel != Channel::Rgb || hasEqualRgb(image))
        return HeightCode::None;
    const Bytes ranges = rangesOf(image);
    const auto span = [&](int c) { return ranges[std::size_t(c)].second - ranges[std::size_t(c)].first; };
    const auto code = [&](int high, int low, bool isHighest) {
        return span(low) >= kFullByte ? isCode(image, high, low, isHighest) : std::optional(false);
    };
    if (span(1) == 0) // the byte in the middle is part of every code
        return HeightCode::None;
    const std::optional<bool> redGreen = code(0, 1, true);
    if (span(2) < kFullByte) // blue is no byte of the code
        return span(0) >= kFewestSteps && redGreen.value_or(false)        ? HeightCode::HighLow
            : span(1) >= kFewestSteps && code(1, 0, true).value_or(false) ? HeightCode::LowHigh
                                                                          : HeightCode::None;
    const bool greenBlue = code(1, 2, span(0) == 0).value_or(false);
    if (!(span(0) == 0 ? greenBlue : redGreen.value_or(false))) // where red stays, green and blue say it
        return HeightCode::None;
    const auto within = [&](int low, int high) { return ranges[0].first >= low && ranges[0].second <= high; };
    constexpr int kDeepestSea = 0x80 - 43, kHighestTop = 0x80 + 35; // in steps of 256 m
    if (within(kDeepestSea, kHighestTop))
        return HeightCode::Terrarium;
    return within(0, 2) && greenBlue ? HeightCode::TerrainRgb : HeightCode::Bytes24;
}

Image decodedHeights(const Image& image, HeightCode code)
{
    using Texel = const std::uint8_t*;
    switch (code) {
    case HeightCode::HighLow:
        return decodedBy<std::uint16_t>(image, PixelType::U16, 16, [](Texel t) { return std::uint16_t(t[0] << 8 | t[1]); });
    case HeightCode::LowHigh:
        return decodedBy<std::uint16_t>(image, PixelType::U16, 16, [](Texel t) { return std::uint16_t(t[1] << 8 | t[0]); });
    case HeightCode::Terrarium:
        return decodedBy<float>(image, PixelType::F32, 24, [](Texel t) { return bytes24(t) / 256.f - 32768.f; });
    case HeightCode::TerrainRgb:
        return decodedBy<float>(image, PixelType::F32, 24, [](Texel t) { return float(double(bytes24(t)) * 0.1 - 10000.); });
    case HeightCode::None:
    case HeightCode::Bytes24:
        break;
    }
    return decodedBy<float>(image, PixelType::F32, 24, [](Texel t) { return float(double(bytes24(t)) / 16777215.); });
}

} // namespace relievo
