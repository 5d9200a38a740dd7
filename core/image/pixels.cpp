// Answers about pixels, in parallel over rows.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/pixels.h"
#include <cmath>
#include <limits>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_reduce.h>

namespace relievo {
namespace {
constexpr std::size_t kGrain = 1 << 16; // values a task
constexpr int kSamplesPerCell = 4; // along each side

struct Range {
    float low = std::numeric_limits<float>::infinity(), high = -std::numeric_limits<float>::infinity();
    void add(float value)
    {
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
};

template <class Texel>
Range rangeOfSlice(const Texel* texels, std::size_t from, std::size_t to, std::size_t channels, std::pair<int, int> wanted, Range range)
{
    if constexpr (std::is_integral_v<Texel>) {
        Texel low = std::numeric_limits<Texel>::max(), high = 0;
        for (std::size_t i = from; i < to; ++i)
            for (int c = wanted.first; c < wanted.second; ++c) {
                const Texel value = texels[i * channels + std::size_t(c)];
                low = std::min(low, value);
                high = std::max(high, value);
            }
        range.add(float(low));
        range.add(float(high));
    } else {
        for (std::size_t i = from; i < to; ++i)
            for (int c = wanted.first; c < wanted.second; ++c)
                range.add(texels[i * channels + std::size_t(c)]);
    }
    return range;
}

template <class Texel> bool equalRgb(const Texel* texels, std::size_t count, std::size_t channels)
{
    for (std::size_t i = 0; i < count; ++i, texels += channels)
        if (texels[0] != texels[1] || texels[0] != texels[2])
            if (texels[0] == texels[0] || texels[1] == texels[1]) // NaN equals NaN here
                return false;
    return true;
}

// First texel of cell `cell` of `cells` over `size` texels.
int cellStart(int cell, int cells, int size)
{
    return int(std::int64_t(cell) * size / cells);
}

// Sum over the sampled texels of one cell.
template <class Texel> float cellMean(const Texel* texels, const Image& image, std::pair<int, int> wanted, int x0, int x1, int y0, int y1)
{
    const int stepX = std::max(1, (x1 - x0) / kSamplesPerCell), stepY = std::max(1, (y1 - y0) / kSamplesPerCell);
    double sum = 0;
    int count = 0;
    for (int y = y0; y < y1; y += stepY)
        for (int x = x0; x < x1; x += stepX)
            for (int c = wanted.first; c < wanted.second; ++c, ++count) {
                const float value = float(
                    texels[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * std::size_t(image.channels) + std::size_t(c)]);
                sum += std::isfinite(value) ? double(value) : 0.0;
            }
    return float(sum / std::max(count, 1));
}
} // namespace

std::pair<int, int> channelRange(const Image& image, Channel channel)
{
    if (channel == Channel::Rgb)
        return {0, std::max(1, image.channels >= 3 ? 3 : 1)};
    if (channel == Channel::A && image.channels == 2)
        return {1, 2};
    const int index = int(channel) < image.channels ? int(channel) : 0;
    return {index, index + 1};
}

bool hasAlpha(const Image& image)
{
    return image.channels % 2 == 0;
}

bool hasChannel(const Image& image, Channel channel)
{
    return channel != Channel::A || hasAlpha(image);
}

bool hasEqualRgb(const Image& image)
{
    if (image.channels < 3)
        return true;
    return withTexels(image, [&](const auto* texels, float) { return equalRgb(texels, image.texelCount(), std::size_t(image.channels)); });
}

bool looksGrey(const Image& image)
{
    constexpr int kCells = 64; // along a side
    constexpr float kTolerance = 0.03f; // of a cell's mean
    if (hasEqualRgb(image))
        return true;
    const Plane red = coarse(image, Channel::R, kCells, kCells), green = coarse(image, Channel::G, kCells, kCells),
                blue = coarse(image, Channel::B, kCells, kCells);
    for (std::size_t i = 0; i < red.values.size(); ++i) {
        const auto [low, high] = std::minmax({red.values[i], green.values[i], blue.values[i]});
        if (high - low > kTolerance)
            return false;
    }
    return true;
}

std::optional<Channel> onlyVarying(const Image& image)
{
    std::optional<Channel> varying;
    for (const Channel channel : {Channel::R, Channel::G, Channel::B}) {
        const auto [low, high] = rangeOf(image, channel);
        if (low != high && varying)
            return std::nullopt;
        if (low != high)
            varying = channel;
    }
    return varying;
}

Channel scalarChannel(const Image& image, Channel channel)
{
    if (channel != Channel::Rgb)
        return channel;
    return hasEqualRgb(image) ? Channel::R : onlyVarying(image).value_or(channel);
}

std::pair<double, double> rangeOf(const Image& image, Channel channel)
{
    namespace tbb = oneapi::tbb;
    const auto wanted = channelRange(image, channel);
    return withTexels(image, [&](const auto* texels, float maximum) -> std::pair<double, double> {
        const Range range = tbb::parallel_reduce(
            tbb::blocked_range<std::size_t>(0, image.texelCount(), kGrain), Range(),
            [&](const auto& slice, Range r) {
                return rangeOfSlice(texels, slice.begin(), slice.end(), std::size_t(image.channels), wanted, r);
            },
            [](Range a, const Range& b) {
                a.add(b.low);
                a.add(b.high);
                return a;
            });
        if (range.low > range.high)
            return {0.0, 0.0};
        return {double(range.low) / double(maximum), double(range.high) / double(maximum)};
    });
}

bool alphaVaries(const Image& image)
{
    if (!hasAlpha(image))
        return false;
    const auto [low, high] = rangeOf(image, Channel::A);
    return low < high;
}

bool isMostlyBlack(const Image& image)
{
    const Plane plane = coarse(image, Channel::Rgb, 64, 64);
    double sum = 0;
    for (const float value : plane.values)
        sum += double(value);
    return sum < 0.1 * double(plane.values.size());
}

Plane coarse(const Image& image, Channel channel, int width, int height)
{
    Plane plane{width, height, std::vector<float>(std::size_t(width) * std::size_t(height))};
    const auto wanted = channelRange(image, channel);
    withTexels(image, [&](const auto* texels, float maximum) {
        oneapi::tbb::parallel_for(0, height, [&](int y) {
            const int y0 = cellStart(y, height, image.height), y1 = cellStart(y + 1, height, image.height);
            for (int x = 0; x < width; ++x) {
                const int x0 = cellStart(x, width, image.width), x1 = cellStart(x + 1, width, image.width);
                const float mean = cellMean(texels, image, wanted, x0, x1, y0, y1);
                plane.values[std::size_t(y) * std::size_t(width) + std::size_t(x)] = mean / maximum;
            }
        });
    });
    return plane;
}

} // namespace relievo
