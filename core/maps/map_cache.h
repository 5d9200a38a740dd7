// Baked maps kept in memory and on disk, by the content that they were baked from.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/height_field.h"
#include "core/maps/baked_map.h"
#include "core/maps/map_shape.h"
#include "core/state/parameters.h"
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace relievo {

struct BakedMapRow;

// Everything that a stored map depends on, as text: row, its version and bits, size, wrap, a 128-bit hash of the heights (xxHash) and
// the parameters that the row names. About 1 ms for 1024 x 1024.
std::string mapKey(const BakedMapRow& row, const HeightField& field, const Parameters& parameters);

// In memory: the maps used last, at most 16 and kMemoryBytes. Safe from any thread.
inline constexpr std::size_t kMemoryMaps = 16, kMemoryBytes = std::size_t(512) << 20;
std::shared_ptr<const BakedMap> mapInMemory(const std::string& key); // null when it is not there
void keepInMemory(const std::string& key, std::shared_ptr<const BakedMap> map, std::size_t limit = kMemoryBytes);
void forgetMapsInMemory();

// RELIEVO_CACHE, or relievo/ in XDG_CACHE_HOME or ~/.cache; nothing when it is "off" or there is no home.
std::optional<std::filesystem::path> cacheFolder();

// On disk: one file a map, which echoes its key and ends in a checksum. What is not exactly as it was written, or of another
// shape, is not read, nor what there is no memory for.
std::optional<BakedMap> mapOnDisk(const std::filesystem::path& folder, const std::string& key, const MapShape& shape);
// Writes atomically, then removes the files used longest ago until all fit in `limit` bytes; files that the cache did not write are
// neither counted nor removed. A folder that cannot be made or written, a full disk or too little memory only means that nothing is
// kept.
void keepOnDisk(const std::filesystem::path& folder, const std::string& key, const BakedMap& map, std::uintmax_t limit = 2ull << 30);

// The bytes of such a file.
std::vector<std::byte> packedMap(const std::string& key, const BakedMap& map);
std::optional<BakedMap> unpackedMap(const std::string& key, const MapShape& shape, std::span<const std::byte> bytes);

} // namespace relievo
