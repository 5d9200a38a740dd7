// Loading materials: heights made sound, conventions applied, missing files told and the rest kept.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/height_repair.h"
#include "core/image/material.h"
#include "tests/core/image/image_support.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace relievo;
using namespace relievo::test;
namespace fs = std::filesystem;

namespace {
constexpr int kTexels = 32;

MapSlot& slot(MapSlots& slots, MapKind kind)
{
    return slots[std::size_t(kind)];
}

// One image as one map.
Expected<Material> loadOne(const TemporaryFolder& folder, const std::string& name, const Image& image, MapKind kind, MapSlot base = {})
{
    if (const auto written = writeImage(folder / name, image); !written)
        return tl::unexpected(written.error());
    MapSlots slots;
    base.file = (folder / name).string();
    slot(slots, kind) = base;
    return loadMaterial(slots);
}
} // namespace

TEST(Material, HeightsKeepSixteenBits)
{
    const TemporaryFolder folder;
    const Image image = noiseImage(kTexels, kTexels, 1, PixelType::U16);
    const auto material = loadOne(folder, "h.png", image, MapKind::Height);
    ASSERT_TRUE(material) << message(material.error());
    ASSERT_TRUE(material->height);
    EXPECT_EQ(material->height->storedBits(), 16);
    for (int i = 0; i < kTexels * kTexels; ++i)
        ASSERT_EQ(material->height->texels()[std::size_t(i)], image.value(i % kTexels, i / kTexels, 0));
    EXPECT_TRUE(material->warnings.empty());
}

TEST(Material, AnOpticsMapNeedsThreeChannels)
{
    const TemporaryFolder folder;
    const auto one = loadOne(folder, "one.png", noiseImage(kTexels, kTexels, 1, PixelType::U8), MapKind::Optics);
    const std::string told = one ? (one->warnings.empty() ? "" : one->warnings.front().text) : message(one.error());
    EXPECT_NE(told.find("one.png"), std::string::npos) << told;
    EXPECT_NE(told.find("one channel"), std::string::npos) << told;
    const auto three = loadOne(folder, "three.png", noiseImage(kTexels, kTexels, 3, PixelType::U8), MapKind::Optics);
    ASSERT_TRUE(three);
    ASSERT_TRUE(three->map(MapKind::Optics));
    EXPECT_EQ(three->map(MapKind::Optics)->channels, 3);
}

TEST(Material, InvertMakesHeightOfDepth)
{
    const TemporaryFolder folder;
    const Image image = noiseImage(kTexels, kTexels, 1, PixelType::U8);
    const auto material = loadOne(folder, "h.png", image, MapKind::Height, {"", Channel::Rgb, true});
    ASSERT_TRUE(material);
    EXPECT_EQ(material->height->storedBits(), 8);
    EXPECT_EQ(material->height->texel(3, 4), 1 - image.value(3, 4, 0));
}

TEST(Material, GreyIsRedAndColourIsTheMean)
{
    const TemporaryFolder folder;
    const Image color = noiseImage(kTexels, kTexels, 3, PixelType::U8);
    const auto mean = loadOne(folder, "c.png", color, MapKind::Height);
    const float sum = color.value(5, 6, 0) + color.value(5, 6, 1) + color.value(5, 6, 2);
    EXPECT_EQ(mean->height->texel(5, 6), std::round(sum / 3 * 65535) / 65535); // as the GPU's 16 bits hold it
    const auto green = loadOne(folder, "c.png", color, MapKind::Height, {"", Channel::G, false});
    EXPECT_EQ(green->height->texel(5, 6), color.value(5, 6, 1));
    const Image one = noiseImage(kTexels, kTexels, 1, PixelType::U8);
    const Image grey = makeImage(kTexels, kTexels, 3, PixelType::U8, [&](int x, int y, int) { return one.value(x, y, 0); });
    const auto red = loadOne(folder, "g.png", grey, MapKind::Height);
    EXPECT_EQ(red->height->texel(5, 6), one.value(5, 6, 0)); // exactly
}

TEST(Material, FloatHeightsAreMappedOnlyWhenTheyLeaveTheRange)
{
    const TemporaryFolder folder;
    const auto wide = loadOne(
        folder, "w.exr", makeImage(kTexels, 1, 1, PixelType::F32, [](int x, int, int) { return float(x) * 10 - 50; }), MapKind::Height);
    ASSERT_TRUE(wide);
    EXPECT_TRUE(tells(wide->warnings, "height-range"));
    EXPECT_EQ(wide->height->texel(0, 0), 0.f);
    EXPECT_EQ(wide->height->texel(kTexels - 1, 0), 1.f);
    EXPECT_EQ(wide->height->storedBits(), 32);
    const auto inside = loadOne(
        folder, "i.exr", makeImage(kTexels, 1, 1, PixelType::F32, [](int x, int, int) { return 0.25f + float(x) / 100; }), MapKind::Height);
    ASSERT_TRUE(inside);
    EXPECT_TRUE(inside->warnings.empty());
    EXPECT_EQ(inside->height->texel(0, 0), 0.25f);
    const auto constant = loadOne(folder, "k.exr", makeImage(4, 4, 1, PixelType::F32, [](int, int, int) { return 7.f; }), MapKind::Height);
    EXPECT_TRUE(constant && std::isfinite(constant->height->texel(0, 0)));
}

TEST(Material, NanAndInfinityAreRepairedAndCounted)
{
    const TemporaryFolder folder;
    const Image image = makeImage(kTexels, kTexels, 1, PixelType::F32, [](int x, int y, int) {
        return x == 3 && y == 3 ? std::numeric_limits<float>::quiet_NaN()
            : x == 9 && y == 0  ? std::numeric_limits<float>::infinity()
            : x < 16            ? 0.25f
                                : 0.75f;
    });
    const auto material = loadOne(folder, "n.exr", image, MapKind::Height);
    ASSERT_TRUE(material);
    ASSERT_TRUE(tells(material->warnings, "nan-repaired"));
    EXPECT_NE(material->warnings[0].text.find("2 texels"), std::string::npos) << material->warnings[0].text;
    EXPECT_EQ(material->height->texel(3, 3), 0.25f);
    EXPECT_EQ(material->height->texel(9, 0), 0.25f);
    const Image nothing = makeImage(4, 4, 1, PixelType::F32, [](int, int, int) { return std::numeric_limits<float>::quiet_NaN(); });
    EXPECT_EQ(loadOne(folder, "all.exr", nothing, MapKind::Height)->height->texel(1, 1), 0.f);
}

TEST(Material, GreenFlipConvertsDirectX)
{
    const TemporaryFolder folder;
    const Image normals = hillNormals(kTexels, true);
    const auto material = loadOne(folder, "n.png", normals, MapKind::Normal, {"", Channel::Rgb, true});
    ASSERT_TRUE(material);
    const Image* map = material->map(MapKind::Normal);
    ASSERT_TRUE(map);
    EXPECT_EQ(map->value(4, 5, 0), normals.value(4, 5, 0));
    EXPECT_FLOAT_EQ(map->value(4, 5, 1), 1 - normals.value(4, 5, 1));
    EXPECT_EQ(map->value(4, 5, 2), normals.value(4, 5, 2));
}

TEST(Material, TwoChannelNormalsGetTheirZ)
{
    const TemporaryFolder folder;
    for (const int channels : {2, 3}) { // a grey with alpha, and a blue that is 0 everywhere
        const Image xy = makeImage(kTexels, kTexels, channels, PixelType::U16,
            [](int x, int y, int c) { return c == 2 ? 0.f : hillNormal(x, y, c, kTexels, false); });
        const auto material = loadOne(folder, "n.png", xy, MapKind::Normal);
        ASSERT_TRUE(material) << message(material.error());
        const Image* map = material->map(MapKind::Normal);
        ASSERT_EQ(map->channels, 3);
        for (int i = 0; i < kTexels; ++i)
            EXPECT_NEAR(map->value(i, 7, 2), hillNormal(i, 7, 2, kTexels, false), 1e-3);
    }
}

TEST(Material, DualReliefTextureGivesFrontDepthAndRebuiltNormal)
{
    const TemporaryFolder folder;
    const Image dual = makeImage(64, 64, 4, PixelType::U8, [](int x, int y, int c) {
        const float depth = 1 - hill(x, y, 64);
        return c == 3 ? depth : c == 2 ? std::min(1.f, depth + 0.2f) : hillNormal(x, y, c, 64, false);
    });
    ASSERT_TRUE(writeImage(folder / "statue_dual.png", dual));
    const auto set = openTextureSet(folder.path());
    ASSERT_TRUE(set);
    const auto material = loadMaterial(set->slots(), set->images);
    ASSERT_TRUE(material);
    for (int i = 0; i < 64; ++i) {
        EXPECT_NEAR(material->height->texel(i, 9), hill(i, 9, 64), 0.003);
        EXPECT_NEAR(material->map(MapKind::Normal)->value(i, 9, 2), hillNormal(i, 9, 2, 64, false), 0.02);
    }
}

TEST(Material, ScalarMapsAreOneChannelAndInvertible)
{
    const TemporaryFolder folder;
    const Image packed = noiseImage(kTexels, kTexels, 3, PixelType::U8);
    const auto material = loadOne(folder, "arm.png", packed, MapKind::Roughness, {"", Channel::G, true});
    ASSERT_TRUE(material);
    ASSERT_EQ(material->map(MapKind::Roughness)->channels, 1);
    EXPECT_FLOAT_EQ(material->map(MapKind::Roughness)->value(2, 3, 0), 1 - packed.value(2, 3, 1));
}

// Nothing stands for an alpha that is not there.
TEST(Material, ASlotThatReadsAlphaOfAnOpaquePictureIsLeftOut)
{
    const TemporaryFolder folder;
    for (const int channels : {1, 3}) {
        const Image opaque = noiseImage(kTexels, kTexels, channels, PixelType::U8);
        ASSERT_TRUE(writeImage(folder / "c.png", opaque));
        for (const MapKind kind : {MapKind::Opacity, MapKind::Height, MapKind::Gloss}) {
            MapSlots slots;
            slot(slots, MapKind::Color).file = (folder / "c.png").string();
            slot(slots, kind) = {(folder / "c.png").string(), Channel::A, false};
            const auto material = loadMaterial(slots);
            ASSERT_TRUE(material);
            EXPECT_FALSE(material->height);
            EXPECT_EQ(material->map(kind), nullptr);
            EXPECT_NE(material->map(MapKind::Color), nullptr);
            EXPECT_TRUE(tells(material->warnings, "channel-missing"));
            const TextureSet set = textureSetOf("c", slots, folder.path());
            EXPECT_EQ(set.maps.size(), 1u);
            EXPECT_TRUE(tells(set.warnings, "channel-missing"));
        }
        EXPECT_FALSE(loadOne(folder, "c.png", opaque, MapKind::Opacity, {"", Channel::A, false})); // nothing is left
    }
    const auto grey = loadOne(folder, "g.png", noiseImage(kTexels, kTexels, 2, PixelType::U8), MapKind::Opacity, {"", Channel::A, false});
    EXPECT_TRUE(grey && grey->map(MapKind::Opacity));
}

TEST(Material, ColoursAreThreeChannels)
{
    const TemporaryFolder folder;
    const Image rgba = noiseImage(kTexels, kTexels, 4, PixelType::U8), grey = noiseImage(kTexels, kTexels, 1, PixelType::U8);
    const auto four = loadOne(folder, "c.png", rgba, MapKind::Color);
    ASSERT_EQ(four->map(MapKind::Color)->channels, 3);
    EXPECT_EQ(four->map(MapKind::Color)->value(2, 3, 2), rgba.value(2, 3, 2));
    const auto one = loadOne(folder, "g.png", grey, MapKind::Color);
    ASSERT_EQ(one->map(MapKind::Color)->channels, 3);
    EXPECT_EQ(one->map(MapKind::Color)->value(2, 3, 2), grey.value(2, 3, 0));
}

TEST(Material, MissingAndBrokenMapsAreToldTheRestIsKept)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "h.png", hillHeights(kTexels, PixelType::U8)));
    writeAll(folder / "r.png", "no picture");
    MapSlots slots;
    slot(slots, MapKind::Height).file = (folder / "h.png").string();
    slot(slots, MapKind::Color).file = (folder / "moved.png").string();
    slot(slots, MapKind::Roughness).file = (folder / "r.png").string();
    const auto material = loadMaterial(slots);
    ASSERT_TRUE(material);
    EXPECT_TRUE(material->height);
    EXPECT_EQ(material->map(MapKind::Color), nullptr);
    EXPECT_TRUE(tells(material->warnings, "map-missing"));
    EXPECT_TRUE(tells(material->warnings, "map-broken"));
    EXPECT_NE(material->warnings[0].text.find((folder / "moved.png").string()), std::string::npos);
    slot(slots, MapKind::Height).file = (folder / "gone.png").string();
    EXPECT_FALSE(loadMaterial(slots));
    EXPECT_TRUE(loadMaterial(MapSlots())); // nothing wanted, nothing missing
}

TEST(Material, WhatDidNotChangeIsTakenOverWithItsWarnings)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "h.exr", makeImage(kTexels, 1, 1, PixelType::F32, [](int x, int, int) { return float(x); })));
    ASSERT_TRUE(writeImage(folder / "c.png", noiseImage(kTexels, kTexels, 3, PixelType::U8)));
    MapSlots slots;
    slot(slots, MapKind::Height).file = (folder / "h.exr").string();
    slot(slots, MapKind::Color).file = (folder / "c.png").string();
    const auto first = loadMaterial(slots);
    ASSERT_TRUE(first);
    fs::remove(folder / "h.exr");
    slot(slots, MapKind::Color).invert = true;
    const auto second = loadMaterial(slots, {}, &*first);
    ASSERT_TRUE(second);
    ASSERT_TRUE(second->height);
    EXPECT_EQ(second->height->texels().data(), first->height->texels().data());
    EXPECT_EQ(second->warnings, first->warnings);
    EXPECT_NE(second->map(MapKind::Color), first->map(MapKind::Color));
}

TEST(Material, DecodedImagesAreNotReadAgain)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "rock_color.png", noiseImage(kTexels, kTexels, 3, PixelType::U8)));
    ASSERT_TRUE(writeImage(folder / "rock_height.png", hillHeights(kTexels, PixelType::U8)));
    const auto set = openTextureSet(folder.path());
    ASSERT_TRUE(set);
    fs::remove(folder / "rock_color.png");
    fs::remove(folder / "rock_height.png");
    const auto material = loadMaterial(set->slots(), set->images);
    ASSERT_TRUE(material);
    EXPECT_TRUE(material->height);
    EXPECT_EQ(material->map(MapKind::Color), &set->images.at(folder / "rock_color.png")->image); // not even copied
}

TEST(Material, Samples)
{
    MapSlots slots;
    slot(slots, MapKind::Height).file = "sample:bricks@16";
    const auto material = loadMaterial(slots);
    ASSERT_TRUE(material) << message(material.error());
    EXPECT_EQ(material->height->width(), 16);
    for (const char* wrong : {"sample:nothing", "sample:bricks@0", "sample:bricks@x", "sample:bricks@999999999"}) {
        slot(slots, MapKind::Height).file = wrong;
        const auto refused = loadMaterial(slots);
        ASSERT_FALSE(refused) << wrong;
        EXPECT_EQ(refused.error().where, wrong);
    }
}

TEST(Material, CancelledAndOneChannelNormals)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "h.png", hillHeights(kTexels, PixelType::U8)));
    MapSlots slots;
    slot(slots, MapKind::Normal).file = (folder / "h.png").string();
    const auto normal = loadMaterial(slots);
    ASSERT_FALSE(normal);
    EXPECT_NE(normal.error().what.find("normal map"), std::string::npos);
    std::stop_source source;
    source.request_stop();
    const auto cancelled = loadMaterial(slots, {}, nullptr, Progress{{}, source.get_token()});
    ASSERT_FALSE(cancelled);
    EXPECT_TRUE(isCancelled(cancelled.error()));
}

TEST(Material, RepairUsesNeighboursOfTheSameChannel)
{
    std::vector<float> values = {1, 10, std::numeric_limits<float>::quiet_NaN(), 20, 3, 30};
    EXPECT_EQ(repairNonFinite(values, 3, 1, 2), 1u);
    EXPECT_EQ(values[2], 2.f);
}

// What loads as heights is rescaled: a gap must not come out as an extreme of the map.
TEST(Material, LargeGapsAreFilledFromTheirRim)
{
    const auto depths = [](int size, int gap) {
        return makeImage(size, size, 1, PixelType::F32, [=](int x, int y, int) {
            const int from = (size - gap) / 2, to = from + gap;
            return x >= from && x < to && y >= from && y < to ? NAN : -20.f + 10.f * float(x) / float(size - 1);
        });
    };
    const std::vector<float> small = soundScalars(depths(9, 5), Channel::R, false), large = soundScalars(depths(61, 55), Channel::R, false);
    EXPECT_EQ(small.front(), 0.f);
    EXPECT_EQ(small.back() - small.front(), 1.f);
    for (int y = 0; y < 9; ++y)
        for (int x = 1; x < 9; ++x)
            EXPECT_GE(small[std::size_t(y * 9 + x)], small[std::size_t(y * 9 + x - 1)]) << "it rises as around it: " << x << ',' << y;
    EXPECT_NEAR(small[4 * 9 + 4], 0.5f, 1e-5f);
    for (int y = 1; y < 60; ++y)
        for (int x = 1; x < 60; ++x)
            ASSERT_TRUE(large[std::size_t(y * 61 + x)] > 0.f && large[std::size_t(y * 61 + x)] < 1.f) << x << ',' << y;
    EXPECT_NEAR(large[30 * 61 + 30], 0.5f, 0.01f);
    std::vector<float> nothing(12, std::numeric_limits<float>::infinity());
    EXPECT_EQ(repairNonFinite(nothing, 3, 2, 2), 12u);
    EXPECT_EQ(nothing, std::vector<float>(12, 0.f));
}

TEST(HeightField, NonFiniteCoordinatesReadTexels)
{
    const HeightField field(3, 2, {0.f, 0.25f, 0.5f, 0.125f, 0.375f, 1.f}, Wrap::Clamp);
    for (const float u : {NAN, -INFINITY})
        EXPECT_EQ(field.at({u, 0.75f}), 0.125f) << u;
    EXPECT_EQ(field.at({INFINITY, 0.75f}), 1.f);
    EXPECT_EQ(field.at({INFINITY, INFINITY}), 1.f);
    for (const float u : {NAN, -INFINITY, INFINITY})
        EXPECT_EQ(field.withWrap(Wrap::Repeat).at({u, 0.75f}), 0.125f) << u;
}

// The GPU reads 16-bit whole numbers; the CPU's heights must be those to the last bit, or searches of many steps drift apart.
TEST(Material, FlippedHeightsAreStoredValues)
{
    Image image{256, 1, 1, PixelType::U8, 8, false, {}};
    for (int v = 0; v < 256; ++v)
        image.data.push_back(std::byte(v));
    const TemporaryFolder folder;
    const auto flipped = loadOne(folder, "f.png", image, MapKind::Height, {"", Channel::R, true});
    const auto plain = loadOne(folder, "p.png", image, MapKind::Height);
    ASSERT_TRUE(flipped && plain);
    for (int v = 0; v < 256; ++v) {
        EXPECT_EQ(flipped->height->texel(v, 0), float(255 - v) / 255.f);
        EXPECT_EQ(plain->height->texel(v, 0), float(v) / 255.f);
    }
}

TEST(Material, FloatSharesAreClampedNotStretched)
{
    const TemporaryFolder folder;
    const Image image = makeImage(kTexels, kTexels, 1, PixelType::F32, [](int x, int y, int) {
        return x + y == 0 ? 1.5f : x == 1 ? -0.2f : 0.9f;
    });
    for (const MapKind kind : {MapKind::Roughness, MapKind::Metallic, MapKind::AmbientOcclusion, MapKind::Opacity}) {
        const auto material = loadOne(folder, "m.exr", image, kind);
        ASSERT_TRUE(material) << message(material.error());
        EXPECT_EQ(material->map(kind)->value(0, 0, 0), 1.f);
        EXPECT_EQ(material->map(kind)->value(1, 0, 0), 0.f);
        EXPECT_EQ(material->map(kind)->value(5, 5, 0), 0.9f);
        EXPECT_TRUE(tells(material->warnings, "value-range"));
    }
}

TEST(Material, HeightsThatOvershootSlightlyAreClamped)
{
    const TemporaryFolder folder;
    for (const float peak : {1.005f, 1.2f}) {
        const Image image = makeImage(
            kTexels, kTexels, 1, PixelType::F32, [=](int x, int y, int) { return x + y == 0 ? peak : 0.3f + 0.01f * float(x); });
        const auto material = loadOne(folder, "h.exr", image, MapKind::Height);
        ASSERT_TRUE(material);
        EXPECT_EQ(tells(material->warnings, "value-range"), peak < 1.1f);
        EXPECT_EQ(tells(material->warnings, "height-range"), peak > 1.1f);
        if (peak < 1.1f)
            EXPECT_FLOAT_EQ(material->height->texel(1, 1), 0.31f);
        else
            EXPECT_FLOAT_EQ(material->height->texel(1, 1), (0.31f - 0.3f) / (peak - 0.3f));
    }
}

TEST(Material, ElevationWithoutDataIsFilled)
{
    const TemporaryFolder folder;
    for (const float mark : {-9999.f, -32768.f, -3.4e38f}) {
        const Image image = makeImage(
            kTexels, kTexels, 1, PixelType::F32, [=](int x, int y, int) { return x == 4 && y == 4 ? mark : 100.f + float(x * y); });
        const auto material = loadOne(folder, "h.exr", image, MapKind::Height);
        ASSERT_TRUE(material);
        EXPECT_TRUE(tells(material->warnings, "no-data")) << mark;
        EXPECT_EQ(material->height->texel(kTexels - 1, kTexels - 1), 1.f);
        EXPECT_FLOAT_EQ(material->height->texel(4, 4), 16.f / float((kTexels - 1) * (kTexels - 1))); // the neighbours' mean
    }
    // A depth that is reached step by step is one.
    const Image deep = makeImage(kTexels, kTexels, 1, PixelType::F32, [](int x, int, int) { return -9999.f + float(x) * 500.f; });
    EXPECT_FALSE(tells(loadOne(folder, "h.exr", deep, MapKind::Height)->warnings, "no-data"));
}

TEST(Material, WholeNumbersAreMappedFromTheirRange)
{
    Image image = makeImage(kTexels, kTexels, 1, PixelType::F32, [](int x, int, int) { return float(x) * 1e-6f; });
    image.storedFloat = false; // as 32 bits of integers arrive
    EXPECT_EQ(soundScalars(image, Channel::R, false)[kTexels - 1], 1.f);
    EXPECT_TRUE(tells(warningsOf(scalarTrouble(image, Channel::R), "h.exr"), "height-range"));
    image.storedBits = 16; // signed, as TIFF has them
    std::vector<float> values(image.texelCount(), 100.f / 32767);
    values[5] = -1.f; // -32768
    values[9] = 3000.f / 32767;
    values[200] = 1550.f / 32767;
    std::memcpy(image.data.data(), values.data(), image.data.size());
    EXPECT_EQ(scalarTrouble(image, Channel::R).noData, 1u);
    EXPECT_EQ(soundScalars(image, Channel::R, false)[9], 1.f);
    EXPECT_NEAR(soundScalars(image, Channel::R, false)[200], 0.5f, 1e-4);
    EXPECT_EQ(soundScalars(image, Channel::R, false)[5], 0.f); // as its neighbours
}
