// Engines' materials are opened: height, scale, sense, zero and placement of what we export, and of files as the engines write them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/ground/file.h"
#include "core/scene/materials/material_file.h"
#include "core/scene/resources.h"
#include "core/scene/source.h"
#include "tests/core/fuzz/mutations.h"
#include "tests/core/fuzz_rounds.h"
#include "tests/core/image/image_support.h"
#include <algorithm>
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;
namespace fs = std::filesystem;

namespace {
// A material with every map in a folder, 30 mm deep, tiled, moved and turned.
struct Wall {
    TemporaryFolder folder;
    State state;
    Resources resources;

    explicit Wall(float rotation)
    {
        for (const char* name : {"a_height.png", "a_roughness.png", "a_metallic.png", "a_ao.png", "a_opacity.png"})
            EXPECT_TRUE(writeImage(folder / name, noiseImage(16, 16, 1, PixelType::U8)));
        for (const char* name : {"a_color.png", "a_normal.png", "a_emission.png"})
            EXPECT_TRUE(writeImage(folder / name, noiseImage(16, 16, 3, PixelType::U8)));
        for (const MapKind kind : {MapKind::Height, MapKind::Color, MapKind::Normal, MapKind::Roughness, MapKind::Metallic,
                 MapKind::AmbientOcclusion, MapKind::Emission, MapKind::Opacity})
            state.slots[std::size_t(kind)].file = (folder / ("a_" + std::string(row(kind).key) + ".png")).string();
        state.name = "Old wall";
        state.parameters.depth = 0.06f;
        state.parameters.tiling = 2.f;
        state.parameters.rotation = rotation;
        state.parameters.offsetU = 0.125f;
        state.parameters.offsetV = 0.3f;
        state.parameters.roughness = 0.75f;
        state.parameters.normalStrength = 0.5f;
        state.parameters.emission = 3.f;
        state.parameters.tint = {0.25f, 0.5f, 1.f};
        resources = *loadResources(state, {}, {});
    }
    // The file with this ending that a target writes.
    fs::path exported(std::string_view target, std::string_view ending)
    {
        const auto done = findExport(target)->run({state, resources, folder / std::string(target), 0, {}, {}, {}}); // no cures
        EXPECT_TRUE(done) << target << ": " << (done ? "" : message(done.error()));
        const auto file = done ? std::ranges::find_if(done->files, [&](const fs::path& f) { return f.string().ends_with(ending); })
                               : std::vector<fs::path>::const_iterator();
        return done && file != done->files.end() ? *file : fs::path();
    }
};

struct Opens {
    std::string_view target, ending;
    float midlevel;
    bool turns; // the turn arrives
};
constexpr Opens kOpens[] = {
    {"godot4", ".tres", 1.f, false},
    {"godot3", ".tres", 1.f, false},
    {"unity-builtin", ".mat", 0.5f, false},
    {"unity-urp", ".mat", 0.5f, false},
    {"unity-hdrp", ".mat", 1.f, false},
    {"o3de", ".material", 1.f, true},
    {"materialx", "1_38.mtlx", 1.f, true},
    {"materialx", "_without_displacement.mtlx", 1.f, true},
};

State opened(const fs::path& file)
{
    const auto read = openSource(file.string(), State());
    EXPECT_TRUE(read) << file << ": " << (read ? "" : message(read.error()));
    return read ? read->state : State();
}

// A picture beside the text.
State openedText(const TemporaryFolder& folder, const std::string& name, const std::string& text)
{
    for (const char* picture : {"h.png", "n.png", "c.png"})
        EXPECT_TRUE(writeImage(folder / picture, noiseImage(4, 4, 4, PixelType::U8)));
    writeAll(folder / name, text);
    return opened(folder / name);
}

const MapSlot& slot(const State& state, MapKind kind)
{
    return state.slots[std::size_t(kind)];
}

constexpr const char* kBabylon = R"({"name": "wall", "customType": "BABYLON.PBRMaterial", "albedo": [0.5, 0.5, 1],
    "albedoTexture": {"name": "c.png", "uScale": 3},
    "bumpTexture": {"name": "data:n", "url": "n.png", "level": 1, "uScale": 3, "vScale": 3, "uOffset": 0.25, "vOffset": -2.5},
    "useParallax": true, "useParallaxOcclusion": true, "parallaxScaleBias": 0.07, "roughness": 0.4, "metallic": 0})";
constexpr const char* kPlayCanvas = R"({"name": "wall", "type": "material", "data": {"diffuse": [1, 1, 1], "diffuseMap": "c.png",
    "normalMap": "n.png", "heightMap": "h.png", "heightMapFactor": 0.8, "heightMapChannel": "r", "heightMapBase": 1,
    "heightMapTiling": [2, 2], "heightMapOffset": [0.5, -1.25], "glossMap": 17, "metalness": 0}})";
constexpr const char* kO3de = R"({"materialType": "Materials/Types/StandardPBR.materialtype", "materialTypeVersion": 4, "properties": {
    "baseColor": {"textureMap": "c.png"}, "normal": {"textureMap": "n.png", "flipY": true},
    "parallax": {"textureMap": "h.png", "factor": 0.1}, "uv": {"tileU": 4.0}}})";
constexpr const char* kGodot = "[gd_resource type=\"StandardMaterial3D\" load_steps=3 format=3 uid=\"uid://x\"]\n\n"
                               "[ext_resource type=\"Texture2D\" uid=\"uid://y\" path=\"res://c.png\" id=\"1_a b\"]\n"
                               "[ext_resource type=\"Texture2D\" path=\"res://textures/h.png\" id=\"2_h\"]\n\n[resource]\n"
                               "albedo_texture = ExtResource(\"1_a b\")\nheightmap_enabled = true\nheightmap_flip_texture = true\n"
                               "heightmap_texture = ExtResource(\"2_h\")\n";
constexpr const char* kOldUnity
    = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!21 &2100000\nMaterial:\n  m_Name: wall\n"
      "  m_Shader: {fileID: 46, guid: 0000000000000000f000000000000000, type: 0}\n  m_SavedProperties:\n"
      "    m_TexEnvs:\n    - first:\n        name: _ParallaxMap\n      second:\n"
      "        m_Texture: {fileID: 2800000, guid: 0123456789abcdef0123456789abcdef, type: 3}\n"
      "        m_Scale: {x: 1, y: 1}\n    m_Floats:\n    - first:\n        name: _Parallax\n      second: 0.04\n";
} // namespace

TEST(MaterialFile, WhatIsExportedOpensWithItsDepthSenseZeroAndPlace)
{
    for (const float rotation : {0.f, 30.f}) {
        Wall wall(rotation);
        for (const Opens& row : kOpens) {
            if (rotation != 0.f && !row.turns)
                continue;
            const fs::path file = wall.exported(row.target, row.ending);
            const State state = opened(file);
            const Parameters &p = state.parameters, &was = wall.state.parameters;
            EXPECT_EQ(state.name.substr(0, 3), "Old") << file;
            EXPECT_NEAR(p.tiling, was.tiling, 1e-5f) << file;
            EXPECT_NEAR(p.offsetU, was.offsetU, 1e-4f) << file;
            EXPECT_NEAR(p.offsetV, was.offsetV, 1e-4f) << file;
            EXPECT_NEAR(p.rotation, rotation, 1e-4f) << file;
            EXPECT_NEAR(p.tint.x, was.tint.x, 1e-3f) << file;
            EXPECT_NEAR(p.tint.y, was.tint.y, 1e-3f) << file;
            const bool glossy = !slot(state, MapKind::Gloss).empty(); // its factor lies in the picture
            if (!glossy) {
                EXPECT_NEAR(p.roughness, was.roughness, 1e-4f) << file;
            }
            EXPECT_NEAR(p.normalStrength, was.normalStrength, 1e-4f) << file;
            EXPECT_NEAR(p.emission, row.target == "o3de" ? 1.f : was.emission, 1e-4f) << file; // its brightness is told in stops
            const bool relief = row.ending.find("without") == std::string_view::npos;
            EXPECT_EQ(!slot(state, MapKind::Height).empty(), relief) << file;
            EXPECT_EQ(state.panes.front().technique, relief ? Pane().technique : "bump") << file;
            for (const MapKind kind : {MapKind::Color, MapKind::Normal, MapKind::Metallic, MapKind::Emission})
                EXPECT_FALSE(slot(state, kind).empty()) << file << ' ' << relievo::row(kind).key;
            if (!relief)
                continue;
            EXPECT_NEAR(physicalDepth(p, 1.f), physicalDepth(was, 1.f), 1e-5f) << file;
            EXPECT_EQ(p.midlevel, row.midlevel) << file;
            const auto resources = loadResources(state, {}, {});
            ASSERT_TRUE(resources) << file << ": " << message(resources.error());
            for (int i = 0; i < 16; ++i)
                EXPECT_NEAR(resources->material->height->texel(i, 3), wall.resources.material->height->texel(i, 3), 1.f / 255) << file;
            EXPECT_EQ(int(slot(state, MapKind::Height).invert), int(row.target == "godot3")) << file;
        }
    }
}

TEST(MaterialFile, PicturesAreThoseOfTheirChannels)
{
    Wall wall(0.f);
    const State godot = opened(wall.exported("godot4", ".tres")), unity = opened(wall.exported("unity-hdrp", ".mat"));
    EXPECT_EQ(slot(godot, MapKind::AmbientOcclusion).channel, Channel::R);
    EXPECT_EQ(slot(godot, MapKind::Roughness).channel, Channel::G);
    EXPECT_EQ(slot(godot, MapKind::Metallic).channel, Channel::B);
    EXPECT_EQ(slot(godot, MapKind::Opacity).channel, Channel::A);
    EXPECT_EQ(slot(godot, MapKind::Opacity).file, slot(godot, MapKind::Color).file);
    EXPECT_EQ(slot(unity, MapKind::Metallic).channel, Channel::R);
    EXPECT_EQ(slot(unity, MapKind::AmbientOcclusion).channel, Channel::G);
    EXPECT_EQ(slot(unity, MapKind::Gloss).channel, Channel::A);
    EXPECT_TRUE(fs::exists(slot(unity, MapKind::Gloss).file));
}

TEST(MaterialFile, FilesOfBabylonAreRead)
{
    const TemporaryFolder folder;
    for (const bool scene : {false, true}) {
        const State state
            = openedText(folder, scene ? "a.babylon" : "a.json", scene ? "{\"materials\": [{}, " + std::string(kBabylon) + "]}" : kBabylon);
        EXPECT_EQ(state.name, "wall");
        EXPECT_EQ(slot(state, MapKind::Height), (MapSlot{(folder / "n.png").string(), Channel::A, false}));
        EXPECT_EQ(slot(state, MapKind::Normal).file, (folder / "n.png").string());
        EXPECT_FLOAT_EQ(state.parameters.depth, 0.07f);
        EXPECT_FLOAT_EQ(state.parameters.tiling, 3.f);
        EXPECT_NEAR(state.parameters.offsetV, 1 + 2.5 - 3, 1e-6);
        EXPECT_FLOAT_EQ(state.parameters.roughness, 0.4f);
        EXPECT_FLOAT_EQ(state.parameters.tint.x, 0.5f);
    }
}

TEST(MaterialFile, FilesOfPlayCanvasAreReadAndPicturesThatAreNotThereTold)
{
    const TemporaryFolder folder;
    const State state = openedText(folder, "a.json", kPlayCanvas);
    EXPECT_EQ(state.name, "wall");
    EXPECT_EQ(slot(state, MapKind::Height), (MapSlot{(folder / "h.png").string(), Channel::R, false}));
    EXPECT_FLOAT_EQ(state.parameters.depth, 0.08f);
    EXPECT_FLOAT_EQ(state.parameters.midlevel, 1.f);
    EXPECT_FLOAT_EQ(state.parameters.offsetU, 0.5f);
    EXPECT_FLOAT_EQ(state.parameters.offsetV, 0.25f);
    const auto read = readMaterialFile(folder / "a.json", State());
    ASSERT_TRUE(read);
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_EQ(read->warnings[0].code, "map-missing");
    EXPECT_NE(read->warnings[0].text.find("glossMap: 17"), std::string::npos) << read->warnings[0].text;
}

TEST(MaterialFile, MetresNeedAUnit)
{
    const TemporaryFolder folder;
    openedText(folder, "a.material", kO3de);
    for (const float unit : {0.f, 2.f}) {
        State base;
        base.parameters.metresPerUV = unit;
        const auto read = readMaterialFile(folder / "a.material", base);
        ASSERT_TRUE(read) << message(read.error());
        EXPECT_NEAR(physicalDepth(read->state.parameters, 1.f), 0.1f, 1e-6f);
        EXPECT_TRUE(slot(read->state, MapKind::Normal).invert); // flipY
        ASSERT_EQ(read->warnings.size(), 1u);
        EXPECT_EQ(read->warnings[0].code, "depth-in-metres");
    }
}

TEST(MaterialFile, WhatEnginesLeaveOutIsTheirDefault)
{
    const TemporaryFolder folder;
    const State state = openedText(folder, "a.tres", kGodot);
    EXPECT_EQ(slot(state, MapKind::Height), (MapSlot{(folder / "h.png").string(), Channel::R, true})); // flipped; by its name alone
    EXPECT_FLOAT_EQ(state.parameters.depth, 0.05f); // heightmap_scale 5
    EXPECT_FLOAT_EQ(state.parameters.metallic, 0.f);
}

TEST(MaterialFile, UnityFilesOfOldAndGuidsInTheProjectAreFound)
{
    const TemporaryFolder folder;
    fs::create_directories(folder / "Assets/Materials");
    fs::create_directories(folder / "Assets/Textures/Walls");
    ASSERT_TRUE(writeImage(folder / "Assets/Textures/Walls/h.png", noiseImage(4, 4, 1, PixelType::U8)));
    writeAll(folder / "Assets/Textures/Walls/h.png.meta", "fileFormatVersion: 2\nguid: 0123456789abcdef0123456789abcdef\n");
    writeAll(folder / "Assets/Materials/wall.mat", kOldUnity);
    const State state = opened(folder / "Assets/Materials/wall.mat");
    EXPECT_EQ(slot(state, MapKind::Height).file, (folder / "Assets/Textures/Walls/h.png").string());
    EXPECT_EQ(slot(state, MapKind::Height).channel, Channel::G);
    EXPECT_FLOAT_EQ(state.parameters.depth, 0.04f);
    EXPECT_FLOAT_EQ(state.parameters.midlevel, 0.5f);
}

TEST(MaterialFile, WhatIsNoneIsRefusedByNameAndCure)
{
    const TemporaryFolder folder;
    struct Bad {
        const char *name, *text, *told;
    };
    for (const Bad& bad : {Bad{"a.tres", "hello", "no text resource of Godot"}, Bad{"a.mat", "MATLAB 5.0", "no material of Unity"},
             Bad{"b.mat", "a: [b", "Force Text"}, Bad{"a.json", "{\"depth\": 1}", "no material of Babylon.js, PlayCanvas or O3DE"},
             Bad{"b.json", "{", "no JSON"}, Bad{"a.mtlx", "<a", "no MaterialX document"},
             Bad{"b.mtlx", "<materialx/>", "this material of MaterialX names no texture. Export its maps as PNG, TIFF or EXR"},
             Bad{"a.material", "{\"propertyValues\": {\"parallax.textureMap\": \"gone.png\"}}", "none of its textures was found"}}) {
        writeAll(folder / bad.name, bad.text);
        const auto read = openSource((folder / bad.name).string(), State());
        ASSERT_FALSE(read) << bad.name;
        EXPECT_NE(message(read.error()).find(bad.told), std::string::npos) << message(read.error());
        EXPECT_NE(message(read.error()).find(bad.name), std::string::npos) << message(read.error());
    }
}

TEST(MaterialFile, MutatedFilesAreSoundOrRefused)
{
    Wall wall(0.f);
    std::vector<std::pair<std::string, std::string>> seeds
        = {{"a.json", kBabylon}, {"a.json", kPlayCanvas}, {"a.material", kO3de}, {"a.tres", kGodot}, {"a.mat", kOldUnity}};
    for (const Opens& row : kOpens) {
        const fs::path file = wall.exported(row.target, row.ending);
        seeds.emplace_back("a" + file.extension().string(), readText(file).value_or(""));
    }
    const TemporaryFolder folder;
    ASSERT_TRUE(writeImage(folder / "h.png", noiseImage(4, 4, 4, PixelType::U8)));
    for (FuzzLoop loop(1000); loop.next();) {
        const auto& [name, text] = seeds[below(loop.random, seeds.size())];
        writeAll(folder / name, mutated(text, seeds[below(loop.random, seeds.size())].second, loop.random));
        const auto read = readMaterialFile(folder / name, State());
        if (!read) {
            EXPECT_TRUE(isPlain(message(read.error()))) << loop.round;
            continue;
        }
        for (const ParameterRow& row : kParameters)
            EXPECT_TRUE(inRange(row, get(read->state.parameters, row))) << loop.round << ' ' << row.key;
        for (const Warning& warning : read->warnings)
            EXPECT_TRUE(isPlain(warning.text)) << loop.round;
    }
}
