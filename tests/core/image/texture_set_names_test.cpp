// File names of the usual sources, and what they mean.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/sets/file_names.h"
#include "core/image/sets/set_groups.h"
#include "core/image/sets/texture_set.h"
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

using namespace relievo;
namespace fs = std::filesystem;

namespace {
struct NameCase {
    const char* name;
    const char* roles; // "kind" or "kind:channel", "" for none; packed ones in order
    const char* stem;
    Convention convention = Convention::Unsure;
};

std::string rolesText(const NameGuess& guess)
{
    std::string text;
    for (const MapRole& role : guess.roles) {
        text += (text.empty() ? "" : " ") + std::string(row(role.kind).key);
        if (role.channel != Channel::Rgb)
            text += ":" + std::string(wordOf(role.channel));
    }
    return text;
}

constexpr Convention kH = Convention::Height, kD = Convention::Depth, kGl = Convention::GL, kDx = Convention::DX;
constexpr NameCase kNames[] = {
    // ambientCG
    {"Bricks076C_1K-JPG_Color", "color", "bricks076c"},
    {"Bricks076C_1K-JPG_NormalGL", "normal", "bricks076c", kGl},
    {"Bricks076C_1K-JPG_NormalDX", "normal", "bricks076c", kDx},
    {"Bricks076C_1K-JPG_Displacement", "height", "bricks076c", kH},
    {"Bricks076C_1K-JPG_AmbientOcclusion", "ao", "bricks076c"},
    {"Bricks076C_1K-JPG_Roughness", "roughness", "bricks076c"},
    {"Metal032_2K_Metalness", "metallic", "metal032"},
    {"Leaf001_4K_Opacity", "opacity", "leaf001"},
    {"Bricks076C", "", "bricks076c"},
    // Poly Haven
    {"brick_wall_001_diff_2k", "color", "brick_wall_001"},
    {"brick_wall_001_diffuse_4k", "color", "brick_wall_001"},
    {"brick_wall_001_nor_gl_2k", "normal", "brick_wall_001", kGl},
    {"brick_wall_001_nor_dx_2k", "normal", "brick_wall_001", kDx},
    {"brick_wall_001_disp_2k", "height", "brick_wall_001", kH},
    {"brick_wall_001_rough_2k", "roughness", "brick_wall_001"},
    {"brick_wall_001_arm_2k", "ao:r roughness:g metallic:b", "brick_wall_001"},
    {"brick_wall_001_ao_2k", "ao", "brick_wall_001"},
    {"brick_wall_001_spec_2k", "specular", "brick_wall_001"},
    {"coast_sand_rocks_02_col_01_1k", "color", "coast_sand_rocks_02_01"},
    // Substance
    {"Wood_Base_Color", "color", "wood"},
    {"Wood_BaseColor", "color", "wood"},
    {"Wood_Normal_OpenGL", "normal", "wood", kGl},
    {"Wood_NormalDirectX", "normal", "wood", kDx},
    {"Wood_Mixed_AO", "ao", "wood"},
    {"Wood_OcclusionRoughnessMetallic", "ao:r roughness:g metallic:b", "wood"},
    {"Wood_Height", "height", "wood", kH},
    {"Wood_Metallic", "metallic", "wood"},
    {"Wood_Emissive", "emission", "wood"},
    {"Wood_BaseColor_1001", "color", "wood_1001"},
    // Quixel
    {"tdchbhp_2K_Albedo", "color", "tdchbhp"},
    {"tdchbhp_2K_Displacement", "height", "tdchbhp", kH},
    {"tdchbhp_2K_Bump", "height", "tdchbhp", kH},
    {"tdchbhp_2K_Normal_LOD0", "normal", "tdchbhp"},
    {"tdchbhp_8K_Gloss", "gloss", "tdchbhp"},
    {"tdchbhp_2K_Cavity", "", "tdchbhp_cavity"},
    // FreePBR
    {"rocky-dirt1-albedo", "color", "rocky_dirt1"},
    {"rocky-dirt1-normal-ogl", "normal", "rocky_dirt1", kGl},
    {"rocky-dirt1-normal-dx", "normal", "rocky_dirt1", kDx},
    {"rocky-dirt1_Normal-dx", "normal", "rocky_dirt1", kDx},
    {"rocky-dirt1-ao", "ao", "rocky_dirt1"},
    {"rocky-dirt1-metalness", "metallic", "rocky_dirt1"},
    // 3D Textures
    {"Rock_024_baseColor", "color", "rock_024"},
    {"Rock_024_ambientOcclusion", "ao", "rock_024"},
    {"Rock_024_NORM", "normal", "rock_024"},
    {"Rock_024_OCC", "ao", "rock_024"},
    {"Rock_024_DISP", "height", "rock_024", kH},
    // cgbookcase
    {"StoneWall01_2K_Base_Color", "color", "stonewall01"},
    {"StoneWall01_2K_Ambient_Occlusion", "ao", "stonewall01"},
    {"StoneWall01_MR_2K_Height_16bit", "height", "stonewall01_mr", kH},
    // Games and engines
    {"floor01_n", "normal", "floor01"},
    {"T_Rock_D", "color", "t_rock"},
    {"Bricks076C_normheight", "normal height:a", "bricks076c", kH},
    {"Bricks076C_diffspec", "color specular:a", "bricks076c"},
    {"ground037_alb_ht", "color height:a", "ground037", kH},
    {"ground037_nrm_rgh", "normal roughness:a", "ground037"},
    {"rock_nh", "normal height:a", "rock", kH},
    {"rock_relief", "normal height:a", "rock"},
    {"rock_dual", "normal height:a", "rock"},
    {"Avocado_roughnessMetallic", "roughness:g metallic:b", "avocado"},
    {"wall_orm", "ao:r roughness:g metallic:b", "wall"},
    {"wall_rma", "roughness:r metallic:g ao:b", "wall"},
    {"Rock_MaskMap", "metallic:r ao:g gloss:a", "rock"},
    {"Rock_MAODS", "metallic:r ao:g gloss:a", "rock"},
    {"Rock_MetallicSmoothness", "metallic:r gloss:a", "rock"},
    {"Rock_MetallicGlossMap", "metallic:r gloss:a", "rock"},
    {"Rock_SpecularSmoothness", "specular gloss:a", "rock"},
    {"Rock_AlbedoTransparency", "color opacity:a", "rock"},
    {"Rock_BaseMap", "color", "rock"},
    {"Rock_MainTex", "color", "rock"},
    {"T_Rock_BC", "color", "t_rock"},
    {"T_Rock_ORMH", "ao:r roughness:g metallic:b height:a", "t_rock"},
    {"T_Rock_RMAH", "roughness:r metallic:g ao:b height:a", "t_rock"},
    {"T_Rock_MRAO", "metallic:r roughness:g ao:b", "t_rock"},
    {"T_Rock_ORDp", "ao:r roughness:g height:b", "t_rock"},
    {"T_Rock_DpRA", "height:r roughness:g ao:b", "t_rock"},
    {"metallic-Rock_roughness", "roughness:g metallic:b", "rock"},
    {"Rock_metallic-Rock_roughness", "roughness:g metallic:b", "rock"},
    {"Metal-Rock_roughness", "roughness", "metal_rock"},
    {"rock_displ", "height", "rock", kH},
    {"rock_hm", "height", "rock", kH},
    {"rock_ddn", "normal", "rock"},
    {"rock_nm", "normal", "rock"},
    {"rock_glossy", "gloss", "rock"},
    {"Rock_specularLevel", "specular", "rock"},
    // Takes and bit depths
    {"brick_albedo_v2", "color", "brick"},
    {"brick_v2_albedo", "color", "brick_v2"},
    {"brick_height_ver03", "height", "brick", kH},
    {"Bricks001_COL_VAR1_3K", "color", "bricks001"},
    {"rock_color - Copy", "color", "rock"},
    {"rock_color_old", "color", "rock"},
    {"rock_new_normal", "normal", "rock_new"},
    {"Bricks001_DISP16_3K", "height", "bricks001", kH},
    {"Bricks001_NRM16_3K", "normal", "bricks001"},
    {"coast_sand_01_coll2_1k", "color", "coast_sand_01"},
    {"height2", "height", "2", kH},
    // Single words, spaces, dots, case
    {"height", "height", "", kH},
    {"DEPTH", "height", "", kD},
    {"texture_bricks_depth", "height", "texture_bricks", kD},
    {"plain_heightmap", "height", "plain", kH},
    {"heightfield", "height", "", kH},
    {"jacksboro_fault_dem_u16", "height", "jacksboro_fault", kH},
    {"old wall normal map", "normal", "old wall"},
    {"old.wall.roughness", "roughness", "old_wall"},
    {"wall normal 4096x4096", "normal", "wall"},
    {"normal_bricks", "normal", "bricks"},
    {"texture_bricks", "", "texture_bricks"},
    {"metal_plate_07", "", "metal_plate_07"},
    {"grass", "", "grass"},
    {"", "", ""},
};
} // namespace

TEST(TextureSetNames, Table)
{
    for (const NameCase& one : kNames) {
        const NameGuess guess = guessFromName(one.name);
        EXPECT_EQ(rolesText(guess), one.roles) << one.name;
        std::string stem = guess.stem;
        std::ranges::replace(stem, '_', ' ');
        std::string wanted = one.stem;
        std::ranges::replace(wanted, '_', ' ');
        EXPECT_EQ(stem, wanted) << one.name;
        EXPECT_EQ(guess.convention, one.convention) << one.name;
    }
}

TEST(TextureSetNames, OneLetterIsWeak)
{
    EXPECT_TRUE(guessFromName("floor_n").weak);
    EXPECT_FALSE(guessFromName("floor_nor").weak);
}

TEST(TextureSetNames, OneLetterNeedsASibling)
{
    const std::vector<std::filesystem::path> alone = {"vitamin_d.png"}, pair = {"floor_d.png", "floor_n.png"};
    EXPECT_EQ(groupFiles(alone)[0].kinds(), 0);
    EXPECT_EQ(groupFiles(pair)[0].kinds(), 2);
}

TEST(TextureSetNames, NearlyEqualStemsAreOneSet)
{
    const std::vector<std::filesystem::path> files = {"floor01_h.png", "floor01_n.png", "floor01a_d.png", "rock1_h.png", "rock12_d.png"};
    const std::vector<FileGroup> groups = groupFiles(files);
    EXPECT_EQ(groups[0].stem, "floor01");
    EXPECT_EQ(groups[0].kinds(), 3);
    EXPECT_EQ(groups[1].kinds(), 0);
}

TEST(TextureSetNames, TheLetterAIsVagueAndWantsAColor)
{
    using Files = std::vector<std::filesystem::path>;
    EXPECT_EQ(guessFromName("pipes_a").vague, 'a');
    EXPECT_FALSE(guessFromName("pipes_d").vague);
    const auto first = [](const Files& files) { return groupFiles(files)[0]; };
    EXPECT_TRUE(first({"pipes_a.png", "pipes_d.png", "pipes_n.png"}).holds(MapKind::Emission));
    EXPECT_TRUE(first({"pipes_a.png", "pipes_color.png"}).holds(MapKind::Emission));
    EXPECT_FALSE(first({"pipes_a.png", "pipes_h.png", "pipes_n.png"}).holds(MapKind::Emission)); // no colour
    EXPECT_EQ(first({"vitamin_a.png", "vitamin_d.png"}).kinds(), 0); // is no second opinion itself
    const FileGroup both = first({"pipes_a.png", "pipes_color.png", "pipes_emissive.png"});
    EXPECT_EQ(both.files.size(), 2u);
    EXPECT_FALSE(both.contains("pipes_a.png"));
}

TEST(TextureSetNames, AMaterialsNameMayEndInAKindWord)
{
    const std::vector<std::filesystem::path> metal
        = {"HammeredMetal_Color.png", "HammeredMetal_Height.png", "HammeredMetal_Roughness.png", "HammeredMetal_Metallic.png"};
    const std::vector<FileGroup> groups = groupFiles(metal);
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].title, "HammeredMetal");
    EXPECT_EQ(groups[0].kinds(), 4);
    const std::vector<std::filesystem::path> pair = {"HammeredMetal_Color.png", "HammeredMetal_Roughness.png"};
    EXPECT_EQ(groupFiles(pair).size(), 1u);
    EXPECT_EQ(groupFiles(pair)[0].kinds(), 2);
    // Where the siblings say so, metal and roughness do lie in one file.
    const std::vector<std::filesystem::path> packed = {"Avocado_baseColor.png", "Avocado_normal.png", "Avocado_metalRoughness.png"};
    EXPECT_EQ(groupFiles(packed)[0].stem, "avocado");
    EXPECT_EQ(groupFiles(packed)[0].kinds(), 4);
    // The image that bears the material's name alone.
    const std::vector<std::filesystem::path> plain = {"HammeredMetal.png", "HammeredMetal_Normal.png"};
    ASSERT_EQ(groupFiles(plain).size(), 1u);
    EXPECT_EQ(groupFiles(plain)[0].plain.size(), 1u);
    // A map that is named twice over keeps its own set.
    const std::vector<std::filesystem::path> twice = {"rock_h.png", "rock_n.png", "rock_metallic.png", "rock_metallic_ao.png"};
    EXPECT_TRUE(groupFiles(twice)[0].holds(MapKind::Metallic));
}

TEST(TextureSetNames, AMaterialsNameMayEndInAColourOrNormalWord)
{
    for (const std::string name : {"MultiColor", "RoughNormal"}) {
        std::vector<std::filesystem::path> files;
        for (const char* kind : {"Color", "Height", "Normal", "Roughness", "AO", "Metallic"})
            files.push_back(name + "_" + kind + ".png");
        const std::vector<FileGroup> groups = groupFiles(files);
        ASSERT_EQ(groups.size(), 1u) << name;
        EXPECT_EQ(groups[0].title, name);
        EXPECT_EQ(groups[0].kinds(), 6) << name;
    }
}

TEST(TextureSetNames, PoliigonsWorkflowIsNoKind)
{
    std::vector<std::filesystem::path> files;
    for (const char* kind : {"BUMP", "COL", "DISP", "METALNESS", "NRM", "ROUGHNESS"})
        files.push_back("Tiles_001_" + std::string(kind) + "_1K_METALNESS.png");
    const std::vector<FileGroup> groups = groupFiles(files);
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].title, "Tiles_001");
    EXPECT_EQ(groups[0].kinds(), 5);
    // Materials whose names end in a kind word and a number.
    const std::vector<std::filesystem::path> two
        = {"wall_metal_01_color.png", "wall_metal_01_normal.png", "wall_rough_01_color.png", "wall_rough_01_normal.png"};
    EXPECT_EQ(groupFiles(two).size(), 2u);
    EXPECT_EQ(groupFiles(two)[0].title, "wall_metal_01");
}

TEST(TextureSetNames, TheLetterBIsColorBesideMegascansPackedMaps)
{
    const auto first = [](const std::vector<std::filesystem::path>& files) { return groupFiles(files)[0]; };
    EXPECT_TRUE(first({"T_Rock_B.png", "T_Rock_N.png", "T_Rock_ORDp.png"}).holds(MapKind::Color));
    EXPECT_FALSE(first({"T_Rock_B.png", "T_Rock_N.png", "T_Rock_H.png"}).holds(MapKind::Color));
}

TEST(TextureSetNames, PoliigonsReflectionIsSpecular)
{
    std::vector<std::filesystem::path> files;
    for (const char* kind : {"COL_VAR1", "DISP", "GLOSS", "NRM", "REFL"})
        files.push_back("Bricks01_" + std::string(kind) + "_3K.jpg");
    const std::vector<FileGroup> groups = groupFiles(files);
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].kinds(), 5);
    EXPECT_TRUE(groups[0].holds(MapKind::Specular));
}

// Archicad's catalogue: c colour, dp displacement, ro roughness.
TEST(TextureSetNames, TheLettersOfArchicad)
{
    const auto first = [](const std::vector<std::filesystem::path>& files) { return groupFiles(files)[0]; };
    const FileGroup set = first({"Brick c.jpg", "Brick dp.jpg", "Brick n.jpg", "Brick ro.jpg"});
    EXPECT_EQ(set.stem, "brick");
    for (const MapKind kind : {MapKind::Color, MapKind::Height, MapKind::Normal, MapKind::Roughness})
        EXPECT_TRUE(set.holds(kind)) << int(kind);
    EXPECT_TRUE(guessFromName("Brick_dp").weak && guessFromName("Brick_ro").weak);
    EXPECT_EQ(guessFromName("Brick_DP").convention, Convention::Height);
    EXPECT_TRUE(first({"rock_C.png", "rock_N.png"}).holds(MapKind::Color));
    EXPECT_TRUE(first({"rock_C.png", "rock_Height.png"}).holds(MapKind::Color));
}

TEST(TextureSetNames, TheLetterCMayNumberTakes)
{
    using Files = std::vector<std::filesystem::path>;
    const auto holdsColor = [](const Files& files) {
        return std::ranges::any_of(groupFiles(files), [](const FileGroup& group) { return group.holds(MapKind::Color); });
    };
    EXPECT_FALSE(holdsColor({"vitamin_c.png"}));
    EXPECT_FALSE(holdsColor({"rock_a.png", "rock_b.png", "rock_c.png"}));
    EXPECT_FALSE(holdsColor({"rock_a.png", "rock_b.png", "rock_c.png", "rock_height.png"}));
    EXPECT_FALSE(holdsColor({"rock_c.png", "rock_roughness.png"}));
    const Files both = {"rock_c.png", "rock_color.png", "rock_normal.png"};
    EXPECT_FALSE(groupFiles(both)[0].contains("rock_c.png") && groupFiles(both)[0].kinds() != 2);
    const Files takes = {"rock_c.png", "rock_c_normal.png", "rock_c_height.png"};
    EXPECT_EQ(groupFiles(takes)[0].stem, "rock_c");
}

TEST(TextureSetNames, ResolutionsAreKept)
{
    EXPECT_EQ(guessFromName("wood_diff_4K").resolution, "4k");
    EXPECT_EQ(guessFromName("wood_2048_diff_16bit").resolution, "2048");
    EXPECT_EQ(guessFromName("wood_diff_16bit").resolution, "");
}

TEST(TextureSetNames, MapKindsAreFoundByKey)
{
    EXPECT_EQ(findMapKind("ao"), MapKind::AmbientOcclusion);
    EXPECT_FALSE(findMapKind("aoo"));
}

// German, French, Spanish, Japanese, in the forms and cases that file systems have.
TEST(TextureSetNames, WordsOfOtherLanguages)
{
    const auto kindOf = [](const std::string& name) {
        const NameGuess guess = guessFromName(name);
        return guess.roles.size() == 1 ? std::string(row(guess.roles[0].kind).key) + ' ' + guess.title : "none";
    };
    EXPECT_EQ(kindOf("Mauer_H\xc3\xb6he"), "height Mauer");
    EXPECT_EQ(kindOf("Mauer_Ho\xcc\x88he"), "height Mauer"); // o and its dots apart
    EXPECT_EQ(kindOf("MAUER_H\xc3\x96HE"), "height MAUER");
    EXPECT_EQ(kindOf("Mauer-Hoehe"), "height Mauer");
    EXPECT_EQ(kindOf("Mauer_Farbe"), "color Mauer");
    EXPECT_EQ(kindOf("Mauer_Rauheit"), "roughness Mauer");
    EXPECT_EQ(kindOf("mur_hauteur"), "height mur");
    EXPECT_EQ(kindOf("mur_couleur"), "color mur");
    EXPECT_EQ(kindOf("mur_rugosit\xc3\xa9"), "roughness mur");
    EXPECT_EQ(kindOf("muro_altura"), "height muro");
    EXPECT_EQ(kindOf("muro_normales"), "normal muro");
    EXPECT_EQ(kindOf("\xe7\x9f\xb3_\xe8\x89\xb2"), "color \xe7\x9f\xb3");
    EXPECT_EQ(kindOf("\xe7\x9f\xb3_\xe9\xab\x98\xe3\x81\x95"), "height \xe7\x9f\xb3");
    EXPECT_EQ(kindOf("\xe7\x9f\xb3_\xe6\xb3\x95\xe7\xb7\x9a"), "normal \xe7\x9f\xb3");
    EXPECT_EQ(guessFromName("Mauer_Tiefe").convention, Convention::Depth);
    EXPECT_EQ(guessFromName("mur_profondeur").convention, Convention::Depth);
}

TEST(TextureSetNames, AnImageWithoutKindIsTheColourBesideANormalMapOfItsName)
{
    const std::vector<std::filesystem::path> files = {"/x/wall.png", "/x/wall_n.png", "/x/other.png"};
    const std::vector<FileGroup> groups = groupFiles(files);
    ASSERT_FALSE(groups.empty());
    EXPECT_TRUE(groups[0].holds(MapKind::Normal));
    EXPECT_TRUE(groups[0].contains("/x/wall.png"));
    EXPECT_FALSE(groups[0].contains("/x/other.png"));
    EXPECT_EQ(groupFiles(std::vector<std::filesystem::path>{"/x/wall_n.png", "/x/other.png"})[0].kinds(), 0); // a letter alone says nothing
    EXPECT_EQ(groupFiles(std::vector<std::filesystem::path>{"/x/n.png", "/x/1x5.png"})[0].kinds(), 0); // these share no name
}

TEST(TextureSetNames, UdimTilesAreNumbersFrom1001)
{
    EXPECT_EQ(udimTile("wall_height.1001")->number, 1001);
    EXPECT_EQ(udimTile("wall_height_1012")->base, "wall_height_");
    EXPECT_EQ(udimTile("wall_1002_height")->base, udimTile("wall_1001_height")->base);
    for (const char* name : {"wall_height_1k", "wall_2048", "wall_1000", "wall1001", "1001", "wall_11001", "wall_height"})
        EXPECT_FALSE(udimTile(name)) << name;
}

// By their names alone; UDIM tiles are one set, and folders below count where no images lie in the folder itself.
TEST(TextureSetNames, TheSetsOfAFolderAreListed)
{
    const fs::path folder = fs::path(testing::TempDir()) / "sets_of_a_folder";
    fs::remove_all(folder);
    const auto write = [&](const char* name) {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name) << name;
    };
    for (const char* name : {"two/wall_height.png", "two/wall_color.png", "two/roof_height.png", "two/notes.txt", "two/photo.png",
             "tiles/a_color.1001.png", "tiles/a_color.1002.png", "tiles/a_height.1001.png", "tiles/a_height.1002.png", "none/readme.txt"})
        write(name);
    const auto titles = [&](const fs::path& which) {
        std::string text;
        for (const SetInFolder& set : setsIn(which))
            text += (text.empty() ? "" : " ") + set.title;
        return text;
    };
    EXPECT_EQ(titles(folder / "two"), "wall roof");
    EXPECT_EQ(setsIn(folder / "two")[1].source, folder / "two/roof_height.png");
    EXPECT_EQ(setsIn(folder / "tiles").size(), 1u);
    EXPECT_EQ(titles(folder), "tiles two");
    EXPECT_EQ(setsIn(folder)[1].source, folder / "two");
    EXPECT_TRUE(setsIn(folder / "none").empty());
    EXPECT_TRUE(setsIn(folder / "not-there").empty());
    fs::remove_all(folder);
}
