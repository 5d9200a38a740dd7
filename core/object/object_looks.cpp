// Normals by differences of depths.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/object_looks.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace relievo {

namespace {
Image emptyImage(int width, int height, int channels)
{
    Image image{width, height, channels, PixelType::U16, 16, false, {}};
    image.data.resize(image.texelCount() * std::size_t(channels) * sizeof(std::uint16_t));
    return image;
}

std::uint16_t code(double value)
{
    return std::uint16_t(std::lround(std::clamp(value, 0., 1.) * 65535.));
}

void putNormal(Image& image, std::size_t texel, glm::dvec3 normal)
{
    const glm::dvec3 n = glm::normalize(normal);
    auto* out = reinterpret_cast<std::uint16_t*>(image.data.data()) + 3 * texel;
    for (int c = 0; c < 3; ++c)
        out[c] = code(0.5 + 0.5 * n[c]);
}

// How deep the outermost surface lies, share of the box's length from the front; nothing where there is none.
std::optional<double> outermost(const AxisMap& map, int x, int y, bool isBack)
{
    if (x < 0 || y < 0 || x >= map.width || y >= map.height)
        return {};
    std::optional<double> found;
    for (int k = 0; k < map.layers; ++k)
        if (const Interval& interval = map.at(x, y, k); interval.isSolid()) {
            const double depth = double(isBack ? interval.back : interval.front) / Interval::kDeepest;
            found = !found ? depth : isBack ? std::max(*found, depth) : std::min(*found, depth);
        }
    return found;
}

// Change of depth from one texel to the next.
double slope(std::optional<double> before, std::optional<double> here, std::optional<double> after)
{
    if (before && after)
        return 0.5 * (*after - *before);
    return after ? *after - *here : before ? *here - *before : 0.;
}
} // namespace

Image channelOf(const Image& image, int channel, bool inverted)
{
    Image one = emptyImage(image.width, image.height, 1);
    auto* out = reinterpret_cast<std::uint16_t*>(one.data.data());
    const bool isMissing = channel >= image.channels;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double value = isMissing && channel == 3 ? 1. : double(image.value(x, y, isMissing ? 0 : channel));
            *out++ = code(inverted ? 1. - value : value);
        }
    return one;
}

Image normalsOfXy(const Image& image)
{
    Image normals = emptyImage(image.width, image.height, 3);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double nx = 2. * double(image.value(x, y, 0)) - 1.,
                         ny = 2. * double(image.value(x, y, std::min(1, image.channels - 1))) - 1.;
            putNormal(normals, std::size_t(y) * std::size_t(image.width) + std::size_t(x),
                {nx, ny, std::sqrt(std::max(1. - nx * nx - ny * ny, 1e-6))});
        }
    return normals;
}

Image normalsOfDepths(const ReliefObject& object, std::size_t axis, bool isBack)
{
    const AxisMap& map = object.axes[axis];
    const AxisFrame& frame = kAxisFrames[axis];
    const auto lengthAlong = [&](glm::dvec3 inBox) { // m, of the whole box
        return 2. * glm::length(object.half[0] * inBox.x + object.half[1] * inBox.y + object.half[2] * inBox.z);
    };
    const double deep = lengthAlong(frame.depth), perU = deep * map.width / lengthAlong(frame.u),
                 perV = deep * map.height / lengthAlong(frame.v), sign = isBack ? -1. : 1.;
    Image normals = emptyImage(map.width, map.height, 3);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const auto at = [&](int dx, int dy) { return outermost(map, x + dx, y + dy, isBack); };
            const auto here = at(0, 0);
            const double alongU = here ? slope(at(-1, 0), here, at(1, 0)) * perU : 0.,
                         alongV = here ? slope(at(0, -1), here, at(0, 1)) * perV : 0.;
            putNormal(normals, std::size_t(y) * std::size_t(map.width) + std::size_t(x), {sign * alongU, -sign * alongV, 1.});
        }
    return normals;
}

} // namespace relievo
