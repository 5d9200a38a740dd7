// Reducing, converting and packing maps for export.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/map_images.h"
#include "core/ground/srgb.h"
#include "core/maps/maps.h"
#include "core/maps/surface/normal.h"
#include <charconv>
#include <cmath>
#include <tbb/parallel_for.h>

namespace relievo {

Image emptyImage(int width, int height, int channels, PixelType type)
{
    Image image{width, height, channels, type, int(bytesOf(type)) * 8, type == PixelType::F32, {}};
    image.data.resize(image.texelCount() * std::size_t(channels) * bytesOf(type));
    return image;
}

void store(Image& image, int x, int y, int channel, float value)
{
    const std::size_t at
        = (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * std::size_t(image.channels) + std::size_t(channel);
    const float unit = std::isfinite(value) ? std::clamp(value, 0.f, 1.f) : 0.f;
    if (image.type == PixelType::F32) {
        std::memcpy(image.data.data() + at * 4, &value, 4);
    } else if (image.type == PixelType::U16) {
        const auto stored = std::uint16_t(std::lround(unit * 65535.f));
        std::memcpy(image.data.data() + at * 2, &stored, 2);
    } else {
        image.data[at] = std::byte(std::lround(unit * 255.f));
    }
}

float sampled(const Image& image, float u, float v, int channel)
{
    const float x = u * float(image.width) - 0.5f, y = v * float(image.height) - 0.5f;
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    const float fx = x - float(x0), fy = y - float(y0);
    const auto at = [&](int i, int j) {
        return image.value(wrapIndex(i, image.width, Wrap::Repeat), wrapIndex(j, image.height, Wrap::Repeat), channel);
    };
    const float top = at(x0, y0) * (1.f - fx) + at(x0 + 1, y0) * fx, bottom = at(x0, y0 + 1) * (1.f - fx) + at(x0 + 1, y0 + 1) * fx;
    return top * (1.f - fy) + bottom * fy;
}

namespace {
// Share of texel i in [from, to).
float overlap(int i, double from, double to)
{
    return float(std::max(0.0, std::min(to, i + 1.0) - std::max(from, double(i))));
}

void normalizeTexel(Image& image, int x, int y)
{
    float n[3], length = 0.f;
    for (int k = 0; k < 3; ++k) {
        n[k] = image.value(x, y, k) * 2.f - 1.f;
        length += n[k] * n[k];
    }
    length = std::sqrt(length);
    for (int k = 0; k < 3 && length > 1e-6f; ++k)
        store(image, x, y, k, n[k] / length * 0.5f + 0.5f);
}
} // namespace

Image reduced(const Image& image, int size, Averaging averaging)
{
    const int longest = std::max(image.width, image.height);
    if (size <= 0 || longest <= size)
        return image;
    const double scale = double(longest) / double(size);
    Image out = emptyImage(std::max(1, int(std::lround(image.width / scale))), std::max(1, int(std::lround(image.height / scale))),
        image.channels, image.type);
    out.storedBits = image.storedBits;
    out.storedFloat = image.storedFloat;
    const double stepX = double(image.width) / out.width, stepY = double(image.height) / out.height;
    const bool asLight = averaging == Averaging::Srgb && image.type != PixelType::F32;
    tbb::parallel_for(0, out.height, [&](int y) {
        for (int x = 0; x < out.width; ++x) {
            for (int c = 0; c < out.channels; ++c) {
                const bool decode = asLight && c < 3;
                float sum = 0.f, weight = 0.f;
                for (int j = int(y * stepY); j < image.height && j < (y + 1) * stepY; ++j)
                    for (int i = int(x * stepX); i < image.width && i < (x + 1) * stepX; ++i) {
                        const float w = overlap(i, x * stepX, (x + 1) * stepX) * overlap(j, y * stepY, (y + 1) * stepY);
                        sum += w * (decode ? linearOf(image.value(i, j, c)) : image.value(i, j, c));
                        weight += w;
                    }
                const float mean = weight > 0.f ? sum / weight : 0.f;
                store(out, x, y, c, decode ? srgbOf(mean) : mean);
            }
            if (averaging == Averaging::Normals && out.channels >= 3)
                normalizeTexel(out, x, y);
        }
    });
    return out;
}

Image eightBit(const Image& image, bool srgb)
{
    if (!srgb || image.type != PixelType::F32)
        return withBits(image, 8);
    Image out = emptyImage(image.width, image.height, image.channels, PixelType::U8);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c)
                store(out, x, y, c, c < 3 ? srgbOf(image.value(x, y, c)) : image.value(x, y, c));
    return out;
}

Image heightImage(const HeightField& field, int bits)
{
    const PixelType type = bits == 8 ? PixelType::U8 : bits == 16 ? PixelType::U16 : PixelType::F32;
    Image out = emptyImage(field.width(), field.height(), 1, type);
    for (int y = 0; y < field.height(); ++y)
        for (int x = 0; x < field.width(); ++x)
            store(out, x, y, 0, field.texel(x, y));
    return out;
}

HeightField asLargeAsWritten(const HeightField& field, int size)
{
    const Image small = reduced(heightImage(field, 32), size, Averaging::Plain);
    if (small.width == field.width() && small.height == field.height() && field.storedBits() <= 16)
        return field;
    std::vector<float> heights;
    heights.reserve(small.texelCount());
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            heights.push_back(asStored(std::clamp(small.value(x, y, 0), 0.f, 1.f), 16));
    return HeightField(small.width, small.height, std::move(heights), field.wrap(), 16);
}

std::optional<Image> baseColorImage(const Material& material, int size)
{
    const Image *color = material.map(MapKind::Color), *opacity = material.map(MapKind::Opacity);
    if (!color && !opacity)
        return std::nullopt;
    if (!opacity)
        return eightBit(reduced(*color, size, Averaging::Srgb), true);
    const Image rgb = color ? eightBit(*color, true) : Image();
    const Image& larger = color && color->texelCount() >= opacity->texelCount() ? *color : *opacity;
    Image out = emptyImage(larger.width, larger.height, 4, PixelType::U8);
    tbb::parallel_for(0, out.height, [&](int y) {
        for (int x = 0; x < out.width; ++x) {
            const float u = (float(x) + 0.5f) / float(out.width), v = (float(y) + 0.5f) / float(out.height);
            for (int c = 0; c < 3; ++c)
                store(out, x, y, c, color ? sampled(rgb, u, v, c) : 1.f);
            store(out, x, y, 3, sampled(*opacity, u, v, 0));
        }
    });
    return reduced(out, size, Averaging::Srgb);
}

std::optional<Image> packedImage(const Material& material, int size)
{
    const Image *occlusion = material.map(MapKind::AmbientOcclusion), *roughness = material.map(MapKind::Roughness),
                *gloss = material.map(MapKind::Gloss), *metallic = material.map(MapKind::Metallic);
    const Image* largest = nullptr;
    for (const Image* map : {occlusion, roughness, gloss, metallic})
        if (map && (!largest || map->texelCount() > largest->texelCount()))
            largest = map;
    if (!largest)
        return std::nullopt;
    Image out = emptyImage(largest->width, largest->height, 3, PixelType::U8);
    tbb::parallel_for(0, out.height, [&](int y) {
        for (int x = 0; x < out.width; ++x) {
            const float u = (float(x) + 0.5f) / float(out.width), v = (float(y) + 0.5f) / float(out.height);
            store(out, x, y, 0, occlusion ? sampled(*occlusion, u, v, 0) : 1.f);
            store(out, x, y, 1, roughness ? sampled(*roughness, u, v, 0) : gloss ? 1.f - sampled(*gloss, u, v, 0) : 1.f);
            store(out, x, y, 2, metallic ? sampled(*metallic, u, v, 0) : 0.f);
        }
    });
    return reduced(out, size, Averaging::Plain);
}

std::optional<Image> normalImage(const Material& material, const Parameters& parameters, const Progress& progress)
{
    if (const Image* map = material.map(MapKind::Normal))
        return *map;
    if (!material.height)
        return std::nullopt;
    return normalFromHeight(material.height->withWrap(parameters.wrap), parameters.depth, progress);
}

float brightest(const Image& image)
{
    float most = 0.f;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c)
                if (const float value = image.value(x, y, c); std::isfinite(value))
                    most = std::max(most, value);
    return most;
}

double shortest(float value)
{
    char text[32];
    double number = double(value);
    const char* const end = std::to_chars(text, text + sizeof text, value).ptr;
    std::from_chars(text, end, number);
    return number;
}

std::string fileStem(const std::string& name)
{
    std::string stem;
    bool capital = false; // words are joined, so that the map's suffix stays a word of its own
    for (const char c : name) {
        const bool lower = c >= 'a' && c <= 'z';
        const bool plain = lower || (c & 0x80) != 0 || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
        if (plain)
            stem += capital && lower ? char(c - 'a' + 'A') : c;
        capital = !plain;
    }
    while (!stem.empty() && stem.front() == '.')
        stem.erase(stem.begin());
    std::size_t size = std::min<std::size_t>(stem.size(), 100);
    while (size > 0 && size < stem.size() && (stem[size] & 0xC0) == 0x80)
        --size; // no character is cut
    return stem.empty() ? "material" : stem.substr(0, size);
}

} // namespace relievo
