// Measuring a set.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/set_measure.h"
#include "core/gltf/pictures.h"
#include "core/ground/file.h"
#include "core/ground/text.h"
#include "core/image/height_repair.h"
#include "core/image/pixels.h"
#include "core/image/sets/convention.h"
#include "core/image/sets/file_names.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <oneapi/tbb/parallel_for_each.h>
#include <tuple>

namespace relievo {
namespace {
std::string nameOf(const FoundMap& map)
{
    return map.file.filename().string();
}

FoundMap* find(TextureSet& set, MapKind kind)
{
    const auto found = std::ranges::find(set.maps, kind, &FoundMap::kind);
    return found == set.maps.end() ? nullptr : &*found;
}

const Image& imageOf(const TextureSet& set, const FoundMap& map)
{
    return set.images.at(map.file)->image;
}

void measureOne(const TextureSet& set, FoundMap& map)
{
    const Image& image = imageOf(set, map);
    if (map.kind == MapKind::Height) {
        const HeightPixels pixels(image, map.channel);
        std::tie(map.min, map.max) = rangeOf(pixels.image(), pixels.channel());
        map.channel = pixels.code() == HeightCode::None ? pixels.channel() : Channel::Rgb;
    } else {
        if (row(map.kind).channels == 1)
            map.channel = scalarChannel(image, map.channel);
        std::tie(map.min, map.max) = rangeOf(image, map.channel);
    }
    map.convention = row(map.kind).isColor && image.type != PixelType::F32 ? Convention::Srgb : Convention::Linear;
}

Warning directXWarning(const std::filesystem::path& file)
{
    return {"normal-directx", file.filename().string() + " is DirectX style: converted"};
}

std::string percent(double correlation)
{
    char text[16];
    std::snprintf(text, sizeof text, "%.2f", correlation);
    return text;
}

Convention normalByItself(const Image& image, Convention named)
{
    const double hand = handedness(image);
    if (std::abs(hand) >= kClearHandedness)
        return hand > 0 ? Convention::GL : Convention::DX;
    return named;
}

// Both maps speak: signs of the correlations.
void measurePair(TextureSet& set, FoundMap& height, FoundMap& normal, const NamedConventions& named)
{
    const Image& normals = imageOf(set, normal);
    const HeightPixels heights(imageOf(set, height), height.channel);
    const Agreement agreement = slopeAgreement(normals, heights.image(), heights.channel());
    if (clarity(agreement) < kClearAgreement) {
        set.warnings.push_back({"normal-contradicts-height",
            nameOf(normal) + " does not follow the slopes of " + nameOf(height) + " (correlation " + percent(clarity(agreement))
                + "): they may belong to different materials"});
        return;
    }
    if (agreement.red != 0)
        height.convention = agreement.red < 0 ? Convention::Height : Convention::Depth;
    if (agreement.red != 0 && agreement.green != 0)
        normal.convention = (agreement.red < 0) != (agreement.green < 0) ? Convention::GL : Convention::DX;
    if (named.height != Convention::Unsure && named.height != height.convention)
        set.warnings.push_back({"normal-contradicts-height",
            nameOf(height) + " is named a " + (named.height == Convention::Depth ? "depth" : "height") + " map, but " + nameOf(normal)
                + " says that white is " + (height.convention == Convention::Depth ? "deep" : "high") + ": the normal map is believed"});
    if (named.normal != Convention::Unsure && named.normal != normal.convention)
        set.warnings.push_back({"normal-contradicts-height",
            nameOf(normal) + " is named " + (named.normal == Convention::DX ? "DirectX" : "OpenGL") + " style, but " + nameOf(height)
                + " shows that it is " + (normal.convention == Convention::DX ? "DirectX" : "OpenGL") + " style: the pixels are believed"});
}

void tellConversions(TextureSet& set)
{
    if (const FoundMap* height = find(set, MapKind::Height)) {
        if (height->convention == Convention::Depth)
            set.warnings.push_back({"depth-map", nameOf(*height) + " is a depth map (white is deep): flipped"});
        for (Warning& warning : warningsOf(HeightPixels(imageOf(set, *height), height->channel), nameOf(*height)))
            set.warnings.push_back(std::move(warning));
    }
    if (const FoundMap* normal = find(set, MapKind::Normal)) {
        if (normal->convention == Convention::DX)
            set.warnings.push_back(directXWarning(normal->file));
        if (normal->convention == Convention::Unsure)
            set.warnings.push_back({"normal-unsure", nameOf(*normal) + " shows no direction style: taken as OpenGL"});
    }
}
} // namespace

namespace {
// The layer of an EXR file that holds the heights, where several are to choose from.
std::filesystem::path withHeightLayer(const std::filesystem::path& file)
{
    if (lowerSuffix(file) != ".exr")
        return file;
    const Expected<ImageInfo> info = readImageInfo(file);
    const std::optional<std::string> layer = info ? heightLayer(info->layers) : std::nullopt;
    return layer ? std::filesystem::path(layerName(file, *layer)) : file;
}
} // namespace

std::pair<std::filesystem::path, Channel> fileAndChannel(const std::filesystem::path& given)
{
    const std::string text = given.string();
    if (!pictureMayExist(given) || layerOf(given))
        for (const Channel channel : {Channel::R, Channel::G, Channel::B, Channel::A})
            if (const std::string end = '#' + std::string(wordOf(channel)); lowered(text).ends_with(end))
                return {text.substr(0, text.size() - end.size()), channel};
    return {given, Channel::Rgb};
}

MapSlot slotByHand(MapKind kind, const std::filesystem::path& given, DecodedImages& images, Warnings& warnings)
{
    const auto [name, channel] = fileAndChannel(given);
    const std::filesystem::path whole = absolutePath(name), file = kind == MapKind::Height ? withHeightLayer(whole) : whole;
    const std::string stem = file.stem().string();
    const std::optional<NamedLayer> layer = layerOf(file);
    MapSlot slot{file.string(), channel, kind == MapKind::Height && (endsInDepth(stem) || (layer && isDepthLayer(layer->layer)))};
    if (kind != MapKind::Normal)
        return slot;
    if (!images.contains(file))
        if (Expected<ImageRead> read = readImage(file))
            images[file] = std::make_shared<const ImageRead>(std::move(*read));
    const auto found = images.find(file);
    const Convention named = guessFromName(stem).convention;
    slot.invert = (found == images.end() ? named : normalByItself(found->second->image, named)) == Convention::DX;
    if (slot.invert)
        warnings.push_back(directXWarning(file));
    return slot;
}

void measureMaps(TextureSet& set, const NamedConventions& named)
{
    oneapi::tbb::parallel_for_each(set.maps, [&](FoundMap& map) { measureOne(set, map); });
    FoundMap *height = find(set, MapKind::Height), *normal = find(set, MapKind::Normal);
    if (height)
        height->convention = named.height != Convention::Unsure ? named.height : named.heightOtherwise;
    if (normal)
        normal->convention = normalByItself(imageOf(set, *normal), named.normal);
    if (height && normal)
        measurePair(set, *height, *normal, named);
    tellConversions(set);
}

} // namespace relievo
