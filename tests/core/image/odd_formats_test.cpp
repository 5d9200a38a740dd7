// Files that the image library reads wrongly or not at all: their values are right, or the words are.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/material.h"
#include "core/image/pixels.h"
#include "core/image/sets/texture_set.h"
#include "core/scene/source.h"
#include "tests/core/image/image_support.h"
#include "tests/core/image/odd_files.h"
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;

namespace {
constexpr int kSide = 16;

template <class T> std::string ramp(double factor, double first = 0)
{
    std::vector<T> values;
    for (int i = 0; i < kSide * kSide; ++i)
        values.push_back(T(first + factor * i));
    return bytesOfAll(values);
}

// Whether value(i) is close to wanted(i) for all texels.
void expectRamp(const Image& image, const std::function<float(int)>& wanted, float tolerance = 1e-6f)
{
    for (int i = 0; i < kSide * kSide; ++i)
        ASSERT_NEAR(image.value(i % kSide, i / kSide, 0), wanted(i), tolerance) << i;
}
} // namespace

TEST(OddTiff, WhiteAsTheSmallestNumberIsTurnedInAllDepths)
{
    const TemporaryFolder folder;
    const auto read = [&](int bits, int format, int photometric, const std::string& pixels) {
        writeAll(folder / "h.tif", tiff(kSide, kSide, bits, format, photometric, pixels));
        return readImage(folder / "h.tif");
    };
    for (const int white : {0, 1}) {
        const auto turned = [white](float value) { return white == 0 ? 1.f - value : value; };
        const auto bytes = read(8, 1, white, ramp<std::uint8_t>(1));
        ASSERT_TRUE(bytes) << message(bytes.error());
        expectRamp(bytes->image, [&](int i) { return turned(float(i) / 255.f); });
        const auto words = read(16, 1, white, ramp<std::uint16_t>(257));
        ASSERT_TRUE(words) << message(words.error());
        EXPECT_EQ(words->image.type, PixelType::U16);
        expectRamp(words->image, [&](int i) { return turned(float(i * 257) / 65535.f); });
        const auto longs = read(32, 1, white, ramp<std::uint32_t>(16843009));
        ASSERT_TRUE(longs) << message(longs.error());
        EXPECT_EQ(longs->image.storedMaximum, 4294967295.);
        expectRamp(longs->image, [&](int i) { return turned(float(i) / 255.f); });
        std::string triples;
        for (int i = 0; i < kSide * kSide; ++i)
            triples += std::string({char(i * 7 & 255), char(i * 91 & 255), char(i)}); // the highest byte last
        const auto threes = read(24, 1, white, triples);
        ASSERT_TRUE(threes) << message(threes.error());
        expectRamp(threes->image, [&](int i) { return turned(float(i * 65536 + (i * 91 & 255) * 256 + (i * 7 & 255)) / 16777215.f); });
        const auto floats = read(32, 3, white, ramp<float>(1. / 255));
        ASSERT_TRUE(floats) << message(floats.error());
        expectRamp(floats->image, [&](int i) { return turned(float(i) / 255.f); });
    }
}

TEST(OddTiff, SamplesThatAreNotReadFaithfullyAreRefused)
{
    const TemporaryFolder folder;
    for (const auto& [bits, format] : {std::pair(24, 3), std::pair(64, 1), std::pair(24, 2), std::pair(32, 6)}) {
        writeAll(folder / "h.tif", tiff(kSide, kSide, bits, format, 1, std::string(std::size_t(kSide * kSide * bits / 8), '\1')));
        const auto read = readImage(folder / "h.tif");
        ASSERT_FALSE(read) << bits << ' ' << format;
        EXPECT_EQ(message(read.error()).find("damaged"), std::string::npos) << message(read.error());
    }
    writeAll(folder / "h.tif", tiff(kSide, kSide, 64, 3, 1, ramp<double>(1. / 255)));
    const auto doubles = readImage(folder / "h.tif");
    ASSERT_TRUE(doubles) << message(doubles.error());
    expectRamp(doubles->image, [](int i) { return float(i) / 255.f; });
}

TEST(OddDds, UncompressedFormatsKeepTheirValues)
{
    const TemporaryFolder folder;
    const auto read = [&](const std::string& bytes) {
        writeAll(folder / "h.dds", bytes);
        return readImage(folder / "h.dds");
    };
    const std::string words = ramp<std::uint16_t>(257), floats = ramp<float>(0.5);
    for (const std::string& file : {dds(kSide, kSide, 56, words), oldDds(kSide, kSide, 0x20000, 0, 16, {0xffff}, words)}) {
        const auto image = read(file);
        ASSERT_TRUE(image) << message(image.error());
        EXPECT_EQ(image->image.type, PixelType::U16);
        expectRamp(image->image, [](int i) { return float(i * 257) / 65535.f; });
    }
    for (const std::string& file : {dds(kSide, kSide, 41, floats), oldDds(kSide, kSide, 0x4, 114, 0, {}, floats)}) {
        const auto image = read(file);
        ASSERT_TRUE(image) << message(image.error());
        expectRamp(image->image, [](int i) { return 0.5f * float(i); });
    }
    std::vector<std::uint16_t> halves(kSide * kSide, 0x3800); // 0.5
    for (const std::string& file : {dds(kSide, kSide, 54, bytesOfAll(halves)), oldDds(kSide, kSide, 0x4, 111, 0, {}, bytesOfAll(halves))}) {
        const auto image = read(file);
        ASSERT_TRUE(image) << message(image.error());
        EXPECT_EQ(image->image.storedBits, 16);
        expectRamp(image->image, [](int) { return 0.5f; });
    }
    const std::string tens = bytesOfAll(std::vector<std::uint32_t>(kSide * kSide, 1023u | 511u << 10 | 0u << 20 | 3u << 30));
    for (const std::string& file : {dds(kSide, kSide, 24, tens), oldDds(kSide, kSide, 0x40, 0, 32, {0x3ff, 0xffc00, 0x3ff00000}, tens)}) {
        const auto image = read(file);
        ASSERT_TRUE(image) << message(image.error());
        EXPECT_EQ(image->image.value(2, 2, 0), 1.f);
        EXPECT_NEAR(image->image.value(2, 2, 1), 511.f / 1023.f, 1e-4f);
        EXPECT_EQ(image->image.value(2, 2, 2), 0.f);
    }
    const auto shifts = read(oldDds(kSide, kSide, 0x80000, 0, 16, {0xff, 0xff00}, std::string(kSide * kSide * 2, '\x81'))); // -127
    ASSERT_TRUE(shifts) << message(shifts.error());
    EXPECT_FLOAT_EQ(shifts->image.value(2, 2, 1), -1.f);
    std::string blueFirst;
    for (int i = 0; i < kSide * kSide; ++i)
        blueFirst += std::string("\x10\x20\x30\x40");
    const auto color = read(dds(kSide, kSide, 91, blueFirst));
    ASSERT_TRUE(color) << message(color.error());
    EXPECT_FLOAT_EQ(color->image.value(3, 3, 0), 0x30 / 255.f);
    EXPECT_FLOAT_EQ(color->image.value(3, 3, 2), 0x10 / 255.f);
}

TEST(OddDds, CompressedDataIsReadUnderEveryNameOfItsFormat)
{
    const TemporaryFolder folder;
    const std::size_t blocks = kSide * kSide / 16;
    const auto repeated = [&](const std::string& block) {
        std::string all;
        for (std::size_t i = 0; i < blocks; ++i)
            all += block;
        return all;
    };
    const auto first = [&](std::uint32_t dxgi, const std::string& block) {
        writeAll(folder / "c.dds", dds(kSide, kSide, dxgi, repeated(block)));
        const auto read = readImage(folder / "c.dds");
        EXPECT_TRUE(read) << dxgi << ' ' << message(read.error());
        return read ? read->image : Image();
    };
    const std::string red("\x00\xf8\x00\xf8\0\0\0\0", 8); // one colour, red
    for (const std::uint32_t dxgi : {71u, 72u})
        EXPECT_FLOAT_EQ(first(dxgi, red).value(2, 2, 0), 1.f);
    for (const std::uint32_t dxgi : {74u, 75u, 77u, 78u})
        EXPECT_FLOAT_EQ(first(dxgi, std::string(8, '\xff') + red).value(2, 2, 0), 1.f);
    const std::string half("\x80\x80\0\0\0\0\0\0", 8), zero(8, '\0'); // both end points of a block alike
    EXPECT_NEAR(first(80, half).value(2, 2, 0), 0.5f, 0.005f);
    EXPECT_NEAR(first(81, zero).value(2, 2, 0), 0.5f, 0.005f); // signed zero
    EXPECT_NEAR(first(83, half + half).value(2, 2, 1), 0.5f, 0.005f);
    EXPECT_NEAR(first(84, zero + zero).value(2, 2, 1), 0.5f, 0.005f);
    const std::string mode5("\x20\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 16); // BC7: black
    for (const std::uint32_t dxgi : {98u, 99u})
        EXPECT_FLOAT_EQ(first(dxgi, mode5).value(2, 2, 0), 0.f);
}

TEST(OddDds, WhatIsNotReadIsNamed)
{
    const TemporaryFolder folder;
    for (const std::uint32_t dxgi : {0u, 26u, 107u, 4000u, 0xffffu}) {
        writeAll(folder / "c.dds", dds(kSide, kSide, dxgi, std::string(kSide * kSide * 4, '\0')));
        const auto read = readImage(folder / "c.dds");
        ASSERT_FALSE(read) << dxgi;
        EXPECT_NE(message(read.error()).find("kind of DDS"), std::string::npos) << message(read.error());
        EXPECT_EQ(message(read.error()).find("damaged"), std::string::npos) << message(read.error());
    }
}

TEST(LayeredExr, TheLayerThatIsNamedHeightIsTheHeight)
{
    const TemporaryFolder folder;
    const Image color = noiseImage(kSide, kSide, 3, PixelType::F32, 1), height = noiseImage(kSide, kSide, 1, PixelType::F32, 2);
    for (const std::string name : {"height", "Displacement", "render.disp", "depth", "Z"}) {
        ASSERT_TRUE(writeLayers(folder / "wall_height.exr", std::vector<ImageLayer>{{"beauty", color}, {"other", color}, {name, height}}));
        const auto set = openTextureSet(folder / "wall_height.exr");
        ASSERT_TRUE(set) << message(set.error());
        ASSERT_EQ(set->maps.size(), 1u);
        EXPECT_EQ(set->maps[0].file.string(), (folder / "wall_height.exr").string() + '#' + name);
        EXPECT_TRUE(tells(set->warnings, "parts"));
        const auto material = loadMaterial(set->slots(), set->images);
        ASSERT_TRUE(material && material->height);
        const bool isDepth = name == "depth" || name == "Z";
        EXPECT_NEAR(material->height->texel(5, 7), isDepth ? 1.f - height.value(5, 7, 0) : height.value(5, 7, 0), 1e-6f) << name;
        DecodedImages images;
        Warnings warnings;
        EXPECT_EQ(slotByHand(MapKind::Height, folder / "wall_height.exr", images, warnings).file, set->maps[0].file.string());
    }
}

TEST(LayeredExr, AnyLayerCanBeChosenAndTheOthersAreTold)
{
    const TemporaryFolder folder;
    const Image one = noiseImage(kSide, kSide, 3, PixelType::F32, 1), two = noiseImage(kSide, kSide, 3, PixelType::F32, 2);
    ASSERT_TRUE(writeLayers(folder / "x.exr", std::vector<ImageLayer>{{"one", one}, {"two", two}}));
    const auto info = readImageInfo(folder / "x.exr");
    ASSERT_TRUE(info);
    EXPECT_EQ(info->layers, (std::vector<std::string>{"plain", "two"}));
    const auto plain = readImage(folder / "x.exr"), chosen = readImage(folder / "x.exr#two");
    ASSERT_TRUE(plain && chosen);
    EXPECT_EQ(plain->image.data, one.data);
    EXPECT_TRUE(tells(plain->warnings, "parts"));
    EXPECT_EQ(chosen->image.data, two.data);
    EXPECT_TRUE(chosen->warnings.empty());
    const auto missing = readImage(folder / "x.exr#three");
    ASSERT_FALSE(missing);
    EXPECT_NE(message(missing.error()).find("two"), std::string::npos) << message(missing.error());
}
