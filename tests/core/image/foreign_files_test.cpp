// Files of other kinds are named with a cure, and names that look alike are found.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gltf/pictures.h"
#include "core/ground/foreign_file.h"
#include "core/ground/name_forms.h"
#include "core/mesh/mesh.h"
#include "core/scene/source.h"
#include "tests/core/image/image_support.h"
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;

namespace {
struct Foreign {
    const char* name;
    std::string bytes;
    const char *kind, *cure; // words that the message holds
};
const std::vector<Foreign> kCases = {
    {"a.fbx", "Kaydara FBX Binary  ", "FBX", "glTF, OBJ, PLY or STL"},
    {"a.usdz", "PK\3\4", "USD", "glTF, OBJ, PLY or STL"},
    {"a.usda", "#usda 1.0", "USD", "glTF, OBJ, PLY or STL"},
    {"a.blend", "BLENDER-v300", "Blender", "glTF, OBJ, PLY or STL"},
    {"a.3mf", "PK\3\4", "3MF", "glTF, OBJ, PLY or STL"},
    {"a.dae", "<?xml version=\"1.0\"?>", "COLLADA", "glTF, OBJ, PLY or STL"},
    {"scene", "Kaydara FBX Binary  ", "FBX", "glTF, OBJ, PLY or STL"}, // by its bytes
    {"a.zip", "PK\3\4", "archive", "Unpack"},
    {"textures.dat", "7z\xbc\xaf\x27\x1c", "archive", "Unpack"},
    {"a.tar.gz", "\x1f\x8b", "archive", "Unpack"},
    {"a.sbsar", "7z\xbc\xaf", "Substance", "PNG, TIFF or EXR"},
    {"a.mtlx", "<materialx/>", "MaterialX", "PNG, TIFF or EXR"},
    {"height.png", "version https://git-lfs.github.com/spec/v1\n", "Git LFS pointer", "git lfs pull"},
    {"dem.hdr", "ENVI\ndescription = {dem.bil}", "ENVI", "GeoTIFF"},
    {"dem2.hdr", "BYTEORDER I\nLAYOUT BIL\n", "elevation", "GeoTIFF"},
    {"dem.asc", "ncols 64\nnrows 64\n", "ASCII grid", "GeoTIFF"},
    {"dem.bil", "\1\2\3\4", "elevation", "GeoTIFF"},
    {"N46E007.hgt", "\1\2\3\4", "SRTM", "GeoTIFF"},
    {"terrain.r16", "\1\2\3\4", "raw height field", "16-bit PNG"},
    {"photo.png", "<!DOCTYPE html><html>", "web page", "Download"},
    {"a.ktx2", "\xabKTX 20", "KTX2", "PNG"},
    {"photo.heic", std::string("\0\0\0\x18", 4) + "ftypheic", "HEIC", "PNG"},
};
} // namespace

TEST(ForeignFiles, AreNamedWithACureWhereverTheyAreGiven)
{
    for (const Foreign& one : kCases) {
        const TemporaryFolder folder;
        writeAll(folder / one.name, one.bytes);
        const std::string file = (folder / one.name).string();
        const auto opened = openSource(file, State());
        const auto picture = readImage(file);
        const auto mesh = openMesh(file);
        ASSERT_FALSE(opened || picture || mesh) << one.name;
        for (const std::string& text : {message(opened.error()), message(picture.error()), message(mesh.error())}) {
            EXPECT_NE(text.find(one.kind), std::string::npos) << text;
            EXPECT_NE(text.find(one.cure), std::string::npos) << text;
            EXPECT_EQ(text.find("damaged"), std::string::npos) << text;
        }
        const auto inFolder = openSource(folder.path().string(), State());
        ASSERT_FALSE(inFolder);
        EXPECT_NE(message(inFolder.error()).find(one.kind), std::string::npos) << message(inFolder.error());
    }
}

TEST(ForeignFiles, ABufferThatWasNotFetchedIsTold)
{
    const TemporaryFolder folder;
    writeAll(folder / "a.bin", "version https://git-lfs.github.com/spec/v1\n");
    writeAll(folder / "a.gltf",
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"a.bin"}],"meshes":[{"primitives":[{"attributes":{}}]}]})");
    const auto mesh = openMesh((folder / "a.gltf").string());
    ASSERT_FALSE(mesh);
    EXPECT_NE(message(mesh.error()).find("git lfs pull"), std::string::npos) << message(mesh.error());
}

TEST(ForeignFiles, WhatIsReadIsNotForeign)
{
    const TemporaryFolder folder;
    for (const char* name : {"h.png", "h.tif", "h.exr", "h.hdr", "h.tga", "h.bmp"}) {
        const bool isFloat = std::string(name).ends_with("exr") || std::string(name).ends_with("hdr");
        ASSERT_TRUE(writeImage(folder / name, noiseImage(8, 8, 3, isFloat ? PixelType::F32 : PixelType::U8)));
        EXPECT_FALSE(foreignFile(folder / name)) << name;
    }
    writeAll(folder / "h.pgm", "P5 2 2 255\nabcd");
    EXPECT_FALSE(foreignFile(folder / "h.pgm"));
    EXPECT_FALSE(foreignFile(folder / "none.fbx"));
    EXPECT_FALSE(foreignFile(folder.path()));
    // A header of raw data beside a set does not hide the set.
    ASSERT_TRUE(writeImage(folder / "wall_height.png", hillHeights(8, PixelType::U8)));
    for (const char* name : {"h.png", "h.tif", "h.exr", "h.hdr", "h.tga", "h.bmp", "h.pgm"})
        std::filesystem::remove(folder / name);
    writeAll(folder / "dem.hdr", "ENVI\n");
    const auto set = openTextureSet(folder.path());
    ASSERT_TRUE(set) << message(set.error());
    EXPECT_EQ(set->maps.size(), 1u);
    EXPECT_FALSE(tells(set->warnings, "map-broken"));
}

TEST(NameForms, NamesThatLookAlikeAreFound)
{
    const std::string nfc = "Gr\xc3\xb6\xc3\x9f"
                            "e.png",
                      nfd = "Gro\xcc\x88\xc3\x9f"
                            "e.png",
                      upper = "GR\xc3\x96SSE.PNG",
                      western = "Gr\xf6\xdf"
                                "e.png", // cp1252
        japanese = "\xe7\x9f\xb3.png", shiftJis = "\x90\xce.png"; // "stone"
    EXPECT_TRUE(looksAlike(nfc, nfd));
    EXPECT_TRUE(looksAlike(nfc, upper));
    EXPECT_TRUE(looksAlike(nfc, western));
    EXPECT_TRUE(looksAlike(western, nfd));
    EXPECT_TRUE(looksAlike(japanese, shiftJis));
    EXPECT_TRUE(looksAlike("my scan.png", "my_scan.png"));
    EXPECT_TRUE(looksAlike("my\xc2\xa0scan-2.png",
        "my scan\xe2\x80\x93"
        "2.png")); // a space that does not break, a longer dash
    EXPECT_FALSE(looksAlike(nfc, japanese));
    EXPECT_FALSE(looksAlike("a.png", "b.png"));
    for (const auto& [there, wanted] : {std::pair(nfc, nfd), std::pair(nfd, nfc), std::pair(nfc, western), std::pair(western, nfc),
             std::pair(upper, nfc), std::pair(japanese, shiftJis)}) {
        const TemporaryFolder folder;
        ASSERT_TRUE(writeImage(folder / "x.png", hillHeights(8, PixelType::U8)));
        std::filesystem::rename(folder / "x.png", folder / there);
        const auto found = findPicture({folder.path()}, wanted);
        ASSERT_TRUE(found) << wanted;
        EXPECT_EQ(found->string(), (folder / there).string());
        EXPECT_TRUE(pictureMayExist(folder / wanted));
        EXPECT_TRUE(readImage(folder / wanted));
        const auto opened = openSource((folder / wanted).string(), State());
        EXPECT_TRUE(opened) << message(opened.error());
    }
}
