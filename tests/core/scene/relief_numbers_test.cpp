// The relief that an export wrote into a glTF file or a folder is read again, as far as it makes sense.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/ground/file.h"
#include "core/image/files/image_file.h"
#include "core/scene/relief_numbers.h"
#include "core/scene/resources.h"
#include "core/scene/source.h"
#include "tests/core/mesh/mesh_support.h"
#include <nlohmann/json.hpp>

using namespace relievo;
using nlohmann::json;

namespace {
State sample()
{
    State state = openSource("sample:hammered@64", State())->state;
    state.mesh = "box";
    return state;
}

// The State that the glTF export of `state` opens as.
Expected<Opened> exportedAndOpened(const Scratch& scratch, const State& state)
{
    const Expected<Resources> resources = loadResources(state, {}, {});
    EXPECT_TRUE(findExport("gltf")->run({state, *resources, scratch.path / "a.glb", 0, {}}));
    return openSource((scratch.path / "a.glb").string(), State());
}

// The same with members of the extension put in or replaced.
Expected<Opened> openedWith(const Scratch& scratch, const json& members)
{
    EXPECT_TRUE(exportedAndOpened(scratch, sample()));
    const std::string file = *readText(scratch.path / "a.glb");
    std::uint32_t length = 0;
    std::memcpy(&length, file.data() + 12, 4);
    json document = json::parse(file.substr(20, length));
    document["materials"][0]["extensions"]["RELIEVO_materials_relief"].update(members);
    document["buffers"][0]["uri"] = "a.bin";
    scratch.write("a.bin", file.substr(28 + length));
    return openSource(scratch.write("a.gltf", document.dump()), State());
}
} // namespace

TEST(GltfRelief, IsReadAsItWasWritten)
{
    const Scratch scratch;
    State state = sample();
    Parameters& p = state.parameters;
    p.depth = 0.05f, p.midlevel = 0.5f, p.tiling = 2.f, p.leapSteps = 20, p.refineSteps = 5, p.lastBracket = true;
    state.panes[0].technique = "cone-relaxed";
    const Expected<Opened> again = exportedAndOpened(scratch, state);
    ASSERT_TRUE(again) << message(again.error());
    EXPECT_EQ(again->state.panes[0].technique, "cone-relaxed");
    const Parameters& q = again->state.parameters;
    EXPECT_NEAR(q.depth, 0.05f, 1e-6f); // of a tile, which is the mesh's UV unit now
    EXPECT_EQ(q.midlevel, 0.5f);
    EXPECT_EQ(q.leapSteps, 20);
    EXPECT_EQ(q.refineSteps, 5);
    EXPECT_TRUE(q.lastBracket);
    const Expected<Resources> here = loadResources(state, {}, {}), there = loadResources(again->state, again->images, {});
    ASSERT_TRUE(there) << message(there.error());
    ASSERT_TRUE(there->material->height);
    const auto before = here->material->height->texels(), after = there->material->height->texels();
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        ASSERT_NEAR(before[i], after[i], 0.5f / 255.f + 1e-5f); // 8 bits inside the file
}

TEST(GltfFactors, AreReadAsTheyWereWritten)
{
    const Scratch scratch;
    State state = sample();
    Parameters& p = state.parameters;
    p.tint = {0.25f, 0.5f, 1.f}, p.roughness = 0.46f, p.metallic = 0.75f, p.normalStrength = 1.5f;
    const Expected<Opened> again = exportedAndOpened(scratch, state);
    ASSERT_TRUE(again) << message(again.error());
    const Parameters& q = again->state.parameters;
    EXPECT_EQ(q.tint, p.tint);
    EXPECT_FLOAT_EQ(q.roughness, 0.46f);
    EXPECT_FLOAT_EQ(q.metallic, 0.75f); // the sample has a metallic map
    EXPECT_FLOAT_EQ(q.normalStrength, 1.5f);
    EXPECT_TRUE(again->bringsValues);
}

// Without a colour map the factor is the colour; nonsense is clamped.
TEST(GltfFactors, OfAMaterialWithoutAColorMap)
{
    State state;
    MeshFactors factors;
    factors.color = {0.1f, 0.2f, 9.f}, factors.roughness = -1.f, factors.normal = std::numeric_limits<float>::quiet_NaN();
    takeFactors(state, factors, {});
    EXPECT_FLOAT_EQ(state.parameters.tint.x, 0.25f);
    EXPECT_FLOAT_EQ(state.parameters.tint.y, 0.5f);
    EXPECT_FLOAT_EQ(state.parameters.tint.z, 1.f);
    EXPECT_EQ(state.parameters.roughness, 0.f);
    EXPECT_EQ(state.parameters.normalStrength, Parameters().normalStrength);
    EXPECT_EQ(state.parameters.emission, Parameters().emission);
}

TEST(GltfRelief, NonsenseIsLeftOut)
{
    const Scratch scratch;
    const Parameters plain;
    auto read
        = openedWith(scratch, {{"depth", 1e9}, {"midlevel", -3}, {"technique", "reference"}, {"maxSteps", 1e12}, {"minSteps", "many"}});
    ASSERT_TRUE(read) << message(read.error());
    EXPECT_EQ(read->state.parameters.depth, findParameter("depth")->max);
    EXPECT_EQ(read->state.parameters.midlevel, 0.f);
    EXPECT_EQ(read->state.parameters.maxSteps, 512);
    EXPECT_EQ(read->state.parameters.minSteps, plain.minSteps);
    EXPECT_EQ(read->state.panes[0].technique, Pane().technique); // "reference" draws no pictures
    read = openedWith(scratch, {{"depth", "deep"}});
    ASSERT_TRUE(read) << message(read.error());
    EXPECT_EQ(read->state.parameters.depth, plain.depth);
    read = openedWith(scratch, {{"heightTexture", {{"index", 77}}}, {"depth", 0.3}});
    ASSERT_TRUE(read) << message(read.error());
    EXPECT_EQ(read->state.parameters.depth, plain.depth);
    EXPECT_EQ(read->state.panes[0].technique, "bump");
}

namespace {
// The folder that the texture export of `state` writes.
std::filesystem::path exportedFolder(const Scratch& scratch, const State& state)
{
    const std::filesystem::path folder = scratch.path / "maps";
    EXPECT_TRUE(findExport("textures")->run({state, *loadResources(state, {}, {}), folder, 0, {}}));
    return folder;
}

bool told(const Opened& opened, std::string_view code)
{
    return std::ranges::count(opened.warnings, code, &Warning::code) > 0;
}
} // namespace

TEST(ReliefJson, IsReadAsItWasWritten)
{
    const Scratch scratch;
    State state = sample();
    Parameters& p = state.parameters;
    p.depth = 0.037f, p.midlevel = 0.25f, p.tiling = 3.f, p.offsetU = 0.5f, p.offsetV = -0.25f, p.rotation = 30.f, p.wrap = Wrap::Clamp;
    p.normalStrength = 1.5f;
    state.panes[0].technique = "pom";
    const Expected<Opened> again = openSource(exportedFolder(scratch, state).string(), State());
    ASSERT_TRUE(again) << message(again.error());
    Parameters expected;
    expected.depth = p.depth, expected.midlevel = p.midlevel, expected.tiling = p.tiling, expected.offsetU = p.offsetU;
    expected.offsetV = p.offsetV, expected.rotation = p.rotation, expected.wrap = p.wrap, expected.normalStrength = p.normalStrength;
    EXPECT_EQ(again->state.parameters, expected);
    EXPECT_EQ(again->state.panes[0].technique, "pom");
    EXPECT_TRUE(told(*again, "relief-json"));
}

// The export knows which way its height map is meant, also where the pixels say otherwise.
TEST(ReliefJson, SaysWhichWayMapsAreMeant)
{
    const Scratch scratch;
    const std::filesystem::path folder = exportedFolder(scratch, sample());
    const std::filesystem::path file = openSource(folder.string(), State())->state.slots[std::size_t(MapKind::Height)].file;
    const Expected<ImageRead> read = readImage(file);
    ASSERT_TRUE(read) << message(read.error());
    Image height = read->image;
    for (std::byte& byte : height.data)
        byte = ~byte;
    ASSERT_TRUE(writeImage(file, height, false));
    const auto opened = openSource(folder.string(), State());
    ASSERT_TRUE(opened) << message(opened.error());
    EXPECT_FALSE(opened->state.slots[std::size_t(MapKind::Height)].invert);
    EXPECT_FALSE(told(*opened, "depth-map"));
    std::filesystem::remove(folder / "relief.json");
    EXPECT_TRUE(openSource(folder.string(), State())->state.slots[std::size_t(MapKind::Height)].invert);
}

TEST(ReliefJson, NonsenseIsLeftOut)
{
    const Scratch scratch;
    const std::filesystem::path folder = exportedFolder(scratch, sample());
    const auto parametersWith = [&](const std::string& text) {
        scratch.write("maps/relief.json", text);
        const auto opened = openSource(folder.string(), State());
        EXPECT_TRUE(opened) << text;
        return opened->state.parameters;
    };
    for (const char* text :
        {"", "{", "[]", "7", "{\"depthInTiles\": 0.3}", "{\"technique\": \"pom\"}", "{\"depthInTiles\": \"x\", \"technique\": \"pom\"}"})
        EXPECT_EQ(parametersWith(text), Parameters()) << text;
    const Parameters taken = parametersWith(
        "{\"depthInTiles\": 1e40, \"technique\": \"magic\", \"offset\": [1], \"tiling\": null, \"maps\": [3, {\"kind\": 4}]}");
    Parameters expected;
    expected.depth = findParameter("depth")->max;
    EXPECT_EQ(taken, expected);
}
