// Telling codes by how much smoother the bytes are together.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/height_codes.h"
#include "core/image/pixels.h"
#include <array>
#include <cmath>
#include <oneapi/tbb/parallel_for.h>

namespace relievo {
namespace {
constexpr int kFewestSteps = 16; // texels where the high byte alone is not smooth
constexpr double kSmoother = 0.5; // how rough both bytes together are at most, as a share of the high byte alone
constexpr std::size_t kMostTexels = std::size_t(1) << 20; // that are looked at

const std::uint8_t* texel(const Image& image, int x, int y)
{
    const std::size_t at = (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * std::size_t(image.channels);
    return reinterpret_cast<const std::uint8_t*>(image.data.data()) + at;
}

constexpr std::size_t kOrders = 5; // differences of differences: a curve's own become small, those of rounding grow

// Differences along rows and columns, of the high byte alone and of both together.
class Roughness {
public:
    // isHighest: else the high byte goes round, with another one over it.
    Roughness(int high, int low, bool isHighest) : m_high(high), m_low(low), m_isHighest(isHighest) { }

    // Texels at[0], at[stride] ...
    void addLine(const std::uint8_t* at, std::ptrdiff_t stride, int count)
    {
        Differences alone, both;
        for (int i = 0; i < count; ++i, at += stride) {
            add(at[m_high] << 8, i, alone, m_alone);
            add(at[m_high] << 8 | at[m_low], i, both, m_both);
            m_steps += i > 1 && alone[2] != 0;
        }
    }

    // Whether the low byte is the rest of the high one. Nothing: the high byte hardly changes.
    std::optional<bool> isCode() const
    {
        if (m_steps < kFewestSteps)
            return std::nullopt;
        for (std::size_t order = 2; order <= kOrders; ++order)
            if (m_both[order] < kSmoother * m_alone[order])
                return true;
        return false;
    }

private:
    using Differences = std::array<int, kOrders + 1>; // of the last texel; the first one is its value
    using Sums = std::array<double, kOrders + 1>;

    void add(int value, int index, Differences& last, Sums& sums) const
    {
        for (std::size_t order = 0; order <= kOrders && index >= int(order); ++order) {
            sums[order] += std::abs(value);
            const int next = value - last[order];
            last[order] = value;
            value = order > 0 || m_isHighest ? next : int(std::int16_t(std::uint16_t(next)));
        }
    }

    int m_high, m_low;
    bool m_isHighest;
    int m_steps = 0;
    Sums m_alone = {}, m_both = {};
};

std::optional<bool> isCode(const Image& image, int high, int low, bool isHighest)
{
    Roughness roughness(high, low, isHighest);
    const int apart = int(image.texelCount() / kMostTexels) + 1; // lines
    for (int y = 0; y < image.height; y += apart)
        roughness.addLine(texel(image, 0, y), image.channels, image.width);
    for (int x = 0; x < image.width; x += apart)
        roughness.addLine(texel(image, x, 0), std::ptrdiff_t(image.channels) * image.width, image.height);
    return roughness.isCode();
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
    const auto constant = [&](int c) { return ranges[std::size_t(c)].first == ranges[std::size_t(c)].second; };
    if (constant(1)) // the byte in the middle is part of every code
        return HeightCode::None;
    const std::optional<bool> redGreen = isCode(image, 0, 1, true);
    if (constant(2))
        return redGreen.value_or(false)                 ? HeightCode::HighLow
            : isCode(image, 1, 0, true).value_or(false) ? HeightCode::LowHigh
                                                        : HeightCode::None;
    const bool greenBlue = isCode(image, 1, 2, constant(0)).value_or(false);
    if (!redGreen.value_or(greenBlue)) // where red stays, green and blue must say it
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
