// Targets by text: every row's text fits its facts, the physical depth arrives in each engine's number, and bad targets are refused by
// line.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/engines/target_text.h"
#include "core/exporters/engines/template_values.h"
#include "core/exporters/exporters.h"
#include "core/ground/file.h"
#include "core/image/files/image_file.h"
#include "core/scene/source.h"
#include "core/state/techniques.h"
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <unistd.h>

using namespace relievo;
namespace fs = std::filesystem;

namespace {
class Engines : public testing::Test {
protected:
    void SetUp() override
    {
        std::string name = (fs::temp_directory_path() / "relievo-engines-XXXXXX").string();
        m_folder = mkdtemp(name.data());
    }
    void TearDown() override { fs::remove_all(m_folder); }

    // A material of heights from `low` to `high` and, if wanted, all other maps, on the box (one tile is one metre).
    void make(float low, float high, bool maps = false, int bits = 16)
    {
        std::vector<float> heights(64 * 64);
        for (std::size_t i = 0; i < heights.size(); ++i)
            heights[i] = low + (high - low) * float(i) / float(heights.size() - 1);
        auto material = std::make_shared<Material>();
        material->height = HeightField(64, 64, heights, Wrap::Repeat, bits);
        for (const MapKindRow& row : kMapKinds) {
            if (!maps || row.kind == MapKind::Height || row.kind == MapKind::Gloss)
                continue;
            auto image = std::make_shared<Image>(Image{64, 64, row.channels, PixelType::U8, 8, false, {}});
            image->data.assign(std::size_t(64 * 64 * row.channels), std::byte(200));
            material->maps[std::size_t(row.kind)] = image;
        }
        m_state.mesh = "box";
        m_resources = *loadResources(m_state, {}, {});
        m_resources.material = material;
    }
    ExportJob job(const fs::path& out) const { return {m_state, m_resources, out, 0, {}}; }
    std::string textOfFile(const fs::path& file) const { return readText(file).value_or(""); }
    // What the file says after `property`.
    static float numberAfter(const std::string& text, const std::string& property)
    {
        std::smatch found;
        const std::regex pattern(property + R"([^-0-9\n]*(-?[0-9.]+))");
        return std::regex_search(text, found, pattern) ? std::stof(found[1]) : std::nanf("");
    }
    Expected<Exported> run(std::string_view key, const std::string& folder) const { return findExport(key)->run(job(m_folder / folder)); }
    // A user's target.
    Expected<const ExportRow*> own(const std::string& name, const std::string& text)
    {
        std::ofstream(m_folder / name) << text;
        return ownTarget(m_folder / name);
    }

    fs::path m_folder;
    State m_state;
    Resources m_resources;
};

constexpr const char* kPacked = R"({"textures": [{"key": "height", "file": "{{name}}_h.png", "channels": ["height"], "bits": 16}]})";

TEST_F(Engines, TextsFitTheFactsOfTheirRows)
{
    for (const ExportRow& row : kExports) {
        if (row.code)
            continue;
        const TargetText& text = textOf(row);
        EXPECT_FALSE(text.textures.empty()) << row.key;
        bool reads = false;
        for (const PackedTexture& texture : text.textures)
            for (std::size_t c = 0; c < texture.channels.size(); ++c) {
                const PackedChannel& channel = texture.channels[c];
                if (channel.from == PackedChannel::From::Height) {
                    EXPECT_EQ(channel.inverted, row.engine.isDepth) << row.key;
                    reads
                        = reads || texture.channels.size() == 1 || c == std::size_t(row.engine.channel); // one channel is grey: all of them
                    EXPECT_GE(row.engine.bits, texture.bits) << row.key << " keeps fewer bits than are written";
                }
                if (channel.from == PackedChannel::From::Normal && channel.channel == 1) {
                    EXPECT_EQ(channel.inverted, row.engine.greenDown) << row.key;
                }
            }
        EXPECT_TRUE(reads) << row.key;
    }
}

TEST_F(Engines, EachWritesWhatItSaysWithAllMapsAndWithHeightsAlone)
{
    m_state.name = "Old \"wall\" \\ \xc3\xbc";
    for (const bool maps : {true, false}) {
        make(0.f, 1.f, maps);
        for (const ExportRow& row : kExports) {
            if (row.code)
                continue;
            const fs::path out = m_folder / (std::string(row.key) + (maps ? "_all" : "_one"));
            std::vector<fs::path> told = row.writes(job(out));
            const Expected<Exported> exported = row.run(job(out));
            ASSERT_TRUE(exported) << row.key << ": " << message(exported.error());
            EXPECT_EQ(told, exported->files) << row.key;
            std::size_t there = 0;
            for (const auto& entry : fs::recursive_directory_iterator(out))
                there += entry.is_regular_file() ? 1 : 0;
            EXPECT_EQ(there, exported->files.size()) << row.key;
            for (const fs::path& file : exported->files)
                if (file.extension() != ".png" && file.extension() != ".exr") {
                    const std::string text = textOfFile(file);
                    EXPECT_EQ(text.find("{{"), std::string::npos) << file;
                    EXPECT_EQ(text.find("nan"), std::string::npos) << file;
                }
        }
    }
    const std::string material = textOfFile(m_folder / "o3de_all" / "OldWallü.material");
    EXPECT_TRUE(nlohmann::json::parse(material, nullptr, false).is_object()) << material;
    EXPECT_NE(textOfFile(m_folder / "godot4_all" / "OldWallü.tres").find(R"(resource_name = "Old \"wall\" \\ ü")"), std::string::npos);
}

// D = depth x tile size; what each engine makes of its number is the right side, from its published formula.
TEST_F(Engines, TheDepthArrivesInEachEnginesNumber)
{
    make(0.f, 1.f);
    m_state.parameters.depth = 0.06f;
    m_state.parameters.midlevel = 0.75f;
    m_state.parameters.metresPerUV = 2.f;
    m_state.parameters.tiling = 4.f; // a tile of 0.5 m: D = 0.03 m
    m_state.name = "m";
    const struct {
        const char *key, *file, *property;
        float number;
    } wanted[] = {
        {"godot4", "m.tres", "heightmap_scale", 6.f}, // UV offset = number / 100, added after uv1_scale: in tiles
        {"godot3", "m.tres", "depth_scale", 0.06f}, {"unity-builtin", "m.mat", "_Parallax:", 0.06f},
        {"unity-urp", "m.mat", "_Parallax:", 0.06f}, {"unity-hdrp", "m.mat", "_HeightPoMAmplitude:", 3.f}, // cm
        {"unity-hdrp", "m.mat", "_HeightAmplitude:", 0.03f}, // m
        {"unity-hdrp", "m.mat", "_PPDPrimitiveLength:", 2.f}, // m
        {"unreal", "m.py", R"(number\()", 8.f}, // Min Steps comes first
        {"o3de", "m.material", "parallax.factor", 0.03f}, {"bevy", "m.rs", "parallax_depth_scale:", 0.06f},
        {"babylon", "m.mjs", "parallaxScaleBias =", 0.06f}, {"playcanvas", "m.mjs", "heightMapFactor =", 0.6f}, // 0.1 x factor in tiles
        {"playcanvas", "m.mjs", "heightMapBase =", 0.75f}, {"three", "m.mjs", "displacementScale =", 0.03f},
        {"three", "m.mjs", "displacementBias =", -0.0225f}, {"blender", "m.py", R"("Scale"\].default_value = )", 4.f}, // of the UVs
        {"blender", "m.py", R"(displace.inputs\["Scale"\].default_value =)", 0.03f},
        {"blender", "m.py", R"("Midlevel"\].default_value =)", 0.75f}, {"packed", "m_depth.txt", "Depth from black to white:", 30.f}, // mm
    };
    for (const auto& row : wanted) {
        const Expected<Exported> exported = run(row.key, row.key);
        ASSERT_TRUE(exported) << message(exported.error());
        EXPECT_NEAR(numberAfter(textOfFile(m_folder / row.key / row.file), row.property), row.number, 1e-5f)
            << row.key << ' ' << row.property;
    }
    const std::string unreal = textOfFile(m_folder / "unreal/m.py");
    EXPECT_NE(unreal.find("number(0.06, \"Height Ratio\""), std::string::npos);
    EXPECT_NE(unreal.find("number(0.75, \"Reference Plane\""), std::string::npos);
    ASSERT_TRUE(run("usd", "usd"));
    const std::string usd = textOfFile(m_folder / "usd/m.usda");
    EXPECT_NE(usd.find("inputs:scale = (0.03, 0.03, 0.03, 1)"), std::string::npos) << usd;
    EXPECT_NEAR(numberAfter(usd.substr(usd.find("Shader \"Height\"")), "inputs:bias = "), -0.0225f, 1e-6f);
}

TEST_F(Engines, HeightsUseTheirFullRangeAndTheRestGoesIntoTheNumbers)
{
    make(0.25f, 0.75f);
    m_state.name = "m";
    m_state.parameters.midlevel = 0.5f;
    ASSERT_TRUE(run("blender", "b"));
    const std::string text = textOfFile(m_folder / "b/m.py");
    EXPECT_NEAR(numberAfter(text, R"(displace.inputs\["Scale"\].default_value =)"), 0.04f, 1e-6f); // half of 0.08 m
    EXPECT_NEAR(numberAfter(text, R"("Midlevel"\].default_value =)"), 0.5f, 1e-6f);
    const Expected<ImageRead> height = readImage(m_folder / "b/m_height.png");
    ASSERT_TRUE(height);
    EXPECT_EQ(height->image.value(0, 0, 0), 0.f);
    EXPECT_EQ(height->image.value(63, 63, 0), 1.f);

    ExportJob plain = job(m_folder / "plain");
    plain.cures = {Cure::Normals};
    ASSERT_TRUE(findExport("blender")->run(plain));
    EXPECT_NEAR(numberAfter(textOfFile(m_folder / "plain/m.py"), R"(displace.inputs\["Scale"\].default_value =)"), 0.08f, 1e-6f);
    EXPECT_NEAR(readImage(m_folder / "plain/m_height.png")->image.value(63, 63, 0), 0.75f, 1e-4f);
}

// What an exact search leaps by must hold for the very heights that it reads: those of the smaller picture.
TEST_F(Engines, BoundsAreThoseOfTheHeightsBesideThem)
{
    make(0.25f, 0.75f);
    m_state.name = "m";
    m_state.panes.front().technique = "cell-cone";
    std::vector<float> rough(64 * 64);
    for (std::size_t i = 0; i < rough.size(); ++i)
        rough[i] = 0.1f + 0.7f * float((i * 7919u) % 1021u) / 1021.f;
    auto material = std::make_shared<Material>();
    material->height = HeightField(64, 64, rough, Wrap::Repeat, 16);
    m_resources.material = material;
    ExportJob small = job(m_folder / "small");
    small.size = 32;
    ASSERT_TRUE(findExport("godot4-shader")->run(small));

    // The heights that were written, taken as they are, have the same map.
    const Image bytes = readImage(m_folder / "small/m_height_bytes.png")->image;
    ASSERT_EQ(bytes.width, 32);
    std::vector<float> written;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            written.push_back((std::round(bytes.value(x, y, 0) * 255.f) * 256.f + std::round(bytes.value(x, y, 1) * 255.f)) / 65535.f);
    EXPECT_EQ(*std::ranges::min_element(written), 0.f);
    EXPECT_EQ(*std::ranges::max_element(written), 1.f);
    material = std::make_shared<Material>();
    material->height = HeightField(32, 32, written, Wrap::Repeat, 16);
    m_resources.material = material;
    ASSERT_TRUE(run("godot4-shader", "whole"));
    for (const char* file : {"m_bound_high.png", "m_bound_low.png", "m_height_bytes.png"}) {
        const Image one = readImage(m_folder / "small" / file)->image, other = readImage(m_folder / "whole" / file)->image;
        EXPECT_EQ(one.width, other.width) << file;
        EXPECT_EQ(one.data, other.data) << file;
    }
}

// The technique is complete between its marks, under the names of the GLSL, and nothing of the shading stands there.
TEST_F(Engines, UnrealsNodeHasNoStaticMembers)
{
    make(0.f, 1.f);
    for (const char* technique : {"relief", "as-bevy", "as-o3de", "cell-cone"}) {
        m_state.panes.front().technique = technique;
        const auto exported = run("unreal", std::string("unreal_") + technique);
        ASSERT_TRUE(exported) << message(exported.error());
        for (const fs::path& file : exported->files)
            if (file.extension() == ".py") {
                EXPECT_EQ(textOfFile(file).find("static "), std::string::npos) << technique;
                EXPECT_NE(textOfFile(file).find("struct Relief"), std::string::npos) << technique;
            }
    }
}

TEST_F(Engines, HlslAndMetalKeepTheTechniqueTogether)
{
    make(0.f, 1.f, true);
    for (const TechniqueRow& technique : kTechniques) {
        if (technique.file.empty())
            continue;
        m_state.panes.front().technique = technique.key;
        for (const auto& [key, file, uniform] :
            {std::tuple("hlsl", "relief.hlsl", "u_reliefDepth"), std::tuple("msl", "relief.metal", "u.reliefDepth")}) {
            const Expected<Exported> exported = run(key, key);
            ASSERT_TRUE(exported) << technique.key << ": " << message(exported.error());
            const std::string text = textOfFile(m_folder / key / file);
            const std::size_t from = text.find("// >>> technique\n"), to = text.find("// <<< technique\n");
            ASSERT_LT(from, to) << technique.key;
            const std::string search = text.substr(from, to - from), rest = text.substr(0, from) + text.substr(to);
            for (const char* part : {"Hit trace(", "struct Ray", "struct Hit"}) {
                EXPECT_NE(search.find(part), std::string::npos) << technique.key << ' ' << key << ' ' << part;
                EXPECT_EQ(rest.find(part), std::string::npos) << technique.key << ' ' << key << ' ' << part;
            }
            EXPECT_EQ(search.find("shade("), std::string::npos) << technique.key;
            EXPECT_NE(rest.find(uniform), std::string::npos) << technique.key;
            EXPECT_NE(rest.find("float reliefDepth; // 0.08 m"), std::string::npos) << technique.key;
            EXPECT_FALSE(std::regex_search(text, std::regex(R"(\b_m[0-9]+\b)"))) << technique.key << " has members without names";
            EXPECT_NE(text.find(technique.needsHeights() ? "heightMap" : "colorMap"), std::string::npos) << technique.key;
        }
    }
}

TEST_F(Engines, LayersThatTheEnginesMaterialLacksAreTold)
{
    make(0.f, 1.f, true);
    const auto told = [this](const char* key) {
        const Expected<Exported> exported = run(key, key);
        EXPECT_TRUE(exported) << message(exported.error());
        return exported && std::ranges::count(exported->warnings, "layers-left-out", &Warning::code) > 0;
    };
    EXPECT_FALSE(told("godot4"));
    m_state.parameters.anisotropyStrength = 0.5f;
    EXPECT_TRUE(told("godot4"));
    EXPECT_FALSE(told("glsl")); // its shader has them
    m_state.parameters.shading = Shading::BlinnPhong;
    EXPECT_FALSE(told("godot4"));
}

// 16 is what WebGL2 and Direct3D's and OpenGL's smallest machines read in one program.
TEST_F(Engines, NoProgramReadsMoreThanSixteenTextures)
{
    make(0.f, 1.f, true);
    m_state.name = "m";
    const std::pair<const char*, const char*> programs[]
        = {{"glsl", "relief_410.frag"}, {"glsl", "relief_es300.frag"}, {"hlsl", "relief.hlsl"}, {"msl", "relief.metal"},
            {"godot4-shader", "m.gdshader"}, {"three", "m.mjs"}, {"babylon", "m.mjs"}, {"playcanvas", "m.mjs"}, {"unreal", "m.py"}};
    const std::regex texture(R"((^|\n|\\n) *(uniform (highp )?[iu]?sampler\w+ |Texture[23]D[^\n]*;)|\[\[texture\()");
    const auto texturesOf = [&](const std::string& text) {
        return std::distance(std::sregex_iterator(text.begin(), text.end(), texture), std::sregex_iterator());
    };
    std::set<std::pair<std::string_view, bool>> seen; // which textures a search reads follows from these
    for (const TechniqueRow& technique : kTechniques) {
        if (technique.file.empty() || !seen.emplace(technique.accelerationMap, technique.isExact).second)
            continue;
        m_state.panes.front().technique = technique.key;
        for (const Shading shading : {Shading::MetallicRoughness, Shading::BlinnPhong}) {
            m_state.parameters.shading = shading;
            for (const auto& [key, file] : programs) {
                if (technique.key == "sphere" && std::string_view(key) == "godot4-shader")
                    continue; // refuses volumes
                const Expected<Exported> exported = run(key, key);
                ASSERT_TRUE(exported) << key << ' ' << technique.key << ": " << message(exported.error());
                const std::string text = textOfFile(m_folder / key / file);
                EXPECT_LE(texturesOf(text), 16) << key << ' ' << technique.key;
                if (technique.needsHeights() && technique.key != "sphere") {
                    EXPECT_GE(texturesOf(text), 1) << key << ' ' << technique.key << ": none was counted";
                }
            }
            ExportJob page = job(m_folder / "page.html");
            ASSERT_TRUE(findExport("web")->run(page));
            const std::string text = textOfFile(page.out);
            for (std::size_t at = text.find("#version"); at != text.npos;) {
                const std::size_t next = text.find("#version", at + 1);
                EXPECT_LE(texturesOf(text.substr(at, next - at)), 16) << "web " << technique.key;
                at = next;
            }
        }
    }
}

// What the loaders of web engines read: bytes, and nothing that only this renderer provides. A technique that does not fit pictures is left
// out and told; the engine's own material is written all the same.
TEST_F(Engines, WebEnginesGetTheTechniqueToo)
{
    make(0.f, 1.f, true);
    m_state.name = "m";
    for (const char* key : {"three", "babylon", "playcanvas"}) {
        m_state.panes.front().technique = "cell-cone";
        ASSERT_TRUE(run(key, "fits"));
        const std::string text = textOfFile(m_folder / "fits/m.mjs");
        for (const char* part : {"function reliefMaterial", "uniform sampler2D boundLowMap", "reliefDepth: [\"float\",0.08]", "ormMap, uv"})
            EXPECT_NE(text.find(part), std::string::npos) << key << ' ' << part;
        for (const char* part : {"usampler2D cellMap", "boundScales", "sampler2D roughnessMap"})
            EXPECT_EQ(text.find(part), std::string::npos) << key << ' ' << part;
        m_state.panes.front().technique = "sphere";
        const Expected<Exported> plain = run(key, "plain");
        ASSERT_TRUE(plain) << message(plain.error());
        EXPECT_EQ(std::ranges::count(plain->warnings, "technique-left-out", &Warning::code), 1) << key;
        const std::string without = textOfFile(m_folder / "plain/m.mjs");
        EXPECT_NE(without.find("function material"), std::string::npos) << key;
        EXPECT_EQ(without.find("reliefMaterial("), std::string::npos) << key;
    }
}

TEST_F(Engines, WhatAnEngineGetsWrongIsTold)
{
    make(0.f, 1.f);
    m_state.parameters.depth = 0.2f; // Unity's number ends at 0.08
    m_state.parameters.rotation = 30.f;
    const Expected<Exported> unity = run("unity-urp", "u");
    ASSERT_TRUE(unity);
    const auto told = [](const Exported& exported, const std::string& code) {
        const auto found = std::ranges::find(exported.warnings, code, &Warning::code);
        return found == exported.warnings.end() ? std::string() : found->text;
    };
    EXPECT_NE(told(*unity, "depth-clamped").find("0.4 times as deep"), std::string::npos);
    EXPECT_NE(told(*unity, "zero-differs").find("40 mm higher"), std::string::npos)
        << told(*unity, "zero-differs"); // grey, not white, at 0.08 m
    EXPECT_FALSE(told(*unity, "rotation-lost").empty());
    EXPECT_FALSE(told(*unity, "banding").empty());
    EXPECT_FALSE(told(*unity, "engine-limits").empty());
    EXPECT_NE(told(*unity, "engine-drawing").find("at 70 degrees"), std::string::npos) << told(*unity, "engine-drawing");
    const Expected<Exported> blender = run("blender", "b");
    for (const char* code : {"depth-clamped", "zero-differs", "rotation-lost", "banding"})
        EXPECT_EQ(told(*blender, code), "") << code;
}

TEST_F(Engines, EightBitsAreDitheredToTheRightMean)
{
    make(0.f, 1.f);
    std::vector<float> flat(64 * 64, 0.5f + 0.3f / 255.f); // between two codes
    flat[0] = 0.f;
    flat[1] = 1.f;
    auto material = std::make_shared<Material>(*m_resources.material);
    material->height = HeightField(64, 64, flat, Wrap::Repeat, 16);
    m_resources.material = material;
    m_state.name = "m";
    ASSERT_TRUE(run("bevy", "dithered"));
    const Image image = readImage(m_folder / "dithered/m_depth.png")->image;
    EXPECT_EQ(image.type, PixelType::U8);
    double mean = 0;
    for (int y = 1; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            mean += 1. - double(image.value(x, y, 0));
    EXPECT_NEAR(mean / (63 * 64), 0.5 + 0.3 / 255, 0.05 / 255);
}

TEST_F(Engines, EqualPicturesAreEncodedOnce)
{
    make(0.f, 1.f, true);
    m_state.name = "m";
    WrittenPictures pictures;
    ExportJob first = job(m_folder / "one"), second = job(m_folder / "two");
    first.pictures = second.pictures = &pictures;
    ASSERT_TRUE(findExport("bevy")->run(first));
    const std::size_t written = pictures.size();
    fs::remove(m_folder / "one/m_orm.png");
    std::ofstream(m_folder / "one/m_orm.png") << "copied"; // what lies there is taken, it is not packed again
    ASSERT_TRUE(findExport("godot3")->run(second));
    EXPECT_EQ(pictures.size(), written); // all five are equal to Bevy's
    EXPECT_EQ(textOfFile(m_folder / "two/m_orm.png"), "copied");
}

TEST_F(Engines, AUsersTargetIsOneFile)
{
    make(0.f, 1.f, true);
    m_state.name = "m";
    const auto row = own("mine.tpl",
        R"({"label": "Mine", "help": "H.", "depth": {"property": "depth_cm", "of": "m", "factor": 100, "max": 5},
            "height": {"channel": "g", "zero": 0.5},
            "textures": [{"key": "packed", "file": "{{name}}_p.tga", "channels": ["ao", "height", "1.0", "cone_relaxed_g"]}]}
=== sub/{{name}}.txt
{{title}}: {{number}} {{packed.file}}
=== {{file}}.meta each texture
{{key}} {{#isHeight}}height{{/isHeight}}
)");
    ASSERT_TRUE(row) << message(row.error());
    EXPECT_EQ((*row)->key, "mine");
    EXPECT_EQ((*row)->label, "Mine");
    const Expected<Exported> exported = (*row)->run(job(m_folder / "out"));
    ASSERT_TRUE(exported) << message(exported.error());
    EXPECT_EQ(textOfFile(m_folder / "out/sub/m.txt"), "m: 5.0 m_p.tga\n"); // 8 cm wanted
    EXPECT_EQ(textOfFile(m_folder / "out/m_p.tga.meta"), "packed height\n");
    const Expected<ImageRead> image = readImage(m_folder / "out/m_p.tga");
    ASSERT_TRUE(image);
    EXPECT_EQ(image->image.channels, 4);
    EXPECT_EQ(image->image.value(63, 63, 1), 1.f);
    EXPECT_EQ(image->image.value(10, 10, 2), 1.f);
}

TEST_F(Engines, BadTargetsAreRefusedByNameAndLine)
{
    make(0.f, 1.f);
    const struct {
        std::string text, says;
    } bad[] = {
        {"{", "JSON"},
        {"[]", "object"},
        {R"({"textures": 3})", "textures"},
        {R"({"textures": [], "colour": 1})", "colour"},
        {R"({"textures": [{"key": "a", "file": "a.png", "channels": ["hight"]}]})", "hight"},
        {R"({"textures": [{"key": "a", "file": "a.psd", "channels": ["height"]}]})", ".png"},
        {R"({"textures": [{"key": "A b", "file": "a.png", "channels": ["height"]}]})", "textures[0].key"},
        {R"({"textures": [{"key": "a", "file": "a.png", "channels": ["height"], "bits": 12}]})", "bits"},
        {R"({"textures": [{"key": "a", "file": "a.png", "channels": ["height"]}, {"key": "a", "file": "b.png", "channels": ["ao"]}]})",
            "twice"},
        {R"({"depth": {"of": "ell"}, "textures": []})", "depth.of"},
        {R"({"label": 3, "textures": []})", "JSON"},
        {std::string(kPacked) + "\n=== \nx\n", ":2"},
    };
    for (const auto& [text, says] : bad) {
        const auto row = own("bad.tpl", text);
        ASSERT_FALSE(row) << text;
        EXPECT_NE(message(row.error()).find(says), std::string::npos) << message(row.error());
        EXPECT_NE(message(row.error()).find("bad.tpl"), std::string::npos) << message(row.error());
    }
    const struct {
        std::string section, says;
    } refused[] = {
        {"=== a.txt\nfine\n{{depthFeet}}\n", "bad.tpl:4: {{depthFeet}}"},
        {"=== a.txt\n{{#repeat}}\n{{nosuch}}\n{{/repeat}}\n", ":4"},
        {"=== a.txt\n{{#repeat}}\n", "unclosed"},
        {"=== a.txt\n{{>other}}\n", ":3"},
        {"=== ../a.txt\nx\n", ":2"},
        {"=== /tmp/a.txt\nx\n", ":2"},
        {"=== a\\b.txt\nx\n", ":2"},
        {"=== {{nosuch}}.txt\nx\n", "nosuch"},
        {"=== {{name}}_h.png\nx\n", "twice"},
    };
    for (const auto& [section, says] : refused) {
        const auto row = own("bad.tpl", std::string(kPacked) + '\n' + section);
        ASSERT_TRUE(row) << message(row.error());
        const Expected<Exported> exported = (*row)->run(job(m_folder / "out"));
        ASSERT_FALSE(exported) << section;
        EXPECT_NE(message(exported.error()).find(says), std::string::npos) << message(exported.error());
        EXPECT_FALSE(fs::exists(m_folder / "out")) << section;
    }
}

TEST_F(Engines, APackingStandsInForATargetsTextures)
{
    make(0.f, 1.f);
    m_state.name = "m";
    const Expected<TargetText> packing
        = parseTarget(R"({"textures": [{"key": "height", "file": "{{name}}_disp.exr", "channels": ["height"]}]})", "p.json", false);
    ASSERT_TRUE(packing);
    ExportJob packed = job(m_folder / "g");
    packed.packing = &*packing;
    const Expected<Exported> exported = findExport("godot4")->run(packed);
    ASSERT_TRUE(exported) << message(exported.error());
    EXPECT_TRUE(fs::exists(m_folder / "g/m_disp.exr"));
    EXPECT_FALSE(fs::exists(m_folder / "g/m_height.png"));
    EXPECT_NE(textOfFile(m_folder / "g/m.tres").find("m_disp.exr"), std::string::npos);
}

TEST_F(Engines, CancellingLeavesNothing)
{
    make(0.f, 1.f, true);
    std::stop_source stop;
    ExportJob stopped = job(m_folder / "s");
    stopped.progress.stop = stop.get_token();
    stopped.progress.report = [&](float share) {
        if (share > 0.3f)
            stop.request_stop();
    };
    const Expected<Exported> exported = findExport("godot4")->run(stopped);
    ASSERT_FALSE(exported);
    EXPECT_TRUE(isCancelled(exported.error()));
    EXPECT_FALSE(fs::exists(m_folder / "s"));
}

TEST_F(Engines, TheManualsExampleWorksAndItsListOfValuesIsWhole)
{
    const std::string manual = textOfFile(fs::path(RELIEVO_SOURCE) / "resources/help/targets.md");
    const std::size_t from = manual.find("```\n") + 4;
    ASSERT_GT(from, 4u);
    make(0.f, 1.f, true);
    m_state.name = "m";
    const auto row = own("my_engine.tpl", manual.substr(from, manual.find("```\n", from) - from));
    ASSERT_TRUE(row) << message(row.error());
    const Expected<Exported> exported = (*row)->run(job(m_folder / "out"));
    ASSERT_TRUE(exported) << message(exported.error());
    EXPECT_EQ(textOfFile(m_folder / "out/m.txt"), "name = \"m\"\nrelief_cm = 4.0\ncolor = \"m_color.png\"\npacked = \"m_packed.png\"\n");
    EXPECT_EQ(textOfFile(m_folder / "out/m_packed.png.info"), "not compressed\n");

    const std::string values = manual.substr(manual.find("Values:"));
    const ExportJob whole = job(m_folder);
    const TemplateValues named = valuesOf(**row, whole, writtenHeights(whole, parametersOf(whole)), parametersOf(whole));
    const auto listed = [&](const std::string& name) { return std::regex_search(values, std::regex("[` ]" + name + "[` ]")); };
    for (const auto& [name, word] : named.words)
        EXPECT_TRUE(listed(name)) << name;
    for (const auto& [name, on] : named.switches)
        EXPECT_TRUE(listed(name)) << name;
}

} // namespace
