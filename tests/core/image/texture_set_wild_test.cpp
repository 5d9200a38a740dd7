// Texture sets as other programs name and pack them, with names that say something else than the pixels.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/texture_set.h"
#include "tests/core/image/image_support.h"
#include <gtest/gtest.h>
#include <map>

using namespace relievo;
using namespace relievo::test;
namespace fs = std::filesystem;

namespace {
// "kind file channel", a line for each map.
std::string mapsOf(const Expected<TextureSet>& set)
{
    if (!set)
        return message(set.error());
    std::string text;
    for (const FoundMap& map : set->maps)
        text += std::string(row(map.kind).key) + " " + map.file.filename().string() + " " + std::string(wordOf(map.channel)) + "\n";
    return text;
}

void writeFiles(const TemporaryFolder& folder, const std::map<std::string, Image>& files)
{
    for (const auto& [name, image] : files)
        ASSERT_TRUE(writeImage(folder / name, image));
}

Image colors(int size = kSetSize, PixelType type = PixelType::U8)
{
    return makeImage(size, size, 3, type, [](int x, int y, int c) { return float((x + 2 * y) % 7 * (c + 1)) / 40.f; });
}
Image heights(int size = kSetSize)
{
    return hillHeights(size, PixelType::U8);
}
Image normals()
{
    return hillNormals(kSetSize, false);
}
// r, g, b vary by themselves; a is `alpha` or, below 0, varies too.
Image packed(float alpha)
{
    return makeImage(kSetSize, kSetSize, 4, PixelType::U8,
        [alpha](int x, int y, int c) { return c == 3 && alpha >= 0 ? alpha : float((x * (c + 1) + y) % 16) / 16; });
}
Image greyColors()
{
    return makeImage(kSetSize, kSetSize, 3, PixelType::U8, [](int x, int y, int) { return float((x + y) % 5) / 5; });
}
} // namespace

TEST(WildSet, UnityMaskMapIsMetalOcclusionAndGloss)
{
    for (const char* name : {"Rock_MaskMap.png", "Rock_MAODS.png"})
        for (const float alpha : {-1.f, 0.7f, 1.f}) {
            const TemporaryFolder folder;
            const std::string file = std::string(name) + " ";
            const auto set = openSet(folder, {{"Rock_BaseMap.png", colors()}, {name, packed(alpha)}});
            const std::string gloss = alpha == 1 ? "" : "gloss " + file + "a\n"; // an alpha of 1 was never painted
            EXPECT_EQ(mapsOf(set), "color Rock_BaseMap.png rgb\n" + gloss + "metallic " + file + "r\nao " + file + "g\n") << alpha;
        }
}

TEST(WildSet, AColourfulMaskIsNoOpacity)
{
    const TemporaryFolder folder, grey;
    const auto set = openSet(folder, {{"Rock_Color.png", colors()}, {"Rock_Mask.png", colors()}});
    EXPECT_EQ(mapsOf(set), "color Rock_Color.png rgb\n");
    EXPECT_TRUE(tells(set->warnings, "ignored-file"));
    const auto kept = openSet(grey, {{"Rock_Color.png", colors()}, {"Rock_Mask.jpg", greyColors()}});
    EXPECT_EQ(mapsOf(kept), "color Rock_Color.png rgb\nopacity Rock_Mask.jpg r\n");
}

TEST(WildSet, APairWithoutAlphaIsItsFirstHalfWhenThePixelsAreOfItsKind)
{
    const TemporaryFolder folder, grey;
    EXPECT_EQ(mapsOf(openSet(folder, {{"t_AlbedoTransparency.png", colors()}, {"t_normalheight.png", normals()}})),
        "color t_AlbedoTransparency.png rgb\nnormal t_normalheight.png rgb\n");
    EXPECT_EQ(mapsOf(openSet(grey, {{"t_AlbedoTransparency.png", greyColors()}, {"t_normalheight.png", greyColors()}})),
        "height t_normalheight.png r\nopacity t_AlbedoTransparency.png r\n");
}

TEST(WildSet, ANormalMapNamedBumpIsANormalMap)
{
    for (const char* name : {"Rock_BumpMap.png", "Rock_bump.png"}) {
        const TemporaryFolder folder, alone;
        const auto set = openSet(folder, {{name, normals()}, {"Rock_Albedo.png", colors()}, {"Rock_ParallaxMap.png", heights()}});
        EXPECT_EQ(mapsOf(set), "height Rock_ParallaxMap.png r\ncolor Rock_Albedo.png rgb\nnormal " + std::string(name) + " rgb\n");
        EXPECT_TRUE(tells(set->warnings, "normal-named-height"));
        EXPECT_EQ(mapsOf(openSet(alone, {{name, heights()}, {"Rock_Albedo.png", colors()}})),
            "height " + std::string(name) + " r\ncolor Rock_Albedo.png rgb\n");
    }
}

TEST(WildSet, APreviewNeverReplacesTheColourMap)
{
    const TemporaryFolder folder;
    const std::string wanted = "height Rock030_Displacement.png r\ncolor Rock030_Color.png rgb\n";
    EXPECT_EQ(mapsOf(openSet(folder,
                  {{"Rock030.png", colors(2 * kSetSize, PixelType::U16)}, {"Rock030_Color.png", colors()},
                      {"Rock030_Displacement.png", heights()}})),
        wanted);
}

TEST(WildSet, DepthOfBitsOutweighsSizeOnlyInHeights)
{
    const TemporaryFolder folder;
    EXPECT_EQ(mapsOf(openSet(folder,
                  {{"Rock_Color_4k.png", colors()}, {"Rock_col_1k.png", colors(16, PixelType::U16)}, {"Rock_Height.png", heights()}})),
        "height Rock_Height.png r\ncolor Rock_Color_4k.png rgb\n");
}

TEST(WildSet, ALoneImageNamedByTheLetterAIsAHeight)
{
    for (const char* name : {"cobble_a.png", "a.png", "b.png"}) {
        const TemporaryFolder folder;
        writeFiles(folder, {{name, colors()}});
        EXPECT_EQ(mapsOf(openTextureSet(folder / name)), "height " + std::string(name) + " rgb\n");
    }
}

TEST(WildSet, ThatNothingCanBeUsedIsExplained)
{
    const TemporaryFolder folder;
    const auto set = openSet(folder, {{"Rock_arm.png", heights()}});
    ASSERT_FALSE(set);
    EXPECT_NE(set.error().hint.find("Rock_arm.png has too few channels (1)"), std::string::npos) << set.error().hint;
}

TEST(WildSet, APackedMapWithTooFewChannelsIsTold)
{
    const TemporaryFolder folder;
    const auto set = openSet(folder, {{"tile_arm.png", heights()}, {"tile_color.png", colors()}});
    EXPECT_EQ(mapsOf(set), "color tile_color.png rgb\n");
    EXPECT_TRUE(tells(set->warnings, "ignored-file"));
}

TEST(WildSet, TheLatestTakeAndNoCopyIsUsed)
{
    const TemporaryFolder folder;
    EXPECT_EQ(mapsOf(openSet(folder,
                  {{"brick_albedo_v1.png", colors()}, {"brick_albedo_v2.png", colors()}, {"brick_height_v2.png", heights()},
                      {"brick_normal - Copy.png", normals()}, {"brick_normal.png", normals()}})),
        "height brick_height_v2.png r\ncolor brick_albedo_v2.png rgb\nnormal brick_normal.png rgb\n");
}

TEST(WildSet, TheChosenFilesResolutionIsPreferred)
{
    const TemporaryFolder folder;
    writeFiles(folder,
        {{"wood_diff_1k.png", colors()}, {"wood_disp_1k.png", heights()}, {"wood_nor_1k.png", normals()},
            {"wood_diff_4k.png", colors(2 * kSetSize)}, {"wood_disp_4k.png", heights(2 * kSetSize)}});
    EXPECT_EQ(mapsOf(openTextureSet(folder / "wood_diff_1k.png")),
        "height wood_disp_1k.png r\ncolor wood_diff_1k.png rgb\nnormal wood_nor_1k.png rgb\n");
    EXPECT_EQ(mapsOf(openTextureSet(folder / "wood_diff_4k.png")),
        "height wood_disp_4k.png r\ncolor wood_diff_4k.png rgb\nnormal wood_nor_1k.png rgb\n");
}

TEST(WildSet, FilesGivenByHandAreMeasuredToo)
{
    const TemporaryFolder folder;
    const Image flat = makeImage(kSetSize, kSetSize, 3, PixelType::U8, [](int, int, int c) { return c == 2 ? 1.f : 0.5f; });
    writeFiles(folder,
        {{"plain.png", hillNormals(kSetSize, true)}, {"gl_dx.png", hillNormals(kSetSize, false)}, {"flat_dx.png", flat},
            {"in_depth.png", heights()}});
    DecodedImages images;
    const auto inverted = [&](MapKind kind, const std::string& file) {
        Warnings warnings;
        const bool invert = slotByHand(kind, folder / file, images, warnings).invert;
        EXPECT_EQ(tells(warnings, "normal-directx"), invert && kind == MapKind::Normal) << file;
        return invert;
    };
    EXPECT_TRUE(inverted(MapKind::Normal, "plain.png"));
    EXPECT_FALSE(inverted(MapKind::Normal, "gl_dx.png")); // the pixels are believed
    EXPECT_TRUE(inverted(MapKind::Normal, "flat_dx.png")); // they say nothing: the name is
    EXPECT_TRUE(inverted(MapKind::Normal, "missing_dx.png"));
    EXPECT_TRUE(inverted(MapKind::Height, "in_depth.png"));
    EXPECT_FALSE(inverted(MapKind::Color, "in_depth.png"));
    EXPECT_EQ(images.size(), 3u);
}

TEST(WildSet, DotsAfterALinkLeadToWhereItPoints)
{
    const TemporaryFolder folder;
    fs::create_directories(folder / "far/inner");
    fs::create_directory_symlink(folder / "far/inner", folder / "link");
    writeFiles(folder, {{"far/rock_height.png", heights()}});
    const auto set = openTextureSet(folder / "link/../rock_height.png");
    ASSERT_TRUE(set) << message(set.error());
    EXPECT_EQ(fs::canonical(set->maps[0].file), fs::canonical(folder / "far/rock_height.png"));
}

TEST(WildSet, UdimTilesAreToldAsSuch)
{
    for (const auto& [front, middle] : {std::pair("wall_", "."), std::pair("wall.", "_")}) {
        const TemporaryFolder folder;
        const bool numberLast = std::string(front) == "wall_";
        const auto name = [&](const std::string& kind, const std::string& tile) {
            return std::string(front) + (numberLast ? kind + middle + tile : tile + middle + kind) + ".png";
        };
        for (const char* tile : {"1001", "1002", "1011"}) {
            ASSERT_TRUE(writeImage(folder / name("height", tile), hillHeights(kSetSize, PixelType::U8)));
            ASSERT_TRUE(writeImage(folder / name("color", tile), noiseImage(kSetSize, kSetSize, 3, PixelType::U8)));
        }
        for (const std::filesystem::path& source : {folder.path(), folder / name("height", "1002")}) {
            const auto set = openTextureSet(source);
            ASSERT_TRUE(set) << message(set.error());
            ASSERT_EQ(set->maps.size(), 2u);
            EXPECT_TRUE(tells(set->warnings, "udim"));
            EXPECT_FALSE(tells(set->warnings, "several-sets"));
            const std::string tile = source == folder.path() ? "1001" : "1002";
            for (const FoundMap& map : set->maps)
                EXPECT_NE(map.file.string().find(tile), std::string::npos) << map.file;
        }
    }
}
