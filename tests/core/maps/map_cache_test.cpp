// The cache of baked maps: what goes in comes out, anything else is baked again.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/acceleration/acceleration_map.h"
#include "core/maps/map_cache.h"
#include "core/maps/maps.h"
#include "tests/core/image/image_support.h"
#include "tests/core/maps/maps_support.h"
#include "tests/core/maps/refused_memory.h"
#include <cstdlib>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <limits>
#include <linux/fs.h>
#include <new>
#include <set>
#include <sys/ioctl.h>
#include <unistd.h>

using namespace relievo;
using namespace relievo::test;
namespace fs = std::filesystem;

namespace {

HeightField field(int seed = 0, int size = 24)
{
    return fieldOf(size, size, [&](int x, int y) { return float((x * 7 + y * 13 + seed) % 29) / 29.f; });
}

bool same(const BakedMap& a, const BakedMap& b)
{
    return a.slices == b.slices && a.scale == b.scale && std::ranges::equal(a.levels, b.levels, [](const Image& x, const Image& y) {
        return x.width == y.width && x.height == y.height && x.channels == y.channels && x.type == y.type && x.data == y.data;
    });
}

BakedMap pyramid()
{
    const BakedMapRow& row = *findBakedMap("pyramid");
    return storedMap(row, *bakeMap(row, field(), Parameters()), row.bits);
}

std::optional<BakedMap> onDisk(const TemporaryFolder& folder, const std::string& key)
{
    return mapOnDisk(folder.path(), key, shapeOf(*findBakedMap("pyramid"), field()));
}

// As its own file would be read.
std::optional<BakedMap> repacked(const BakedMap& map)
{
    return unpackedMap("k", shapeOf(*findBakedMap("pyramid"), field()), packedMap("k", map));
}

std::vector<fs::path> filesIn(const fs::path& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        files.push_back(entry.path());
    return files;
}

// A cache folder of its own for the time of a test.
struct OwnCache {
    TemporaryFolder folder;
    std::string before = std::getenv("RELIEVO_CACHE") ? std::getenv("RELIEVO_CACHE") : "";
    OwnCache()
    {
        ::setenv("RELIEVO_CACHE", (folder / "cache").c_str(), 1);
        forgetMapsInMemory();
    }
    ~OwnCache()
    {
        ::setenv("RELIEVO_CACHE", before.c_str(), 1);
        forgetMapsInMemory();
    }
    fs::path path() const { return folder / "cache"; }
};

} // namespace

TEST(MapCache, KeysTellApartWhateverTheMapDependsOn)
{
    const HeightField square = field();
    const auto texels = square.texels();
    Parameters deeper;
    deeper.depth = 0.2f;
    BakedMapRow newer = *findBakedMap("ao"), finer = newer;
    ++newer.version;
    finer.bits = 8;
    const std::string key = mapKey(*findBakedMap("ao"), field(), Parameters());
    const std::set<std::string> keys = {key, mapKey(*findBakedMap("ao"), field(1), Parameters()),
        mapKey(*findBakedMap("ao"), field(), deeper), mapKey(*findBakedMap("ao"), field().withWrap(Wrap::Clamp), Parameters()),
        mapKey(*findBakedMap("cone"), field(), Parameters()), mapKey(newer, field(), Parameters()), mapKey(finer, field(), Parameters()),
        mapKey(*findBakedMap("ao"), HeightField(12, 48, std::vector<float>(texels.begin(), texels.end())), Parameters())};
    EXPECT_EQ(keys.size(), 8u);
    EXPECT_EQ(mapKey(*findBakedMap("ao"), field(), Parameters()), key);
    EXPECT_EQ(mapKey(*findBakedMap("cone"), field(), deeper), mapKey(*findBakedMap("cone"), field(), Parameters()))
        << "cones do not depend on depth";
}

TEST(MapCache, FilesReadBackAndNothingElseDoes)
{
    const BakedMap map = pyramid();
    const MapShape shape = shapeOf(map);
    const std::vector<std::byte> packed = packedMap("a key", map);
    ASSERT_TRUE(unpackedMap("a key", shape, packed));
    EXPECT_TRUE(same(*unpackedMap("a key", shape, packed), map));
    EXPECT_FALSE(unpackedMap("b key", shape, packed));
    EXPECT_FALSE(unpackedMap("a longer key", shape, packed));
    std::mt19937 random(9);
    for (std::size_t size = 0; size < packed.size(); size += size < 300 ? 1 : 37)
        EXPECT_FALSE(unpackedMap("a key", shape, std::span(packed).first(size))) << size;
    for (int trial = 0; trial < 20000; ++trial) {
        std::vector<std::byte> spoilt = packed;
        for (unsigned flips = 1 + random() % 4; flips > 0; --flips)
            spoilt[random() % (trial % 2 ? 200 : spoilt.size())] ^= std::byte(1 << random() % 8);
        ASSERT_TRUE(spoilt == packed || !unpackedMap("a key", shape, spoilt)) << trial;
    }
    std::vector<std::byte> longer = packed;
    longer.push_back(std::byte(0));
    EXPECT_FALSE(unpackedMap("a key", shape, longer));
}

// A checksum that fits does not make a wrong head right.
TEST(MapCache, HeadsThatLieAreRefused)
{
    BakedMap map = pyramid();
    map.levels[0].width += 1;
    EXPECT_FALSE(repacked(map));
    map = pyramid();
    map.levels[0].height = 1 << 30;
    map.levels[0].width = 1 << 30;
    EXPECT_FALSE(repacked(map));
    map = pyramid();
    map.levels[1].channels = 0;
    EXPECT_FALSE(repacked(map));
    map = pyramid();
    map.slices = 0;
    EXPECT_FALSE(repacked(map));
    map = pyramid();
    map.levels[0].type = PixelType(7);
    EXPECT_FALSE(repacked(map));
    map = pyramid();
    map.levels.clear();
    EXPECT_FALSE(repacked(map));
}

// Another size that holds as many bytes, fewer levels, another kind of pixel: nothing of it is taken from the file.
TEST(MapCache, OtherShapesAreRefused)
{
    ASSERT_TRUE(repacked(pyramid()));
    BakedMap map = pyramid();
    std::swap(map.levels[0].width, map.levels[1].width);
    EXPECT_FALSE(repacked(map));
    map = pyramid();
    map.levels[0].width *= 2, map.levels[0].height /= 2;
    EXPECT_FALSE(repacked(map));
    map = pyramid();
    map.levels.pop_back();
    EXPECT_FALSE(repacked(map));
    map = pyramid();
    map.levels.push_back(map.levels.back());
    EXPECT_FALSE(repacked(map));
    map = pyramid();
    map.slices = 2;
    EXPECT_FALSE(repacked(map));
    map = pyramid();
    for (Image& level : map.levels) // one byte a channel and two channels: as many bytes
        level.type = PixelType::U8, level.channels = 2;
    EXPECT_FALSE(repacked(map));
}

TEST(MapCache, EveryBakeHasTheShapeAndTheScalesOfItsRow)
{
    for (const BakedMapRow& row : kBakedMaps)
        for (const auto& [width, height] : {std::pair(24, 24), {1, 1}, {5, 3}, {1, 37}, {130, 7}}) {
            if (!row.bake)
                continue;
            for (const float most : {1.f, 0.4f, 0.f}) {
                const HeightField heights = fieldOf(
                    width, height, [&](int x, int y) { return most * float((x * 7 + y * 13) % 29) / 28.f; }, Wrap::Clamp);
                const BakedMap map = storedMap(row, *bakeMap(row, heights, Parameters()), row.bits);
                EXPECT_EQ(shapeOf(map), shapeOf(row, heights)) << row.key << ' ' << width << 'x' << height;
                EXPECT_TRUE(hasSoundValues(row, heights, map)) << row.key << ' ' << width << 'x' << height << ' ' << most;
            }
        }
}

// With a checksum that fits: what no bake gives is baked again.
TEST(MapCache, ScalesOutOfRangeAreBakedAgain)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    for (const BakedMapRow& row : kBakedMaps) {
        if (!row.bake)
            continue;
        const OwnCache cache;
        const auto good = cachedMap(row, field(), Parameters());
        ASSERT_TRUE(good);
        const std::string key = mapKey(row, field(), Parameters());
        for (int c = 0; c < row.channels; ++c)
            for (const float scale : {nan, infinite, -1.f, -infinite}) {
                BakedMap spoilt = **good;
                spoilt.scale[c] = scale;
                keepOnDisk(cache.path(), key, spoilt);
                forgetMapsInMemory();
                const auto again = cachedMap(row, field(), Parameters());
                ASSERT_TRUE(again);
                EXPECT_TRUE(same(**good, **again)) << row.key << ' ' << c << ' ' << scale;
            }
    }
}

TEST(MapCache, BoundsBelowTheHeightsAreBakedAgain)
{
    const OwnCache cache;
    const BakedMapRow& cones = *findBakedMap("cell-cone");
    const auto good = *cachedMap(cones, field(), Parameters());
    for (const glm::vec4 less : {glm::vec4(0.f, 0.f, 0.f, 0.1f), {0.f, 0.1f, 0.f, 0.f}, {-0.1f, 0.f, 0.f, 0.f}}) {
        BakedMap spoilt = *good;
        spoilt.scale -= less;
        keepOnDisk(cache.path(), mapKey(cones, field(), Parameters()), spoilt);
        forgetMapsInMemory();
        EXPECT_TRUE(same(*good, **cachedMap(cones, field(), Parameters())));
    }
    const BakedMapRow& maxima = *findBakedMap("pyramid");
    BakedMap low = **cachedMap(maxima, field(), Parameters());
    const BakedMap whole = low;
    std::ranges::fill(low.levels.back().data, std::byte(0));
    keepOnDisk(cache.path(), mapKey(maxima, field(), Parameters()), low);
    forgetMapsInMemory();
    EXPECT_TRUE(same(whole, **cachedMap(maxima, field(), Parameters())));
}

TEST(MapCache, AMapIsBakedOnceAndReadAfterwards)
{
    const OwnCache cache;
    const BakedMapRow& row = *findBakedMap("pyramid");
    const auto first = cachedMap(row, field(), Parameters());
    ASSERT_TRUE(first);
    EXPECT_EQ(*first, *cachedMap(row, field(), Parameters())) << "from memory";
    ASSERT_EQ(filesIn(cache.path()).size(), 1u);
    forgetMapsInMemory();
    bool baked = false;
    const auto read = cachedMap(row, field(), Parameters(), {[&](float) { baked = true; }, {}});
    EXPECT_FALSE(baked) << "from disk";
    EXPECT_TRUE(same(**first, **read));
}

TEST(MapCache, ASpoiltFileIsBakedAgainAndReplaced)
{
    const OwnCache cache;
    const BakedMapRow& row = *findBakedMap("pyramid");
    const auto first = cachedMap(row, field(), Parameters());
    const fs::path file = filesIn(cache.path()).front();
    const std::string whole = readAll(file);
    for (const std::string& content : {std::string(), whole.substr(0, whole.size() / 2), whole + "x", std::string(whole.size(), 'x')}) {
        writeAll(file, content);
        forgetMapsInMemory();
        const auto again = cachedMap(row, field(), Parameters());
        ASSERT_TRUE(again);
        EXPECT_TRUE(same(**first, **again));
        EXPECT_EQ(readAll(file), whole);
    }
}

TEST(MapCache, WithoutAUsableFolderNothingIsKept)
{
    TemporaryFolder folder;
    writeAll(folder / "file", "no folder");
    OwnCache cache;
    for (const std::string& value :
        {std::string("off"), (folder / "file").string(), (folder / "file" / "below").string(), std::string("/proc/none")}) {
        ::setenv("RELIEVO_CACHE", value.c_str(), 1);
        forgetMapsInMemory();
        EXPECT_TRUE(cachedMap(*findBakedMap("pyramid"), field(), Parameters())) << value;
    }
    EXPECT_EQ(filesIn(folder.path()).size(), 1u);
    ::setenv("RELIEVO_CACHE", "off", 1);
    EXPECT_FALSE(cacheFolder());
}

TEST(MapCache, TheOldestFilesMakeRoom)
{
    TemporaryFolder folder;
    const BakedMap map = pyramid();
    const std::uintmax_t size = packedMap("0", map).size();
    for (int i = 0; i < 6; ++i) {
        const std::string key = std::to_string(i);
        keepOnDisk(folder.path(), key, map, size * 3);
        for (const fs::path& file : filesIn(folder.path())) // the clock of files is coarse
            fs::last_write_time(file, fs::last_write_time(file) - std::chrono::seconds(1));
        EXPECT_TRUE(onDisk(folder, "0")) << "used each time";
    }
    EXPECT_EQ(filesIn(folder.path()).size(), 3u);
    EXPECT_TRUE(onDisk(folder, "5"));
    EXPECT_FALSE(onDisk(folder, "2"));
    keepOnDisk(folder.path(), "large", map, size / 2);
    EXPECT_FALSE(onDisk(folder, "large")) << "larger than all room";
}

TEST(MapCache, OnlyFilesOfTheCacheMakeRoom)
{
    TemporaryFolder folder;
    const BakedMap map = pyramid();
    const std::uintmax_t size = packedMap("0", map).size();
    const std::string digits(32, 'a');
    for (const std::string& name : {std::string("world.map"), std::string("site.mapping"), digits + ".map.old", digits + "b.map",
             digits + ".mapfile", digits + ".map.Xy09Zz", std::string(".relievorc"), std::string(32, 'A') + ".map", digits})
        writeAll(folder / name, std::string(size, 'x'));
    const auto foreign = filesIn(folder.path());
    for (const std::string& name : {std::string(".relievo-Xy09Zz"), std::string(32, '0') + ".map"}) // left by a crash, and an older map
        writeAll(folder / name, std::string(size, 'x'));
    for (const fs::path& file : filesIn(folder.path()))
        fs::last_write_time(file, fs::last_write_time(file) - std::chrono::hours(1));
    keepOnDisk(folder.path(), "0", map, size);
    EXPECT_TRUE(onDisk(folder, "0")) << "files of others do not count";
    EXPECT_EQ(filesIn(folder.path()).size(), foreign.size() + 1);
    for (const fs::path& file : foreign)
        EXPECT_TRUE(fs::exists(file)) << file;
}

namespace {
// Keeps a file from being removed while it lives, also by root; `works` is false where the file system or the user may not.
struct Unremovable {
    int file;
    int before = 0;
    bool works = false;
    explicit Unremovable(const fs::path& path) : file(::open(path.c_str(), O_RDONLY | O_CLOEXEC))
    {
        int flags = 0;
        works = file >= 0 && ::ioctl(file, FS_IOC_GETFLAGS, &before) == 0
            && (flags = before | FS_IMMUTABLE_FL, ::ioctl(file, FS_IOC_SETFLAGS, &flags) == 0);
    }
    Unremovable(const Unremovable&) = delete;
    Unremovable& operator=(const Unremovable&) = delete;
    ~Unremovable()
    {
        if (works)
            ::ioctl(file, FS_IOC_SETFLAGS, &before);
        if (file >= 0)
            ::close(file);
    }
};
} // namespace

TEST(MapCache, AFileThatCannotBeRemovedStillCounts)
{
    TemporaryFolder folder;
    const BakedMap map = pyramid();
    const std::uintmax_t size = packedMap("0", map).size();
    keepOnDisk(folder.path(), "0", map);
    const fs::path oldest = filesIn(folder.path()).front();
    fs::last_write_time(oldest, fs::last_write_time(oldest) - std::chrono::hours(1));
    {
        const Unremovable kept(oldest);
        if (!kept.works)
            GTEST_SKIP() << "files cannot be made unremovable here";
        keepOnDisk(folder.path(), "1", map);
        for (const fs::path& file : filesIn(folder.path()))
            if (file != oldest)
                fs::last_write_time(file, fs::last_write_time(file) - std::chrono::minutes(1));
        keepOnDisk(folder.path(), "2", map, 2 * size);
        EXPECT_TRUE(fs::exists(oldest));
        EXPECT_EQ(filesIn(folder.path()).size(), 2u) << "the next oldest makes room instead";
        EXPECT_TRUE(onDisk(folder, "2"));
    }
    keepOnDisk(folder.path(), "3", map, size);
    EXPECT_EQ(filesIn(folder.path()).size(), 1u);
}

TEST(MapCache, AMapWhoseFileExceedsTheRoomIsNotWritten)
{
    TemporaryFolder folder;
    const BakedMap map = pyramid();
    const std::uintmax_t size = packedMap("0", map).size();
    ASSERT_GT(size - 1, map.bytes());
    keepOnDisk(folder.path(), "0", map, size);
    keepOnDisk(folder.path(), "1", map, size - 1);
    EXPECT_TRUE(onDisk(folder, "0")) << "exactly fits, and made no room for what does not";
    EXPECT_FALSE(onDisk(folder, "1"));
}

TEST(AccelerationMap, AVolumeIsBakedOnceForAllHeightLevels)
{
    const OwnCache cache;
    const HeightField finest = heightLevels(field()).front();
    const auto one = makeAccelerationMap("distance", finest, Parameters(), false),
               all = makeAccelerationMap("distance", finest, Parameters(), true);
    ASSERT_TRUE(one && all);
    EXPECT_EQ(filesIn(cache.path()).size(), 1u);
    ASSERT_EQ((*all)->levels.size(), 1u);
    EXPECT_TRUE((*all)->levels[0].data == (*one)->levels[0].data);
    EXPECT_EQ((*all)->scales, std::vector(std::size_t(levelCount(finest)), (*one)->scales.front())) << "shaders look up any level's";
}

// The sanitizers bring their own operator new.
#ifndef __SANITIZE_ADDRESS__
[[gnu::noinline]] void* operator new(std::size_t size)
{
    void* block = size >= refusedFrom && size < refusedTo ? nullptr : std::malloc(std::max<std::size_t>(size, 1));
    if (!block)
        throw std::bad_alloc();
    return block;
}
[[gnu::noinline]] void operator delete(void* block) noexcept
{
    std::free(block);
}
[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept
{
    std::free(block);
}

TEST(MapCache, WithoutMemoryToKeepOrReadAMapItIsBakedAllTheSame)
{
    const OwnCache cache;
    const BakedMapRow& row = *findBakedMap("curvature");
    constexpr std::size_t kStored = 256 * 256 * 2; // bytes; a file has some more, the floats have twice as many
    const auto bake = [&](const Progress& progress = {}) {
        forgetMapsInMemory();
        return cachedMap(row, field(0, 256), Parameters(), progress);
    };
    {
        const RefusedMemory refused(kStored + 1, kStored + 1000);
        ASSERT_TRUE(bake());
        EXPECT_TRUE(filesIn(cache.path()).empty());
    }
    const auto kept = bake();
    ASSERT_EQ(filesIn(cache.path()).size(), 1u);
    int reports = 0;
    {
        const RefusedMemory refused(kStored + 1, kStored + 1000);
        const auto again = bake({[&](float) { ++reports; }, {}});
        ASSERT_TRUE(again);
        EXPECT_TRUE(same(**kept, **again));
    }
    EXPECT_GT(reports, 0);
    EXPECT_EQ(filesIn(cache.path()).size(), 1u);
}

TEST(MapCache, OutOfMemoryIsAnErrorWhereverItStrikes)
{
    const OwnCache cache;
    const HeightField heights = field(0, 256);
    constexpr std::size_t kStored = 256 * 256 * 2;
    {
        const RefusedMemory refused(kStored, kStored + 1);
        const auto map = cachedMap(*findBakedMap("curvature"), heights, Parameters());
        ASSERT_FALSE(map);
        EXPECT_NE(map.error().what.find("not enough memory"), std::string::npos);
    }
    const RefusedMemory refused(128 * 128 * 4, 128 * 128 * 4 + 1); // the level of half the size
    const auto texture = makeAccelerationMap("pyramid", heights, Parameters(), true);
    ASSERT_FALSE(texture);
    EXPECT_NE(texture.error().what.find("not enough memory"), std::string::npos);
}
#endif

TEST(MapCache, MemoryHoldsTheMapsUsedLast)
{
    forgetMapsInMemory();
    const auto map = std::make_shared<const BakedMap>(pyramid());
    for (int i = 0; i < int(kMemoryMaps) + 4; ++i) {
        keepInMemory(std::to_string(i), map);
        EXPECT_TRUE(mapInMemory("0"));
    }
    EXPECT_FALSE(mapInMemory("1"));
    EXPECT_TRUE(mapInMemory(std::to_string(kMemoryMaps + 3)));
    auto larger = *map;
    larger.levels.insert(larger.levels.end(), 3, larger.levels[0]);
    keepInMemory("huge", std::make_shared<const BakedMap>(std::move(larger)), 2 * map->bytes());
    EXPECT_FALSE(mapInMemory("huge"));
    EXPECT_TRUE(mapInMemory("0")) << "a map that does not fit drives none out";
    forgetMapsInMemory();
    EXPECT_FALSE(mapInMemory("0"));
}
