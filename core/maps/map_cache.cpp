// The cache of baked maps.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/map_cache.h"
#include "core/ground/file.h"
#include "core/ground/hash.h"
#include "core/maps/maps.h"
#include "core/state/techniques.h"
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <list>
#include <mutex>
#include <new>
#include <xxhash.h>

namespace relievo {
namespace fs = std::filesystem;

namespace {

struct Kept {
    std::string key;
    std::shared_ptr<const BakedMap> map;
};
struct Memory {
    std::mutex mutex;
    std::list<Kept> maps; // the one used last in front
};
Memory& memory()
{
    static Memory one;
    return one;
}

// File: kMagic, head, key, level heads, level data, checksum of all before. In the machine's byte order: the cache stays on it.
constexpr char kMagic[8] = {'R', 'L', 'V', 'M', 'A', 'P', '0', '1'};
struct Head {
    std::uint32_t keyBytes = 0, levels = 0;
    std::int32_t slices = 0;
    float scale[4] = {};
};
struct LevelHead {
    std::int32_t width = 0, height = 0, channels = 0, type = 0, storedBits = 0, storedFloat = 0;
};

template <class T> void append(std::vector<std::byte>& out, const T* data, std::size_t count)
{
    const auto bytes = std::as_bytes(std::span(data, count));
    out.insert(out.end(), bytes.begin(), bytes.end());
}

// Reads from the front; false when too little is left.
struct Reader {
    std::span<const std::byte> left;
    bool take(void* to, std::size_t size)
    {
        if (size > left.size())
            return false;
        std::memcpy(to, left.data(), size);
        left = left.subspan(size);
        return true;
    }
};

// A level that must be of this size; what the file tells is only compared.
bool readLevel(Reader& heads, Reader& data, const MapShape& shape, MapShape::Level size, Image& image)
{
    LevelHead head;
    if (!heads.take(&head, sizeof head) || head.width != size.width || head.height != size.height || head.channels != shape.channels
        || head.type != int(shape.type))
        return false;
    image = {size.width, size.height, shape.channels, shape.type, int(bytesOf(shape.type)) * 8, shape.type == PixelType::F32, {}};
    const std::size_t texelBytes = std::size_t(shape.channels) * bytesOf(shape.type);
    if (image.texelCount() > data.left.size() / texelBytes)
        return false;
    image.data.resize(image.texelCount() * texelBytes);
    return data.take(image.data.data(), image.data.size());
}

fs::path fileOf(const fs::path& folder, const std::string& key)
{
    return folder / (hexHash(key) + ".map");
}

// Whether the cache writes such names: those of fileOf, and the temporary ones of writeAtomically, which a crash leaves behind.
bool isOwnName(std::string_view name)
{
    constexpr std::size_t kDigits = 32;
    const bool isMap = name.size() > kDigits && name.find_first_not_of("0123456789abcdef") == kDigits && name.substr(kDigits) == ".map";
    const std::string_view temporary = kTemporaryName.substr(0, kTemporaryName.find('X'));
    return isMap || (name.starts_with(temporary) && name.size() == kTemporaryName.size());
}

void trim(const fs::path& folder, std::uintmax_t limit)
{
    struct File {
        fs::path path;
        fs::file_time_type used;
        std::uintmax_t size;
    };
    std::vector<File> files;
    std::uintmax_t sum = 0;
    std::error_code code;
    for (fs::directory_iterator at(folder, code), end; !code && at != end; at.increment(code)) {
        std::error_code gone; // another program may remove files meanwhile
        const File file{at->path(), at->last_write_time(gone), at->file_size(gone)};
        if (gone || !isOwnName(file.path.filename().string()))
            continue;
        files.push_back(file);
        sum += file.size;
    }
    std::ranges::sort(files, {}, &File::used);
    for (const File& file : files) {
        if (sum <= limit)
            break;
        fs::remove(file.path, code);
        if (!code)
            sum -= file.size;
    }
}

std::size_t packedSize(const std::string& key, const BakedMap& map)
{
    return sizeof kMagic + sizeof(Head) + key.size() + map.levels.size() * sizeof(LevelHead) + map.bytes() + sizeof(std::uint64_t);
}

} // namespace

std::string mapKey(const BakedMapRow& row, const HeightField& field, const Parameters& parameters)
{
    std::string key = std::string(row.key) + " version " + std::to_string(row.version) + " bits " + std::to_string(row.bits) + " size "
        + std::to_string(field.width()) + 'x' + std::to_string(field.height()) + (field.wrap() == Wrap::Repeat ? " repeat " : " clamp ")
        + hexHash(std::as_bytes(field.texels()));
    for (const ParameterRow& parameter : kParameters)
        if (row.parameters.contains(parameter))
            key += ' ' + std::string(parameter.key) + '=' + toText(parameter, get(parameters, parameter));
    return key;
}

std::shared_ptr<const BakedMap> mapInMemory(const std::string& key)
{
    const std::lock_guard lock(memory().mutex);
    std::list<Kept>& maps = memory().maps;
    const auto found = std::ranges::find(maps, key, &Kept::key);
    if (found == maps.end())
        return nullptr;
    maps.splice(maps.begin(), maps, found);
    return found->map;
}

void keepInMemory(const std::string& key, std::shared_ptr<const BakedMap> map, std::size_t limit)
{
    const std::lock_guard lock(memory().mutex);
    std::list<Kept>& maps = memory().maps;
    std::erase_if(maps, [&](const Kept& kept) { return kept.key == key; });
    maps.push_front({key, std::move(map)});
    std::size_t bytes = 0, count = 0;
    std::erase_if(maps, [&](const Kept& kept) {
        if (count == kMemoryMaps || bytes + kept.map->bytes() > limit)
            return true;
        bytes += kept.map->bytes();
        ++count;
        return false;
    });
}

void forgetMapsInMemory()
{
    const std::lock_guard lock(memory().mutex);
    memory().maps.clear();
}

std::optional<fs::path> cacheFolder()
{
    const auto named = [](const char* variable) {
        const char* value = std::getenv(variable);
        return std::string(value ? value : "");
    };
    if (const std::string folder = named("RELIEVO_CACHE"); !folder.empty())
        return folder == "off" ? std::nullopt : std::optional(fs::path(folder));
    if (const std::string folder = named("XDG_CACHE_HOME"); !folder.empty())
        return fs::path(folder) / "relievo";
    if (const std::string folder = named("HOME"); !folder.empty())
        return fs::path(folder) / ".cache" / "relievo";
    return std::nullopt;
}

std::optional<BakedMap> mapOnDisk(const fs::path& folder, const std::string& key, const MapShape& shape)
{
    try {
        const fs::path file = fileOf(folder, key);
        const auto bytes = readBytes(file);
        if (!bytes)
            return std::nullopt;
        auto map = unpackedMap(key, shape, *bytes);
        std::error_code code;
        if (map)
            fs::last_write_time(file, fs::file_time_type::clock::now(), code); // used just now
        return map;
    } catch (const std::bad_alloc&) {
        return std::nullopt;
    }
}

void keepOnDisk(const fs::path& folder, const std::string& key, const BakedMap& map, std::uintmax_t limit)
{
    try {
        std::error_code code;
        fs::create_directories(folder, code);
        if (packedSize(key, map) > limit || !writeAtomically(fileOf(folder, key), packedMap(key, map)))
            return;
        trim(folder, limit);
    } catch (const std::bad_alloc&) { // it is baked again next time
    }
}

std::vector<std::byte> packedMap(const std::string& key, const BakedMap& map)
{
    std::vector<std::byte> out;
    out.reserve(packedSize(key, map));
    append(out, kMagic, sizeof kMagic);
    const Head head{
        std::uint32_t(key.size()), std::uint32_t(map.levels.size()), map.slices, {map.scale[0], map.scale[1], map.scale[2], map.scale[3]}};
    append(out, &head, 1);
    append(out, key.data(), key.size());
    for (const Image& level : map.levels) {
        const LevelHead levelHead{level.width, level.height, level.channels, int(level.type), level.storedBits, level.storedFloat};
        append(out, &levelHead, 1);
    }
    for (const Image& level : map.levels)
        append(out, level.data.data(), level.data.size());
    const std::uint64_t checksum = XXH3_64bits(out.data(), out.size());
    append(out, &checksum, 1);
    return out;
}

std::optional<BakedMap> unpackedMap(const std::string& key, const MapShape& shape, std::span<const std::byte> bytes)
{
    std::uint64_t checksum = 0;
    if (bytes.size() < sizeof checksum)
        return std::nullopt;
    std::memcpy(&checksum, bytes.last(sizeof checksum).data(), sizeof checksum);
    Reader reader{bytes.first(bytes.size() - sizeof checksum)};
    if (XXH3_64bits(reader.left.data(), reader.left.size()) != checksum)
        return std::nullopt;
    char magic[sizeof kMagic];
    Head head;
    if (!reader.take(magic, sizeof magic) || std::memcmp(magic, kMagic, sizeof magic) != 0 || !reader.take(&head, sizeof head))
        return std::nullopt;
    std::string echo(key.size(), '\0');
    if (head.keyBytes != key.size() || !reader.take(echo.data(), key.size()) || echo != key || head.slices != shape.slices
        || head.levels != shape.levels.size())
        return std::nullopt;
    BakedMap map;
    map.slices = shape.slices;
    map.scale = {head.scale[0], head.scale[1], head.scale[2], head.scale[3]};
    const std::size_t headBytes = shape.levels.size() * sizeof(LevelHead);
    if (headBytes > reader.left.size())
        return std::nullopt;
    Reader heads{reader.left.first(headBytes)}, data{reader.left.subspan(headBytes)};
    for (const MapShape::Level level : shape.levels)
        if (!readLevel(heads, data, shape, level, map.levels.emplace_back()))
            return std::nullopt;
    return data.left.empty() ? std::optional(std::move(map)) : std::nullopt;
}

} // namespace relievo
