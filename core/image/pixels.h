// Small questions about an image's pixels: ranges, equal channels, and coarse copies for measuring.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include "core/state/map_slots.h"
#include <optional>
#include <utility>
#include <vector>

namespace relievo {

// Calls work(texels, maximum) with the values in their own type: maximum stands for 1 (1 for floats).
template <class Work> auto withTexels(const Image& image, Work work)
{
    switch (image.type) {
    case PixelType::U8:
        return work(reinterpret_cast<const std::uint8_t*>(image.data.data()), 255.f);
    case PixelType::U16:
        return work(reinterpret_cast<const std::uint16_t*>(image.data.data()), 65535.f);
    case PixelType::F32:
        break;
    }
    return work(reinterpret_cast<const float*>(image.data.data()), 1.f);
}

// The channels [first, last) that `channel` stands for; alpha is the last of two or four, the colour that the image lacks is its first.
std::pair<int, int> channelRange(const Image& image, Channel channel);

bool hasAlpha(const Image& image);
bool hasChannel(const Image& image, Channel channel); // greys stand for red, green and blue; nothing stands for alpha
bool hasEqualRgb(const Image& image); // grey stored as colour; true for one or two channels
bool looksGrey(const Image& image); // as hasEqualRgb, but for the small differences that JPEG leaves
std::optional<Channel> onlyVarying(const Image& image); // of red, green and blue; the others are constant and say nothing
Channel scalarChannel(const Image& image, Channel channel); // Rgb becomes the one channel where that is all there is to know
std::pair<double, double> rangeOf(const Image& image, Channel channel); // min and max of its finite values; (0, 0) without any
bool isMostlyBlack(const Image& image); // its colours' mean as stored is below 0.1: black with lights in it
bool alphaVaries(const Image& image); // has an alpha channel that is not the same everywhere

// A plane of single values, row-major.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;
    float at(int x, int y) const { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

// The channel's mean over each cell of a width x height grid laid over the image (sampled when the cells are large).
// Non-finite values count as 0.
Plane coarse(const Image& image, Channel channel, int width, int height);

} // namespace relievo
