// Heights that are more than grey: packed in bytes, of differing channels, elevation models with tags, signed displacement.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/height_codes.h"
#include "core/image/height_repair.h"
#include "core/image/material.h"
#include "core/image/pixels.h"
#include "core/scene/source.h"
#include "tests/core/image/image_support.h"
#include "tests/core/image/odd_files.h"
#include <array>
#include <gtest/gtest.h>
#include <random>

using namespace relievo;
using namespace relievo::test;
namespace fs = std::filesystem;

namespace {
constexpr int kFieldSize = 64;

// An RGB image of bytes(x, y).
Image colored(const std::function<std::array<int, 3>(int, int)>& bytes, int size = kFieldSize)
{
    return makeImage(size, size, 3, PixelType::U8, [&](int x, int y, int c) { return float(bytes(x, y)[std::size_t(c)]) / 255.f; });
}

// Hills in metres, as a code of 24 bits.
Image coded(double metresPerHill, double first, double unit)
{
    return colored([=](int x, int y) {
        const auto code = int((double(hill(x, y, kFieldSize)) * metresPerHill - first) / unit);
        return std::array{code >> 16, code >> 8 & 255, code & 255};
    });
}

struct Read {
    State state;
    HeightField heights;
    Warnings warnings;
};
// A lone file as SOURCE.
Read openAlone(const fs::path& file)
{
    const auto opened = openSource(file.string(), State());
    EXPECT_TRUE(opened) << message(opened.error());
    const auto material = loadMaterial(opened->state.slots, opened->images);
    EXPECT_TRUE(material && material->height);
    Warnings warnings = opened->warnings;
    warnings.insert(warnings.end(), material->warnings.begin(), material->warnings.end());
    return {opened->state, *material->height, warnings};
}

Read openImage(const TemporaryFolder& folder, const std::string& name, const Image& image)
{
    EXPECT_TRUE(writeImage(folder / name, image));
    return openAlone(folder / name);
}

std::string textOf(const Warnings& warnings, const std::string& code)
{
    const auto found = std::ranges::find(warnings, code, &Warning::code);
    return found == warnings.end() ? "" : found->text;
}

// Heights from lowest to highest as the hills have them.
void expectHills(const HeightField& heights, bool stretched, float tolerance)
{
    float low = 1, high = 0;
    for (int y = 0; y < kFieldSize; ++y)
        for (int x = 0; x < kFieldSize; ++x)
            low = std::min(low, hill(x, y, kFieldSize)), high = std::max(high, hill(x, y, kFieldSize));
    for (int y = 0; y < kFieldSize; ++y)
        for (int x = 0; x < kFieldSize; ++x) {
            const float h = hill(x, y, kFieldSize);
            ASSERT_NEAR(heights.texel(x, y), stretched ? (h - low) / (high - low) : h, tolerance) << x << ' ' << y;
        }
}
} // namespace

TEST(PackedHeights, CodesAreRecognisedAndDecoded)
{
    const TemporaryFolder folder;
    const Read terrarium = openImage(folder, "a.png", coded(900, -32768, 1. / 256));
    EXPECT_NE(textOf(terrarium.warnings, "packed-heights").find("Terrarium"), std::string::npos);
    expectHills(terrarium.heights, true, 1e-3f);
    const Read terrainRgb = openImage(folder, "b.png", coded(2500, -10000, 0.1));
    EXPECT_NE(textOf(terrainRgb.warnings, "packed-heights").find("Terrain-RGB"), std::string::npos);
    expectHills(terrainRgb.heights, true, 1e-3f);
    const Read bytes24 = openImage(folder, "c.png", coded(1, 0, 1. / 16777215));
    EXPECT_TRUE(tells(bytes24.warnings, "packed-heights"));
    expectHills(bytes24.heights, false, 1e-5f);
    for (const bool lowFirst : {false, true}) {
        const Read bytes16 = openImage(folder, "d.png", colored([=](int x, int y) {
            const int code = int(hill(x, y, kFieldSize) * 65535.f);
            return lowFirst ? std::array{code & 255, code >> 8, 0} : std::array{code >> 8, code & 255, 0};
        }));
        EXPECT_TRUE(tells(bytes16.warnings, "packed-heights"));
        expectHills(bytes16.heights, false, 1e-4f);
    }
}

// Also where the surface is rough, or so flat that a byte hardly changes.
TEST(PackedHeights, RoughAndFlatSurfacesAreRecognisedToo)
{
    std::mt19937 random(3);
    std::vector<double> noise(256 * 256);
    for (double& value : noise)
        value = double(random() % 2001) / 1000. - 1.;
    const auto terrarium = [](double metres) {
        const int code = int((metres + 32768) * 256);
        return std::array{code >> 16, code >> 8 & 255, code & 255};
    };
    const auto terrainRgb = [](double metres) {
        const int code = int((metres + 10000) * 10);
        return std::array{code >> 16, code >> 8 & 255, code & 255};
    };
    const auto words = [](double share) {
        const int code = int(share * 65535);
        return std::array{code >> 8, code & 255, 0};
    };
    const auto of = [&](const std::function<std::array<int, 3>(double)>& bytes, double size, double base, double rough) {
        return heightCodeOf(
            colored(
                [&](int x, int y) { return bytes(base + size * double(hill(x, y, 256)) + rough * noise[std::size_t(y * 256 + x)]); }, 256),
            Channel::Rgb);
    };
    EXPECT_EQ(of(terrarium, 2000, 500, 60), HeightCode::Terrarium);
    EXPECT_EQ(of(terrarium, 20, 30, 0), HeightCode::Terrarium);
    EXPECT_EQ(of(terrainRgb, 2000, 500, 5), HeightCode::TerrainRgb);
    EXPECT_EQ(of(terrainRgb, 60, 30, 0), HeightCode::TerrainRgb);
    EXPECT_EQ(of(words, 0.7, 0.1, 0.01), HeightCode::HighLow);
}

// A code is only what no colour can be.
TEST(PackedHeights, NoColourIsTakenForACode)
{
    const auto smooth = [](int x, int y) { return int(hill(x, y, kFieldSize) * 255.f); };
    const std::vector<Image> images = {
        noiseImage(kFieldSize, kFieldSize, 3, PixelType::U8), hillNormals(kFieldSize, false), // noise, normals
        makeImage(kFieldSize, kFieldSize, 3, PixelType::U8, [](int x, int y, int) { return float((x + y) % 5) / 5; }), // grey stripes
        colored([&](int x, int y) {
            return std::array{smooth(x, y), 255 - smooth(x, y), 0};
        }), // a ramp of colours
        colored([&](int x, int y) {
            return std::array{smooth(x, y), smooth(y, x), smooth(x + 9, y)};
        }), // unrelated channels
        colored([&](int x, int y) {
            return std::array{smooth(x, y), (x * 37 + y * 91) % 256, 0};
        }), // noise in green
        colored([&](int x, int y) {
            return std::array{smooth(x, y) / 64 * 64, x / 8 % 2 * 200, 17};
        }), // steps
        colored([&](int x, int y) {
            return std::array{smooth(x, y), smooth(x, y) * 9 / 10, smooth(x, y) * 7 / 10};
        }), // sepia
    };
    for (const Image& image : images)
        EXPECT_EQ(heightCodeOf(image, Channel::Rgb), HeightCode::None) << &image - images.data();
}

TEST(DifferingChannels, AreToldAndOneCanBeChosen)
{
    const TemporaryFolder folder;
    const Image photo = noiseImage(kFieldSize, kFieldSize, 3, PixelType::U8);
    const Read mean = openImage(folder, "photo.png", photo);
    EXPECT_NE(textOf(mean.warnings, "channels-differ").find("photo.png#r"), std::string::npos);
    for (const auto& [name, channel] : {std::pair("#r", 0), std::pair("#G", 1), std::pair("#b", 2)}) {
        DecodedImages images;
        Warnings warnings;
        MapSlots slots;
        slots[std::size_t(MapKind::Height)] = slotByHand(MapKind::Height, (folder / "photo.png").string() + name, images, warnings);
        const auto material = loadMaterial(slots);
        ASSERT_TRUE(material && material->height);
        EXPECT_FALSE(tells(material->warnings, "channels-differ"));
        EXPECT_FLOAT_EQ(material->height->texel(3, 5), photo.value(3, 5, channel));
    }
    // Grey but for what JPEG leaves is grey.
    const Image nearly = makeImage(kFieldSize, kFieldSize, 3, PixelType::U8,
        [](int x, int y, int c) { return hill(x, y, kFieldSize) + 0.008f * float((x + y + c) % 2); });
    EXPECT_FALSE(tells(openImage(folder, "nearly.png", nearly).warnings, "channels-differ"));
}

TEST(DifferingChannels, WhereOnlyOneVariesItIsRead)
{
    const TemporaryFolder folder;
    for (const PixelType type : {PixelType::U8, PixelType::U16, PixelType::F32})
        for (const int varying : {0, 1, 2}) {
            const float other = varying == 1 ? 1.f : 0.f;
            const Image image = makeImage(
                kFieldSize, kFieldSize, 3, type, [=](int x, int y, int c) { return c == varying ? hill(x, y, kFieldSize) : other; });
            const Read read = openImage(folder, type == PixelType::F32 ? "h.exr" : "h.png", image);
            EXPECT_FALSE(tells(read.warnings, "channels-differ"));
            expectHills(read.heights, false, 0.003f);
        }
}

namespace {
// Whole numbers of hills between two heights, with a gap at the first texel where `gap` is given.
template <class T> std::string hillNumbers(double low, double high, std::optional<double> gap = {})
{
    std::vector<T> values;
    for (int y = 0; y < kFieldSize; ++y)
        for (int x = 0; x < kFieldSize; ++x)
            values.push_back(T(low + (high - low) * double(hill(x, y, kFieldSize))));
    if (gap)
        values[0] = T(*gap);
    return bytesOfAll(values);
}

std::vector<TiffTag> geoTags(double metres, const std::string& gap, std::uint16_t model = 1)
{
    std::vector<TiffTag> tags = {doublesTag(33550, {metres, metres, 0}), doublesTag(33922, {0, 0, 0, 500000, 5000000, 0}),
        shortsTag(34735, {1, 1, 0, 2, 1024, 0, 1, model, 3076, 0, 1, 9001})};
    if (model == 2)
        tags[1] = doublesTag(33922, {0, 0, 0, 10, 60, 0});
    if (!gap.empty())
        tags.push_back({42113, 2, std::uint32_t(gap.size() + 1), gap + std::string(1, '\0')});
    return tags;
}
} // namespace

TEST(Elevation, TagsGiveRangeGapsAndDepth)
{
    const TemporaryFolder folder;
    const auto open = [&](int bits, int format, const std::string& pixels, const std::vector<TiffTag>& tags) {
        writeAll(folder / "dem.tif", tiff(kFieldSize, kFieldSize, bits, format, 1, pixels, tags));
        return openAlone(folder / "dem.tif");
    };
    const std::vector<Read> reads = {
        open(16, 1, hillNumbers<std::uint16_t>(300, 1000, 65535), geoTags(10, "65535")),
        open(16, 2, hillNumbers<std::int16_t>(300, 1000, -32768), geoTags(10, "-32768")),
        open(16, 2, hillNumbers<std::int16_t>(300, 1000, 9999), geoTags(10, "9999")), // no mark that is known without its tag
        open(32, 2, hillNumbers<std::int32_t>(300, 1000, -9999), geoTags(10, "-9999")),
        open(32, 3, hillNumbers<float>(300, 1000, -9999), geoTags(10, "-9999")),
        open(32, 3, hillNumbers<float>(300, 1000, 0), geoTags(10, "0")),
    };
    for (const Read& read : reads) {
        const std::size_t at = std::size_t(&read - reads.data());
        EXPECT_NE(textOf(read.warnings, "no-data").find("1 texel "), std::string::npos) << at;
        EXPECT_GT(read.heights.texel(0, 0), 0.2f) << at; // its neighbours' mean, not the mark
        expectHills(read.heights, true, 0.12f);
        const std::string survey = textOf(read.warnings, "survey");
        EXPECT_NE(survey.find("tile of 640 m"), std::string::npos) << at << survey;
        float low = 1, high = 0;
        for (int i = 1; i < kFieldSize * kFieldSize; ++i) {
            const float h = hill(i % kFieldSize, i / kFieldSize, kFieldSize);
            low = std::min(low, h), high = std::max(high, h);
        }
        EXPECT_NEAR(read.state.parameters.depth, 700.f * (high - low) / 640.f, 0.003f) << at;
        const std::string range = textOf(read.warnings, "height-range"), lowest = std::to_string(int(300 + 700 * low));
        EXPECT_NE(range.find(lowest), std::string::npos) << range << ' ' << lowest; // in the file's own numbers
    }
    const Read degrees = open(16, 1, hillNumbers<std::uint16_t>(300, 1000), geoTags(0.001, "", 2));
    const std::string survey = textOf(degrees.warnings, "survey"); // at 60 degrees a degree is half as wide
    EXPECT_NE(survey.find("tile of 356"), std::string::npos) << survey;
}

TEST(Elevation, WholeNumbersWithoutTagsStayAndNarrowOnesAreTold)
{
    const TemporaryFolder folder;
    writeAll(folder / "dem.tif", tiff(kFieldSize, kFieldSize, 16, 1, 1, hillNumbers<std::uint16_t>(391, 1069)));
    const Read narrow = openAlone(folder / "dem.tif");
    EXPECT_NE(textOf(narrow.warnings, "narrow-range").find("of 0 .. 65535"), std::string::npos);
    EXPECT_NEAR(narrow.heights.texel(0, 0), (391 + 678 * hill(0, 0, kFieldSize)) / 65535, 1e-4f);
    EXPECT_EQ(narrow.state.parameters.depth, Parameters().depth);
    EXPECT_FALSE(tells(openImage(folder, "wide.png", hillHeights(kFieldSize, PixelType::U16)).warnings, "narrow-range"));
    const Image flat = makeImage(kFieldSize, kFieldSize, 1, PixelType::U8, [](int, int, int) { return 0.5f; });
    EXPECT_FALSE(tells(openImage(folder, "flat.png", flat).warnings, "narrow-range"));
}

TEST(SignedHeights, ZeroBecomesTheMidlevel)
{
    const TemporaryFolder folder;
    const Image image = makeImage(
        kFieldSize, kFieldSize, 1, PixelType::F32, [](int x, int, int) { return -1.2f + 2.4f * float(x) / (kFieldSize - 1) - 0.3f; });
    const Read read = openImage(folder, "h.exr", image); // -1.5 to 0.9
    EXPECT_NEAR(read.state.parameters.midlevel, 0.625f, 1e-4f);
    EXPECT_TRUE(tells(read.warnings, "midlevel-set"));
    const Read deep = openImage(folder, "other_depth.exr", image);
    EXPECT_NEAR(deep.state.parameters.midlevel, 0.375f, 1e-4f);
    const Image positive = makeImage(kFieldSize, kFieldSize, 1, PixelType::F32, [](int x, int, int) { return float(x); });
    const Read plain = openImage(folder, "third.exr", positive);
    EXPECT_EQ(plain.state.parameters.midlevel, 1.f);
    EXPECT_FALSE(tells(plain.warnings, "midlevel-set"));
}
