// Texture sets: which maps a folder holds and how they are to be read, on made-up and on real sets.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/texture_set.h"
#include "tests/core/image/image_support.h"
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace relievo;
using namespace relievo::test;
namespace fs = std::filesystem;

namespace {
const FoundMap* find(const TextureSet& set, MapKind kind)
{
    const auto found = std::ranges::find(set.maps, kind, &FoundMap::kind);
    return found == set.maps.end() ? nullptr : &*found;
}

std::string fileOf(const TextureSet& set, MapKind kind)
{
    const FoundMap* map = find(set, kind);
    return map ? map->file.filename().string() : "";
}

Image flipped(const Image& image)
{
    return makeImage(image.width, image.height, image.channels, image.type, [&](int x, int y, int c) { return 1 - image.value(x, y, c); });
}

Image flatColor(int width = kSetSize, int channels = 3)
{
    return makeImage(width, width, channels, PixelType::U8, [](int x, int, int c) { return c == 3 ? 1.f : float(x % 7 * (c + 1)) / 40.f; });
}

// Normal in r g b (or x y and a back depth), depth in alpha.
Image reliefTexture(bool dual)
{
    return makeImage(kSetSize, kSetSize, 4, PixelType::U8, [dual](int x, int y, int c) {
        const float depth = 1 - hill(x, y, kSetSize);
        return c == 3 ? depth : c == 2 && dual ? std::min(1.f, depth + 0.1f) : hillNormal(x, y, c, kSetSize, false);
    });
}

} // namespace

TEST(TextureSet, HeightAndOpenGlNormal)
{
    const TemporaryFolder folder;
    const auto set = openSet(folder,
        {{"Rock_Height.png", hillHeights(kSetSize, PixelType::U16)}, {"Rock_Normal.png", hillNormals(kSetSize, false)},
            {"Rock_Color.jpg", flatColor()}});
    ASSERT_TRUE(set) << message(set.error());
    EXPECT_EQ(set->name, "Rock");
    ASSERT_EQ(set->maps.size(), 3u);
    EXPECT_EQ(find(*set, MapKind::Height)->convention, Convention::Height);
    EXPECT_EQ(find(*set, MapKind::Height)->channel, Channel::R);
    EXPECT_EQ(find(*set, MapKind::Height)->info.storedBits, 16);
    EXPECT_EQ(find(*set, MapKind::Normal)->convention, Convention::GL);
    EXPECT_EQ(find(*set, MapKind::Color)->convention, Convention::Srgb);
    EXPECT_TRUE(set->warnings.empty());
}

TEST(TextureSet, DepthAndDirectXAreMeasuredNotBelieved)
{
    const TemporaryFolder folder;
    const auto set = openSet(
        folder, {{"rock_height.png", flipped(hillHeights(kSetSize, PixelType::U16))}, {"rock_normalgl.png", hillNormals(kSetSize, true)}});
    ASSERT_TRUE(set);
    EXPECT_EQ(find(*set, MapKind::Height)->convention, Convention::Depth);
    EXPECT_EQ(find(*set, MapKind::Normal)->convention, Convention::DX);
    EXPECT_TRUE(tells(set->warnings, "normal-contradicts-height"));
    EXPECT_TRUE(tells(set->warnings, "normal-directx"));
    const MapSlots slots = set->slots();
    EXPECT_TRUE(slots[std::size_t(MapKind::Height)].invert);
    EXPECT_TRUE(slots[std::size_t(MapKind::Normal)].invert);
    EXPECT_TRUE(slots[std::size_t(MapKind::Color)].empty());
}

TEST(TextureSet, TheLetterAIsEmissionWhenItIsDark)
{
    const auto lights = [](float ground) {
        return makeImage(
            kSetSize, kSetSize, 1, PixelType::U8, [=](int x, int y, int) { return x % 16 == 0 && y % 16 == 0 ? 1.f : ground; });
    };
    for (const float ground : {0.f, 0.5f}) {
        const TemporaryFolder folder;
        const auto set = openSet(
            folder, {{"pipes_d.png", flatColor()}, {"pipes_n.png", hillNormals(kSetSize, false)}, {"pipes_a.png", lights(ground)}});
        ASSERT_TRUE(set) << message(set.error());
        EXPECT_EQ(fileOf(*set, MapKind::Emission), ground == 0.f ? "pipes_a.png" : "");
        EXPECT_EQ(tells(set->warnings, "ignored-file"), ground != 0.f);
        EXPECT_EQ(set->maps.size(), ground == 0.f ? 3u : 2u);
    }
}

TEST(TextureSet, RoughnessOfAMaterialNamedMetalIsKept)
{
    const TemporaryFolder folder;
    const auto set = openSet(folder,
        {{"HammeredMetal_Color.png", flatColor()}, {"HammeredMetal_Roughness.png", noiseImage(kSetSize, kSetSize, 1, PixelType::U8)}});
    ASSERT_TRUE(set) << message(set.error());
    EXPECT_EQ(set->name, "HammeredMetal");
    EXPECT_EQ(fileOf(*set, MapKind::Roughness), "HammeredMetal_Roughness.png");
    EXPECT_FALSE(find(*set, MapKind::Metallic));
    EXPECT_TRUE(set->warnings.empty());
}

TEST(TextureSet, NormalOfAnotherMaterialIsTold)
{
    const TemporaryFolder folder;
    const auto set = openSet(
        folder, {{"rock_depth.png", noiseImage(kSetSize, kSetSize, 1, PixelType::U8)}, {"rock_normal.png", hillNormals(kSetSize, false)}});
    ASSERT_TRUE(set);
    EXPECT_TRUE(tells(set->warnings, "normal-contradicts-height"));
    EXPECT_EQ(find(*set, MapKind::Height)->convention, Convention::Depth); // the name decides
}

TEST(TextureSet, NormalWithoutHeightIsMeasuredByItself)
{
    for (const bool directX : {false, true}) {
        const TemporaryFolder folder;
        const auto set = openSet(folder, {{"rock_normal.png", hillNormals(kSetSize, directX)}, {"rock_color.png", flatColor()}});
        ASSERT_TRUE(set);
        EXPECT_EQ(find(*set, MapKind::Normal)->convention, directX ? Convention::DX : Convention::GL);
    }
    const TemporaryFolder folder;
    const Image flat = makeImage(kSetSize, kSetSize, 3, PixelType::U8, [](int, int, int c) { return c == 2 ? 1.f : 0.5f; });
    const auto set = openSet(folder, {{"rock_normal.png", flat}, {"rock_color.png", flatColor()}, {"wall_nor_dx.png", flat}});
    ASSERT_TRUE(set);
    EXPECT_EQ(find(*set, MapKind::Normal)->convention, Convention::Unsure);
    EXPECT_TRUE(tells(set->warnings, "normal-unsure"));
}

TEST(TextureSet, PackedChannels)
{
    const TemporaryFolder folder;
    const auto set = openSet(
        folder, {{"wall_arm_2k.png", flatColor()}, {"wall_diff_2k.png", flatColor()}, {"wall_ao_2k.png", flatColor(kSetSize, 1)}});
    ASSERT_TRUE(set);
    EXPECT_EQ(fileOf(*set, MapKind::AmbientOcclusion), "wall_ao_2k.png"); // a file to itself
    EXPECT_EQ(find(*set, MapKind::Roughness)->channel, Channel::G);
    EXPECT_EQ(find(*set, MapKind::Metallic)->channel, Channel::B);
    EXPECT_NE(find(*set, MapKind::Roughness)->max, find(*set, MapKind::Metallic)->max);
}

TEST(TextureSet, PairsNeedAnAlphaThatVaries)
{
    const TemporaryFolder folder;
    const auto set = openSet(folder, {{"g_alb_ht.png", flatColor(kSetSize, 4)}, {"g_nrm_rgh.png", flatColor(kSetSize, 3)}});
    ASSERT_TRUE(set);
    EXPECT_EQ(fileOf(*set, MapKind::Color), "g_alb_ht.png");
    EXPECT_EQ(find(*set, MapKind::Height), nullptr); // alpha is 1 everywhere
    EXPECT_EQ(fileOf(*set, MapKind::Roughness), "g_nrm_rgh.png"); // no alpha: the last word counts
}

TEST(TextureSet, ReliefTexturesOfThePapers)
{
    for (const bool dual : {false, true})
        for (const char* name : {"statue_relief.png", "statue_rm.tga", dual ? "statue_dual.png" : "statue_nd.png", "statue.png"}) {
            const TemporaryFolder folder;
            const auto set = openSet(folder, {{name, reliefTexture(dual)}});
            ASSERT_TRUE(set) << name;
            ASSERT_EQ(set->maps.size(), 2u) << name << dual;
            EXPECT_EQ(find(*set, MapKind::Height)->channel, Channel::A) << name;
            EXPECT_EQ(find(*set, MapKind::Height)->convention, Convention::Depth) << name;
            EXPECT_EQ(find(*set, MapKind::Normal)->convention, Convention::GL) << name;
            EXPECT_TRUE(tells(set->warnings, dual ? "relief-texture-dual" : "relief-texture")) << name;
        }
}

TEST(TextureSet, BestOfSeveralCandidates)
{
    const TemporaryFolder folder;
    const auto set = openSet(folder,
        {{"w_height_1k.png", hillHeights(kSetSize, PixelType::U16)}, {"w_height_2k.png", hillHeights(2 * kSetSize, PixelType::U8)},
            {"w_nor_dx.png", hillNormals(kSetSize, true)}, {"w_nor_gl.png", hillNormals(kSetSize, false)}, {"w_col_1k.png", flatColor()},
            {"w_col_2k.png", flatColor(2 * kSetSize)}});
    ASSERT_TRUE(set);
    EXPECT_EQ(fileOf(*set, MapKind::Height), "w_height_1k.png"); // deeper beats larger
    EXPECT_EQ(fileOf(*set, MapKind::Normal), "w_nor_gl.png");
    EXPECT_EQ(fileOf(*set, MapKind::Color), "w_col_2k.png");
    EXPECT_TRUE(tells(set->warnings, "ignored-file"));
    const auto named = openTextureSet(folder / "w_col_1k.png"); // what the user names wins
    ASSERT_TRUE(named);
    EXPECT_EQ(fileOf(*named, MapKind::Color), "w_col_1k.png");
    EXPECT_EQ(fileOf(*named, MapKind::Height), "w_height_1k.png");
}

TEST(TextureSet, SeveralSetsInAFolder)
{
    const TemporaryFolder folder;
    const auto set = openSet(folder,
        {{"a_height.png", hillHeights(kSetSize, PixelType::U8)}, {"b_height.png", hillHeights(kSetSize, PixelType::U8)},
            {"b_color.png", flatColor()}});
    ASSERT_TRUE(set);
    EXPECT_EQ(set->name, "b");
    EXPECT_TRUE(tells(set->warnings, "several-sets"));
    const auto other = openTextureSet(folder / "a_height.png");
    ASSERT_TRUE(other);
    EXPECT_EQ(other->maps.size(), 1u);
    EXPECT_EQ(other->name, "a_height");
}

TEST(TextureSet, SingleImages)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "grass.png", flatColor()));
    ASSERT_TRUE(writeImage(folder / "face-depth.png", hillHeights(kSetSize, PixelType::U8)));
    ASSERT_TRUE(writeImage(folder / "vitamin_d.png", flatColor()));
    for (const char* name : {"grass.png", "face-depth.png", "vitamin_d.png"}) {
        const auto set = openTextureSet(folder / name);
        ASSERT_TRUE(set) << name;
        ASSERT_EQ(set->maps.size(), 1u) << name;
        EXPECT_EQ(set->maps[0].kind, MapKind::Height);
        EXPECT_EQ(set->maps[0].convention, std::string(name) == "face-depth.png" ? Convention::Depth : Convention::Height);
    }
    EXPECT_EQ(openTextureSet(folder / "grass.png")->maps[0].channel, Channel::Rgb); // not grey: the mean
}

TEST(TextureSet, PlainNameIsTheColourUnlessThereIsOne)
{
    const TemporaryFolder folder;
    const auto set = openSet(folder, {{"bricks.png", flatColor()}, {"bricks_height.png", hillHeights(kSetSize, PixelType::U8)}});
    ASSERT_TRUE(set);
    EXPECT_EQ(fileOf(*set, MapKind::Color), "bricks.png");
    const auto second = openSet(folder, {{"bricks_color.png", flatColor()}});
    ASSERT_TRUE(second);
    EXPECT_EQ(fileOf(*second, MapKind::Color), "bricks_color.png");
}

TEST(TextureSet, ImagesOneFolderDown)
{
    const TemporaryFolder folder;
    fs::create_directory(folder / "textures");
    ASSERT_TRUE(writeImage(folder / "textures/rock_height.png", hillHeights(kSetSize, PixelType::U8)));
    const auto set = openTextureSet(folder.path());
    ASSERT_TRUE(set);
    EXPECT_EQ(nlohmann::json::parse(textureSetJson(*set))["maps"][0]["file"], "textures/rock_height.png");
}

TEST(TextureSet, ABrokenMapIsToldAndTheRestKept)
{
    const TemporaryFolder folder;
    writeAll(folder / "rock_color.png", "not a picture");
    ASSERT_TRUE(writeImage(folder / "rock_rough.png", noiseImage(256, 256, 1, PixelType::U8)));
    const std::string whole = readAll(folder / "rock_rough.png");
    writeAll(folder / "rock_rough.png", whole.substr(0, whole.size() / 2));
    const auto set = openSet(folder, {{"rock_height.png", hillHeights(kSetSize, PixelType::U8)}});
    ASSERT_TRUE(set);
    EXPECT_EQ(set->maps.size(), 1u);
    EXPECT_EQ(std::ranges::count(set->warnings, "map-broken", &Warning::code), 2);
}

TEST(TextureSet, WordsWhenNothingIsThere)
{
    const TemporaryFolder folder;
    EXPECT_FALSE(openTextureSet(folder / "missing"));
    const auto empty = openTextureSet(folder.path());
    ASSERT_FALSE(empty);
    EXPECT_EQ(empty.error().where, folder.path().string());
    EXPECT_FALSE(empty.error().hint.empty());
    writeAll(folder / "x.ktx2", "\xabKTX 20");
    const auto container = openTextureSet(folder.path());
    ASSERT_FALSE(container);
    EXPECT_NE(container.error().what.find("KTX2"), std::string::npos);
    writeAll(folder / "rock_height.png", "");
    const auto broken = openTextureSet(folder.path());
    ASSERT_FALSE(broken);
    EXPECT_NE(broken.error().where.find("rock_height.png"), std::string::npos);
}

TEST(TextureSet, JsonHasWhatScriptsRelyOn)
{
    const TemporaryFolder folder;
    const Image floats = makeImage(kSetSize, kSetSize, 1, PixelType::F32, [](int x, int y, int) { return 3 * hill(x, y, kSetSize) - 1; });
    const auto set = openSet(folder, {{"r_height.exr", floats}});
    ASSERT_TRUE(set);
    const auto json = nlohmann::json::parse(textureSetJson(*set));
    EXPECT_EQ(json["name"], "r");
    const auto& map = json["maps"][0];
    EXPECT_EQ(map["kind"], "height");
    EXPECT_EQ(map["file"], "r_height.exr");
    EXPECT_EQ(map["channel"], "r");
    EXPECT_EQ(map["bits"], 32);
    EXPECT_EQ(map["convention"], "height");
    EXPECT_LT(map["min"], 0.0); // as stored
    EXPECT_GT(map["max"], 1.0);
    EXPECT_EQ(json["warnings"][0]["code"], "height-range");
}

TEST(TextureSet, FileNamesThatAreNoUtf8)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "caf\xe9_height.png", hillHeights(kSetSize, PixelType::U8)));
    const auto set = openTextureSet(folder.path());
    ASSERT_TRUE(set) << message(set.error());
    EXPECT_NO_THROW(nlohmann::json::parse(textureSetJson(*set)));
}

TEST(TextureSet, Cancelled)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "r_height.png", hillHeights(kSetSize, PixelType::U8)));
    std::stop_source source;
    source.request_stop();
    const auto set = openTextureSet(folder.path(), Progress{{}, source.get_token()});
    ASSERT_FALSE(set);
    EXPECT_TRUE(isCancelled(set.error()));
}

// CONVENTIONS.tsv: set, normal, height, channel, specs, polarity, convention, correlations, note.
TEST(TextureSet, MeasuredTruthOfTheRealSets)
{
    std::ifstream table(dataFolder() / "CONVENTIONS.tsv");
    if (!table)
        GTEST_SKIP() << "no test data beside the checkout";
    std::string line;
    std::getline(table, line);
    int sets = 0;
    while (std::getline(table, line)) {
        std::vector<std::string> cells;
        std::stringstream cellsOf(line);
        for (std::string cell; std::getline(cellsOf, cell, '\t');)
            cells.push_back(cell);
        ASSERT_GE(cells.size(), 8u);
        const auto set = openTextureSet(dataFolder() / "materials" / cells[0]);
        ASSERT_TRUE(set) << message(set.error());
        EXPECT_EQ(fileOf(*set, MapKind::Normal), cells[1]) << cells[0];
        EXPECT_EQ(fileOf(*set, MapKind::Height), cells[2]) << cells[0];
        EXPECT_EQ(find(*set, MapKind::Height)->channel, cells[3] == "A" ? Channel::A : Channel::R) << cells[0];
        EXPECT_EQ(find(*set, MapKind::Height)->convention, cells[6].starts_with("depth") ? Convention::Depth : Convention::Height)
            << cells[0];
        EXPECT_EQ(find(*set, MapKind::Normal)->convention, cells[7].starts_with("DX") ? Convention::DX : Convention::GL) << cells[0];
        EXPECT_FALSE(tells(set->warnings, "normal-contradicts-height")) << cells[0];
        ++sets;
    }
    EXPECT_EQ(sets, 10);
}

TEST(TextureSet, KindsOfTheRealSets)
{
    const fs::path materials = dataFolder() / "materials";
    if (!fs::exists(materials))
        GTEST_SKIP() << "no test data beside the checkout";
    const std::map<std::string, std::string> wanted = {
        {"3dtextures_abstract_008", "height color normal roughness metallic ao"},
        {"3dtextures_rock_024_dx", "height color normal roughness ao"},
        {"ambientcg_bricks076c_dds", "height color normal specular"},
        {"ambientcg_ground037_packed", "height color normal roughness"},
        {"bevy_cube_vertical_walls", "height color normal"},
        {"bgfx_heightmap_float_exr", "height"},
        {"godot_bricks_depthmap", "height color normal metallic ao"},
        {"godot_cheese_npot", "height color normal ao"},
        {"materialx_images", "height"},
        {"mdl_carbon_weave", "height"},
        {"mdl_diamond_plate_no_height", "color normal roughness"},
        {"panda_terrain_16bit", "height"},
        {"pk01_grating", "height color normal specular"},
        {"pk02_panels01a_dx", "height color normal specular"},
        {"pk02_pipes01_dx", "height color normal specular emission"},
        {"usgs_jacksboro_dem_16bit", "height"},
    };
    for (const auto& [name, kinds] : wanted) {
        const auto set = openTextureSet(materials / name);
        ASSERT_TRUE(set) << message(set.error());
        std::string found;
        for (const FoundMap& map : set->maps)
            found += (found.empty() ? "" : " ") + std::string(row(map.kind).key);
        EXPECT_EQ(found, kinds) << name;
    }
    for (const char* name : {"ktx2_reference_samples", "vulkan_crate01_color_height_ktx1", "modelrelief_scallop_rawf32_512x512"})
        EXPECT_FALSE(openTextureSet(materials / name)) << name;
}
