// The set that a project's slots describe, for telling what is in it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/height_repair.h"
#include "core/image/material.h"
#include "core/image/pixels.h"
#include "core/image/sets/texture_set.h"
#include "core/state/sample_names.h"
#include <algorithm>
#include <tuple>

namespace relievo {

namespace {

Convention conventionOf(const MapKindRow& row, const MapSlot& slot)
{
    if (row.kind == MapKind::Height)
        return slot.invert ? Convention::Depth : Convention::Height;
    if (row.kind == MapKind::Normal)
        return slot.invert ? Convention::DX : Convention::GL;
    return row.isColor ? Convention::Srgb : Convention::Linear;
}

FoundMap foundMap(const MapKindRow& row, const MapSlot& slot, const Image& image)
{
    FoundMap map{
        row.kind, slot.file, row.channels == 1 ? scalarChannel(image, slot.channel) : slot.channel, {}, conventionOf(row, slot), 0., 0.};
    map.info = {image.width, image.height, image.channels, image.storedBits, image.storedFloat};
    std::tie(map.min, map.max) = rangeOf(image, map.channel);
    return map;
}

// Heights are told as they are read: decoded, and what loading will do to them.
void addHeight(TextureSet& set, const MapSlot& slot, const Image& image)
{
    const HeightPixels pixels(image, slot.channel);
    FoundMap map = foundMap(row(MapKind::Height), slot, image);
    std::tie(map.min, map.max) = rangeOf(pixels.image(), pixels.channel());
    for (Warning& warning : warningsOf(pixels, map.file.filename().string()))
        set.warnings.push_back(std::move(warning));
    set.maps.push_back(std::move(map));
}

// A map that is made by formula has no file to measure: it is made.
void addSampleMap(TextureSet& set, const MapKindRow& row, const MapSlot& slot, const MapSlots& slots)
{
    MapSlots one;
    one[std::size_t(row.kind)] = slots[std::size_t(row.kind)];
    const auto material = loadMaterial(one);
    if (!material) {
        set.warnings.push_back({"map-missing", message(material.error())});
    } else if (const Image* image = material->map(row.kind)) {
        set.maps.push_back(foundMap(row, slot, *image));
    } else if (material->height) {
        const HeightField& field = *material->height;
        const auto [low, high] = std::ranges::minmax(field.texels());
        set.maps.push_back({row.kind, slot.file, Channel::R, {field.width(), field.height(), 1, field.storedBits(), false},
            conventionOf(row, slot), double(low), double(high)});
    }
}

} // namespace

TextureSet textureSetOf(const std::string& name, const MapSlots& slots, const std::filesystem::path& folder)
{
    TextureSet set;
    set.name = name;
    set.folder = folder;
    for (const MapKindRow& row : kMapKinds) {
        const MapSlot& slot = slots[std::size_t(row.kind)];
        if (slot.empty())
            continue;
        if (namesSample(slot.file)) {
            addSampleMap(set, row, slot, slots);
            continue;
        }
        if (!set.images.contains(slot.file)) {
            auto read = readImage(slot.file);
            if (!read) {
                set.warnings.push_back({"map-missing", message(read.error())});
                continue;
            }
            set.warnings.insert(set.warnings.end(), read->warnings.begin(), read->warnings.end());
            set.images[slot.file] = std::make_shared<const ImageRead>(std::move(*read));
        }
        const Image& image = set.images[slot.file]->image;
        if (hasChannel(image, slot.channel) && row.kind == MapKind::Height)
            addHeight(set, slot, image);
        else if (hasChannel(image, slot.channel))
            set.maps.push_back(foundMap(row, slot, image));
        else
            set.warnings.push_back(channelMissing(row.kind, slot));
    }
    return set;
}

} // namespace relievo
