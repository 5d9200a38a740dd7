// Baking a row of the maps table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/maps.h"
#include "core/maps/float_image.h"
#include "core/maps/map_cache.h"
#include "core/maps/map_shape.h"
#include "core/maps/memory_guard.h"
#include "core/maps/surface/normal.h"
#include <algorithm>
#include <cmath>
#include <cstring>

namespace relievo {

BakedMap bakeNormal(const HeightField& field, const Parameters& parameters, const Progress& progress)
{
    return oneLevel(normalsOf(field, parameters.depth * parameters.normalStrength, progress));
}

const BakedMapRow* findBakedMap(std::string_view key)
{
    const auto found = std::ranges::find(kBakedMaps, key, &BakedMapRow::key);
    return found == kBakedMaps.end() ? nullptr : &*found;
}

namespace {
template <class Bake> Expected<BakedMap> baked(const BakedMapRow& row, const Progress& progress, Bake bake)
{
    return withinMemory(row.key, [&]() -> Expected<BakedMap> {
        BakedMap map = bake();
        if (progress.cancelled())
            return cancelled(std::string(row.key));
        return map;
    });
}

// Stored in row.bits. The floats end here, so that they take no memory while the result is packed for the disk.
Expected<BakedMap> bakedInBits(const BakedMapRow& row, const HeightField& field, const Parameters& parameters, const Progress& progress)
{
    const auto made = bakeMap(row, field, parameters, progress);
    if (!made)
        return tl::unexpected(made.error());
    return baked(row, progress, [&] { return storedMap(row, *made, row.bits, progress); });
}
} // namespace

Expected<BakedMap> bakeMap(const BakedMapRow& row, const HeightField& field, const Parameters& parameters, const Progress& progress)
{
    if (!row.bake)
        return failure(std::string(row.key), "this map is made from a normal map, not from a height map", "Add a normal map");
    return baked(row, progress, [&] { return row.bake(field, parameters, progress); });
}

Expected<BakedMap> bakeMapFromNormals(
    const BakedMapRow& row, const Image& normals, Wrap wrap, float& depthInTiles, const Progress& progress)
{
    if (!row.bakeFromNormals)
        return failure(std::string(row.key), "this map is made from a height map, not from a normal map", "Add a height map");
    return baked(row, progress, [&] { return row.bakeFromNormals(normals, wrap, depthInTiles, progress); });
}

Expected<std::shared_ptr<const BakedMap>> cachedMap(
    const BakedMapRow& row, const HeightField& field, const Parameters& parameters, const Progress& progress)
{
    return withinMemory(row.key, [&]() -> Expected<std::shared_ptr<const BakedMap>> {
        const std::string key = mapKey(row, field, parameters);
        if (auto kept = mapInMemory(key))
            return kept;
        const auto folder = cacheFolder();
        auto read = folder ? mapOnDisk(*folder, key, shapeOf(row, field)) : std::nullopt;
        if (read && !hasSoundValues(row, field, *read))
            read.reset();
        if (!read) {
            auto made = bakedInBits(row, field, parameters, progress);
            if (!made)
                return tl::unexpected(made.error());
            read = std::move(*made);
            if (folder)
                keepOnDisk(*folder, key, *read);
        }
        auto map = std::make_shared<const BakedMap>(std::move(*read));
        keepInMemory(key, map);
        return map;
    });
}

Image withBits(const Image& image, int bits)
{
    const PixelType type = bits == 8 ? PixelType::U8 : bits == 16 ? PixelType::U16 : PixelType::F32;
    if (type == image.type)
        return image;
    Image out{image.width, image.height, image.channels, type, bits, bits == 32, {}};
    out.data.resize(image.texelCount() * std::size_t(image.channels) * bytesOf(type));
    std::size_t at = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c, ++at) {
                const float value = image.value(x, y, c), unit = std::clamp(std::isnan(value) ? 0.f : value, 0.f, 1.f);
                if (type == PixelType::F32) {
                    std::memcpy(out.data.data() + at * 4, &value, 4);
                } else if (type == PixelType::U16) {
                    const std::uint16_t stored = std::uint16_t(std::lround(unit * 65535.f));
                    std::memcpy(out.data.data() + at * 2, &stored, 2);
                } else {
                    out.data[at] = std::byte(std::lround(unit * 255.f));
                }
            }
    return out;
}

} // namespace relievo
