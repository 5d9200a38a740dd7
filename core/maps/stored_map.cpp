// Storing a map in few bits so that a bound still bounds after the GPU decoded it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/float_image.h"
#include "core/maps/maps.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {

// Decoding in float, operation by operation as a shader does it.
float decoded(float stored, const ChannelRule& rule, float scale)
{
    return (rule.encoding == Encoding::SquareRoot ? stored * stored : stored) * scale;
}

// Before rounding.
double encoded(float value, const ChannelRule& rule, float scale)
{
    const double unit = double(value) / double(scale);
    return rule.encoding == Encoding::SquareRoot ? std::sqrt(unit) : unit;
}

// The code whose decoded value is nearest on the safe side. Rounding may put the guess one code off: that is looked up by decoding.
std::uint32_t codeOf(float value, const ChannelRule& rule, float scale, std::uint32_t most)
{
    const double exact = std::clamp(std::isnan(value) || value < 0.f ? 0. : encoded(value, rule, scale), 0., 1.) * most;
    std::uint32_t code = std::uint32_t(std::lround(exact));
    const auto at = [&](std::uint32_t c) { return decoded(float(c) / float(most), rule, scale); };
    if (rule.rounding == Rounding::Down) {
        while (code < most && at(code + 1) <= value)
            ++code;
        while (code > 0 && at(code) > value)
            --code;
    } else if (rule.rounding == Rounding::Up) {
        while (code > 0 && at(code - 1) >= value)
            --code;
        while (code < most && at(code) < value)
            ++code;
    }
    return code;
}

float floatOf(float value, const ChannelRule& rule)
{
    if (rule.encoding == Encoding::Linear || !(value > 0.f))
        return value;
    float root = std::sqrt(value);
    while (rule.rounding == Rounding::Down && root * root > value)
        root = std::nextafter(root, 0.f);
    while (rule.rounding == Rounding::Up && root * root < value)
        root = std::nextafter(root, std::numeric_limits<float>::infinity());
    return root;
}

// Roots are of values without a natural limit (ratios, distances): these use the whole range of codes. Others only when they must.
float scaleOf(const BakedMap& map, int channel, const ChannelRule& rule, const Progress& progress)
{
    float highest = 0.f;
    for (const Image& level : map.levels) {
        const auto values = floats(level);
        const std::size_t row = std::size_t(level.width) * std::size_t(level.channels);
        for (std::size_t begin = 0; begin < values.size() && !progress.cancelled(); begin += row)
            for (std::size_t i = begin + std::size_t(channel); i < begin + row; i += std::size_t(level.channels))
                highest = std::max(highest, values[i]);
    }
    if (rule.encoding == Encoding::Linear && highest <= 1.f)
        return 1.f;
    return std::max(highest, 1e-20f);
}

void put(Image& image, std::size_t at, std::uint32_t code)
{
    if (image.type == PixelType::U8) {
        image.data[at] = std::byte(code);
    } else {
        const std::uint16_t word = std::uint16_t(code);
        std::memcpy(image.data.data() + 2 * at, &word, 2);
    }
}

Image storedLevel(const Image& level, const std::array<ChannelRule, 4>& rules, glm::vec4 scale, int bits, const Progress& progress)
{
    const std::size_t channels = std::size_t(level.channels), row = channels * std::size_t(level.width);
    const auto values = floats(level);
    Image out = level;
    if (bits != 32) {
        out = Image{level.width, level.height, level.channels, bits == 8 ? PixelType::U8 : PixelType::U16, bits, false, {}};
        out.data.resize(values.size() * bytesOf(out.type));
    }
    tbb::parallel_for(0, level.height, [&](int y) {
        if (progress.cancelled())
            return;
        for (std::size_t at = std::size_t(y) * row; at < std::size_t(y + 1) * row; ++at) {
            const std::size_t c = at % channels;
            if (bits == 32)
                floats(out)[at] = floatOf(values[at], rules[c]);
            else
                put(out, at, codeOf(values[at], rules[c], scale[int(c)], bits == 8 ? 255u : 65535u));
        }
    });
    return out;
}

} // namespace

BakedMap storedMap(const BakedMapRow& row, const BakedMap& map, int bits, const Progress& progress)
{
    if (row.form == MapForm::Codes)
        return map;
    BakedMap out;
    out.slices = map.slices;
    if (bits != 32)
        for (int c = 0; c < row.channels; ++c)
            out.scale[c] = scaleOf(map, c, row.rules[std::size_t(c)], progress);
    for (const Image& level : map.levels)
        out.levels.push_back(storedLevel(level, row.rules, out.scale, bits, progress));
    return out;
}

} // namespace relievo
