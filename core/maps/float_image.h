// Images of floats, as bakes make them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/image.h"
#include "core/maps/baked_map.h"
#include <span>
#include <utility>

namespace relievo {

// width, height >= 1; all zero.
inline Image floatImage(int width, int height, int channels)
{
    Image image{width, height, channels, PixelType::F32, 32, true, {}};
    image.data.resize(image.texelCount() * std::size_t(channels) * sizeof(float));
    return image;
}

// The values of an F32 image, interleaved (the allocator's memory is aligned for floats).
inline std::span<float> floats(Image& image)
{
    return {reinterpret_cast<float*>(image.data.data()), image.data.size() / sizeof(float)};
}
inline std::span<const float> floats(const Image& image)
{
    return {reinterpret_cast<const float*>(image.data.data()), image.data.size() / sizeof(float)};
}

// A map of one level, without copying it.
inline BakedMap oneLevel(Image image, int slices = 1)
{
    BakedMap map;
    map.levels.push_back(std::move(image));
    map.slices = slices;
    return map;
}

} // namespace relievo
