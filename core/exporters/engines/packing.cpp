// Packing: each channel from its map, made equal in size, quantised once.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/engines/packing.h"
#include "core/exporters/map_images.h"
#include "core/ground/srgb.h"
#include "core/maps/acceleration/acceleration_map.h"
#include "core/maps/maps.h"
#include <cmath>
#include <cstring>
#include <tbb/parallel_for.h>

namespace relievo {
namespace {
using From = PackedChannel::From;

// Where a channel's numbers come from: an image, or one value.
struct ChannelSource {
    std::shared_ptr<const Image> image;
    int channel = 0;
    float value = 0.f;
    bool inverted = false, linearColor = false, dithers = false;
    PackedChannel::Part part = PackedChannel::Part::All;

    float at(int x, int y, int width, int height) const
    {
        float v = value;
        if (image && image->width == width && image->height == height)
            v = image->value(x, y, channel);
        else if (image)
            v = sampled(*image, (float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height), channel);
        if (part != PackedChannel::Part::All) {
            const long code = std::lround(v * 65535.f);
            v = float(part == PackedChannel::Part::HighByte ? code >> 8 : code & 255) / 255.f;
        }
        if (linearColor)
            v = srgbOf(v);
        return inverted ? 1.f - v : v;
    }

    // Whether the numbers go into a picture as they are.
    bool isCopiedTo(const Image& out) const
    {
        return image && image->width == out.width && image->height == out.height && image->type == out.type && !inverted && !linearColor
            && !dithers && part == PackedChannel::Part::All && out.type != PixelType::F32;
    }
    void copyRow(Image& out, int y, int c) const
    {
        const std::size_t bytes = bytesOf(out.type), from = bytes * std::size_t(image->channels), to = bytes * std::size_t(out.channels);
        const std::byte* source = image->data.data() + std::size_t(y) * std::size_t(out.width) * from + bytes * std::size_t(channel);
        std::byte* target = out.data.data() + std::size_t(y) * std::size_t(out.width) * to + bytes * std::size_t(c);
        for (int x = 0; x < out.width; ++x, source += from, target += to)
            std::memcpy(target, source, bytes);
    }
};

// In [0, 1), different from texel to texel and evenly spread (interleaved gradient noise, Jimenez 2014).
float threshold(int x, int y)
{
    const float v = 52.9829189f * std::fmod(0.06711056f * float(x) + 0.00583715f * float(y), 1.f);
    return v - std::floor(v);
}

class Packer {
public:
    Packer(const PackedTexture& texture, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters)
        : m_texture(texture)
        , m_job(job)
        , m_material(*job.resources.material)
        , m_heights(heights)
        , m_parameters(parameters)
    {
    }

    Image picture()
    {
        int width = 1, height = 1;
        for (const PackedChannel& channel : m_texture.channels) {
            if (channel.kind == MapKind::Opacity && !m_material.map(MapKind::Opacity) && m_sources.size() == 3)
                continue; // no alpha where nothing is transparent
            if (channel.baked == kOwnMap && channel.channel >= channelsOfOwnMap())
                continue;
            m_sources.push_back(sourceOf(channel));
            if (const Image* image = m_sources.back().image.get();
                image && image->texelCount() > std::size_t(width) * std::size_t(height)) {
                width = image->width;
                height = image->height;
            }
        }
        if (m_sources.size() == 2 && m_texture.channels.front().baked == kOwnMap)
            m_sources.emplace_back(); // pictures of two channels are taken for grey with alpha
        if (m_job.progress.cancelled())
            return {};
        const PixelType type = m_texture.bits == 8 ? PixelType::U8 : m_texture.bits == 16 ? PixelType::U16 : PixelType::F32;
        Image out = emptyImage(width, height, int(m_sources.size()), type);
        tbb::parallel_for(0, height, [&](int y) {
            for (int c = 0; c < out.channels; ++c) {
                const ChannelSource& source = m_sources[std::size_t(c)];
                if (source.isCopiedTo(out)) {
                    source.copyRow(out, y, c);
                    continue;
                }
                for (int x = 0; x < width; ++x) {
                    const float v = source.at(x, y, width, height);
                    store(out, x, y, c, source.dithers ? std::floor(v * 255.f + threshold(x, y)) / 255.f : v);
                }
            }
        });
        return out;
    }

private:
    ChannelSource sourceOf(const PackedChannel& channel)
    {
        ChannelSource source{nullptr, channel.channel, channel.value, channel.inverted};
        source.part = channel.part;
        switch (channel.from) {
        case From::Constant:
            break;
        case From::Height:
            if (m_heights.field)
                source.image = fitted("height", heightImage(*m_heights.field, m_texture.bits == 32 ? 32 : 16), Averaging::Plain);
            source.value = 1.f;
            source.dithers
                = m_texture.bits == 8 && m_job.cures.contains(Cure::Dither) && m_heights.field && m_heights.field->storedBits() > 8;
            break;
        case From::Normal:
            source.image = normals();
            source.value = channel.channel == 2 ? 1.f : 0.5f;
            break;
        case From::Map:
            takeMap(channel, source);
            break;
        case From::Baked:
            source.image = channel.baked == kOwnMap ? ownMap() : baked(channel.baked);
            break;
        }
        return source;
    }

    void takeMap(const PackedChannel& channel, ChannelSource& source)
    {
        const MapKindRow& kind = row(channel.kind);
        const Image* map = m_material.map(channel.kind);
        source.value = channel.kind == MapKind::Color                ? srgbOf(kColorWithoutMap)
            : kind.withoutMap.find("0.0f") != std::string_view::npos ? 0.f
                                                                     : 1.f;
        if (!map && channel.kind == MapKind::Roughness && (map = m_material.map(MapKind::Gloss)))
            source.inverted = !source.inverted;
        if (!map)
            return;
        source.image = fitted(std::string(kind.key), *map, kind.isColor ? Averaging::Srgb : Averaging::Plain);
        source.linearColor = kind.isColor && map->type == PixelType::F32 && m_texture.bits != 32;
    }

    std::shared_ptr<const Image> normals()
    {
        std::shared_ptr<const Image>& kept = m_fitted["normal"];
        if (kept)
            return kept;
        std::optional<Image> normal;
        if (m_material.map(MapKind::Normal) || m_job.cures.contains(Cure::Normals))
            normal = normalImage(m_material, m_parameters, m_job.progress);
        if (normal)
            kept = std::make_shared<const Image>(reduced(*normal, m_job.size, Averaging::Normals));
        return kept;
    }

    std::shared_ptr<const Image> baked(const std::string& key)
    {
        if (!m_heights.field)
            return nullptr;
        const auto found = std::ranges::find(kBakedMaps, key, &BakedMapRow::key);
        const auto map = cachedMap(*found, m_heights.field->withWrap(m_parameters.wrap), m_parameters, m_job.progress);
        return map ? std::shared_ptr<const Image>(*map, &(*map)->levels.front()) : nullptr;
    }

    int channelsOfOwnMap() const { return ownMap() ? ownMap()->channels : 0; }

    // The technique's, as its search reads it; null when it has none.
    std::shared_ptr<const Image> ownMap() const
    {
        const TechniqueRow* const technique = findTechnique(techniqueOf(m_job));
        if (!m_ownMap && m_heights.field && technique && !technique->accelerationMap.empty())
            if (const auto map = makeAccelerationMap(technique->accelerationMap, *m_heights.field, m_parameters, false, m_job.progress))
                m_ownMap = std::shared_ptr<const Image>(*map, &(*map)->levels.front());
        return m_ownMap;
    }

    std::shared_ptr<const Image> fitted(const std::string& key, const Image& map, Averaging averaging)
    {
        std::shared_ptr<const Image>& kept = m_fitted[key];
        if (!kept)
            kept = std::make_shared<const Image>(reduced(map, m_job.size, averaging));
        return kept;
    }

    const PackedTexture& m_texture;
    const ExportJob& m_job;
    const Material& m_material;
    const WrittenHeights& m_heights;
    const Parameters& m_parameters;
    std::vector<ChannelSource> m_sources;
    mutable std::shared_ptr<const Image> m_ownMap;
    std::map<std::string, std::shared_ptr<const Image>> m_fitted;
};
} // namespace

Parameters WrittenHeights::with(const Parameters& parameters) const
{
    Parameters written = parameters;
    written.depth *= span;
    written.midlevel = std::clamp(midlevel(parameters), 0.f, 1.f);
    return written;
}

float WrittenHeights::coarseness(const Parameters& parameters) const
{
    return isFine ? parameters.depth * span / 255.f * float(field->width()) : 0.f;
}

WrittenHeights writtenHeights(const ExportJob& job, const Parameters& parameters)
{
    WrittenHeights written{job.resources.material->height};
    if (!written.field)
        return written;
    written.isFine = written.field->storedBits() > 8;
    written.field = asLargeAsWritten(*written.field, job.size).withWrap(parameters.wrap);
    if (!job.cures.contains(Cure::FullRange))
        return written;
    const auto [low, high] = std::ranges::minmax(written.field->texels());
    if (low == high || (low == 0.f && high == 1.f)) // flat heights have no range to use
        return written;
    written.low = low;
    written.span = high - low;
    std::vector<float> stretched(written.field->texels().begin(), written.field->texels().end());
    for (float& h : stretched)
        h = std::round(std::clamp((h - written.low) / written.span, 0.f, 1.f) * 65535.f)
            / 65535.f; // as it is written: maps are baked of it
    written.field = HeightField(
        written.field->width(), written.field->height(), std::move(stretched), parameters.wrap, std::max(written.field->storedBits(), 16));
    return written;
}

namespace {
bool hasOwnMap(const ExportJob& job)
{
    const TechniqueRow* const technique = findTechnique(techniqueOf(job));
    return technique && !technique->accelerationMap.empty();
}
} // namespace

bool ownMapHoldsCodes(const ExportJob& job)
{
    return hasOwnMap(job) && findBakedMap(findTechnique(techniqueOf(job))->accelerationMap)->form == MapForm::Codes;
}

bool isPresent(const PackedTexture& texture, const ExportJob& job)
{
    const Material& material = *job.resources.material;
    return std::ranges::any_of(texture.channels, [&](const PackedChannel& channel) {
        switch (channel.from) {
        case From::Constant:
            return false;
        case From::Height:
            return material.height.has_value();
        case From::Baked:
            return material.height && (channel.baked != kOwnMap || hasOwnMap(job));
        case From::Normal:
            return material.map(MapKind::Normal) || (material.height && job.cures.contains(Cure::Normals));
        case From::Map:
            return material.map(channel.kind) || (channel.kind == MapKind::Roughness && material.map(MapKind::Gloss));
        }
        return false;
    });
}

Image packed(const PackedTexture& texture, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters)
{
    return Packer(texture, job, heights, parameters).picture();
}

std::string contentOf(const PackedTexture& texture, const ExportJob& job, const WrittenHeights& heights, const Parameters& parameters)
{
    std::string content = std::filesystem::path(texture.file).extension().string() + ' ' + std::to_string(texture.bits) + ' '
        + std::to_string(texture.srgb) + ' ' + std::to_string(job.size);
    for (const PackedChannel& channel : texture.channels) {
        content += ' ' + channel.word;
        if (channel.from == From::Height || channel.from == From::Baked)
            content += " of " + std::to_string(heights.low) + ' ' + std::to_string(heights.span) + ' '
                + std::to_string(job.cures.contains(Cure::Dither));
        if (channel.baked == kOwnMap)
            content += ' ' + techniqueOf(job);
        if (channel.from == From::Baked || channel.from == From::Normal)
            content += " at " + std::to_string(parameters.depth) + ' ' + std::to_string(job.cures.contains(Cure::Normals));
    }
    return content;
}

} // namespace relievo
