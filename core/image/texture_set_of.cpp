// The set that a project's slots describe, for telling what is in it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/pixels.h"
#include "core/image/texture_set.h"

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

} // namespace

TextureSet textureSetOf(const std::string& name, const MapSlots& slots, const std::filesystem::path& folder)
{
    TextureSet set;
    set.name = name;
    set.folder = folder;
    for (const MapKindRow& row : kMapKinds) {
        const MapSlot& slot = slots[std::size_t(row.kind)];
        if (slot.empty() || slot.file.starts_with("sample:"))
            continue;
        if (!set.images.contains(slot.file)) {
            auto read = readImage(slot.file);
            if (!read) {
                set.warnings.push_back({"map-missing", message(read.error())});
                continue;
            }
            set.images[slot.file] = std::make_shared<const ImageRead>(std::move(*read));
        }
        set.maps.push_back(foundMap(row, slot, set.images[slot.file]->image));
    }
    return set;
}

} // namespace relievo
