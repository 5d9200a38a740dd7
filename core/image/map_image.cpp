// Channel picks, green flips, rebuilt normals.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/map_image.h"
#include "core/image/height_repair.h"
#include "core/image/pixels.h"
#include "core/image/sets/convention.h"
#include <array>
#include <cmath>
#include <limits>
#include <oneapi/tbb/parallel_for.h>
#include <span>

namespace relievo {
namespace {
int precisionOf(const Image& image)
{
    return image.type == PixelType::U8 ? 8 : image.type == PixelType::U16 ? 16 : 32;
}

Image emptyLike(const Image& image, int channels)
{
    Image result{image.width, image.height, channels, image.type, image.storedBits, image.storedFloat, {}};
    result.data.resize(result.texelCount() * std::size_t(channels) * bytesOf(image.type));
    return result;
}

// Calls fill(from, to, maximum) for every texel: from is the source's texel, to the result's.
template <class Fill> Image convert(const Image& image, int channels, Fill fill)
{
    Image result = emptyLike(image, channels);
    withTexels(image, [&](const auto* texels, float maximum) {
        using Texel = std::remove_const_t<std::remove_pointer_t<decltype(texels)>>;
        Texel* out = reinterpret_cast<Texel*>(result.data.data());
        oneapi::tbb::parallel_for(0, image.height, [&](int y) {
            const std::size_t row = std::size_t(y) * std::size_t(image.width);
            for (std::size_t i = row; i < row + std::size_t(image.width); ++i)
                fill(texels + i * std::size_t(image.channels), out + i * std::size_t(channels), maximum);
        });
    });
    return result;
}

template <class Texel> Texel fromUnit(float value, float maximum)
{
    if constexpr (std::is_integral_v<Texel>)
        return Texel(std::clamp(value, 0.f, 1.f) * maximum + 0.5f);
    else
        return value;
}

// The three colour channels; greys and single channels are repeated.
Image colorOf(const Image& image, Channel channel)
{
    const auto [first, last] = channelRange(image, channel);
    const std::array<int, 3> picks = {first, last - first == 3 ? first + 1 : first, last - first == 3 ? first + 2 : first};
    return convert(image, 3, [picks](const auto* from, auto* to, float) {
        for (std::size_t c = 0; c < 3; ++c)
            to[c] = from[picks[c]];
    });
}

Image inverted(const Image& image)
{
    return convert(image, image.channels, [&image](const auto* from, auto* to, float maximum) {
        using Texel = std::remove_reference_t<decltype(*to)>;
        for (int c = 0; c < image.channels; ++c)
            to[c] = std::is_integral_v<Texel> ? Texel(Texel(maximum) - from[c]) : Texel(1 - from[c]);
    });
}

void repairFloats(Image& image, const std::string& file, Warnings& warnings)
{
    std::vector<float> values(image.data.size() / sizeof(float));
    std::memcpy(values.data(), image.data.data(), image.data.size());
    ScalarTrouble trouble;
    trouble.nonFinite = repairNonFinite(values, image.width, image.height, image.channels);
    std::memcpy(image.data.data(), values.data(), image.data.size());
    for (Warning& warning : warningsOf(trouble, file))
        warnings.push_back(std::move(warning));
}

// One channel. Floats are made sound: finite, in [0, 1].
Image scalarOf(const Image& image, const MapSlot& slot, const std::string& file, Warnings& warnings)
{
    const Channel channel = scalarChannel(image, slot.channel);
    for (Warning& warning : warningsOf(scalarTrouble(image, channel, Beyond::Clamped), file))
        warnings.push_back(std::move(warning));
    if (image.type == PixelType::F32) {
        const std::vector<float> values = soundScalars(image, channel, slot.invert, Beyond::Clamped);
        Image result = emptyLike(image, 1);
        std::memcpy(result.data.data(), values.data(), result.data.size());
        return result;
    }
    const auto [first, last] = channelRange(image, channel);
    const int pick = first;
    const bool mean = last - first == 3;
    Image result = convert(image, 1, [pick, mean](const auto* from, auto* to, float) {
        using Texel = std::remove_reference_t<decltype(*to)>;
        if (mean)
            to[0] = Texel((float(from[0]) + float(from[1]) + float(from[2])) / 3 + (std::is_integral_v<Texel> ? 0.5f : 0.f));
        else
            to[0] = from[pick];
    });
    return slot.invert ? inverted(result) : result;
}

// n * 0.5 + 0.5 from x and y in [-1, 1]; what lies outside the unit disc is laid on its rim.
std::array<float, 3> rebuilt(float x, float y)
{
    const float square = x * x + y * y;
    const float scale = square > 1 ? 1 / std::sqrt(square) : 1.f;
    const float z = square > 1 ? 0.f : std::sqrt(1 - square);
    return {x * scale * 0.5f + 0.5f, y * scale * 0.5f + 0.5f, z * 0.5f + 0.5f};
}

struct NormalReader {
    NormalLayout layout;
    int x, y; // channels
    bool alreadySigned; // floats in [-1, 1]
    bool flipGreen;
};

template <class Texel> void readNormal(const NormalReader& reader, const Texel* from, Texel* to, float maximum)
{
    const auto component = [&](int c) { return reader.alreadySigned ? float(from[c]) : 2 * float(from[c]) / maximum - 1; };
    std::array<float, 3> stored;
    if (reader.layout == NormalLayout::Xyz)
        stored = {component(0) * 0.5f + 0.5f, component(1) * 0.5f + 0.5f, component(2) * 0.5f + 0.5f};
    else
        stored = rebuilt(component(reader.x), component(reader.y));
    if (reader.flipGreen)
        stored[1] = 1 - stored[1];
    for (std::size_t c = 0; c < 3; ++c)
        to[c] = fromUnit<Texel>(stored[c], maximum);
}

Image normalOf(const Image& image, const MapSlot& slot, bool namedRelief)
{
    NormalReader reader{normalLayout(image, namedRelief), 0, 1, false, slot.invert};
    if (reader.layout == NormalLayout::AlphaGreen)
        reader.x = 3;
    reader.alreadySigned = image.type == PixelType::F32 && rangeOf(image, Channel::Rgb).first < -0.01;
    if (reader.layout == NormalLayout::Xyz && !reader.alreadySigned) { // exact: values are only moved
        return convert(image, 3, [flip = slot.invert](const auto* from, auto* to, float maximum) {
            using Texel = std::remove_reference_t<decltype(*to)>;
            to[0] = from[0];
            to[1] = !flip ? from[1] : std::is_integral_v<Texel> ? Texel(Texel(maximum) - from[1]) : Texel(1 - from[1]);
            to[2] = from[2];
        });
    }
    return convert(image, 3, [&reader](const auto* from, auto* to, float maximum) { readNormal(reader, from, to, maximum); });
}
} // namespace

HeightField heightOf(const Image& image, const MapSlot& slot, const std::string& file, Warnings& warnings)
{
    const HeightPixels pixels(image, slot.channel);
    const Channel channel = pixels.channel();
    for (Warning& warning : warningsOf(pixels, file))
        warnings.push_back(std::move(warning));
    const int bits = precisionOf(pixels.image());
    std::vector<float> heights = soundScalars(pixels.image(), channel, slot.invert);
    if (slot.invert || channel == Channel::Rgb) // 1 - v and a mean are no stored values to the last bit, and the GPU has only those
        for (float& height : heights)
            height = asStored(height, bits);
    return HeightField(image.width, image.height, std::move(heights), Wrap::Repeat, bits);
}

namespace {
// Whether the values stand for themselves: whole numbers, or colours and vectors from 0 on.
bool needsNoRepair(const Image& image, Channel channel)
{
    if (image.channels == 1)
        return image.type != PixelType::F32;
    const std::span values(reinterpret_cast<const float*>(image.data.data()), image.data.size() / sizeof(float));
    return channel == Channel::Rgb && (image.type != PixelType::F32 || std::ranges::all_of(values, [](float v) {
        return v >= 0.f && v <= std::numeric_limits<float>::max();
    }));
}
} // namespace

Expected<std::shared_ptr<const Image>> mapOf(
    MapKind kind, const DecodedFile& decoded, const MapSlot& slot, const std::string& file, bool namedRelief, Warnings& warnings)
{
    const Image& image = decoded->image;
    if (kind == MapKind::Normal && image.channels == 1)
        return failure(file, "it has one channel, so it cannot be a normal map", "Assign it as the height map instead");
    if (kind == MapKind::Optics && image.channels < 3)
        return failure(file,
            "it has " + std::string(image.channels == 1 ? "one channel" : "two channels") + ", so it cannot be an optics map",
            "Put shininess, refraction and mirror into red, green and blue, or assign it as the gloss map");
    if (image.channels == row(kind).channels && !slot.invert && needsNoRepair(image, slot.channel)
        && (kind != MapKind::Normal || normalLayout(image, namedRelief) == NormalLayout::Xyz))
        return std::shared_ptr<const Image>(decoded, &decoded->image);
    if (row(kind).channels == 1)
        return std::make_shared<const Image>(scalarOf(image, slot, file, warnings));
    Image result = kind == MapKind::Normal ? normalOf(image, slot, namedRelief) : colorOf(image, slot.channel);
    if (image.type == PixelType::F32)
        repairFloats(result, file, warnings);
    if (slot.invert && kind != MapKind::Normal)
        result = inverted(result);
    return std::make_shared<const Image>(std::move(result));
}

} // namespace relievo
