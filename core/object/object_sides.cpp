// Depths from both ends of an axis.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/object_sides.h"
#include <cmath>

namespace relievo {

Image depthPicture(const AxisMap& map, int layer, bool isBack)
{
    Image image{map.width, map.height, 1, PixelType::U16, 16, false, {}};
    image.data.resize(image.texelCount() * sizeof(std::uint16_t));
    auto* out = reinterpret_cast<std::uint16_t*>(image.data.data());
    for (std::size_t i = 0; i < image.texelCount(); ++i) {
        const Interval& interval = map.intervals[i * std::size_t(map.layers) + std::size_t(layer)];
        out[i] = isBack ? std::uint16_t(Interval::kDeepest - interval.back) : interval.front;
    }
    return image;
}

void setLayer(AxisMap& map, int layer, const Image* front, const Image* back)
{
    const auto code = [](const Image& image, int x, int y) {
        return std::uint16_t(std::lround(std::clamp(image.value(x, y, 0), 0.f, 1.f) * float(Interval::kDeepest)));
    };
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const std::uint16_t near = front ? code(*front, x, y) : 0;
            const std::uint16_t far = back ? code(*back, x, y) : 0;
            const bool isNothing = (!front || !back) && std::max(near, far) == Interval::kDeepest;
            const std::size_t texel = std::size_t(y) * std::size_t(map.width) + std::size_t(x);
            map.intervals[texel * std::size_t(map.layers) + std::size_t(layer)]
                = isNothing ? Interval() : Interval{near, std::uint16_t(Interval::kDeepest - far)};
        }
}

} // namespace relievo
