// What exports write: a well-formed .glb with the material's numbers, a folder of maps, and nothing half-written.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/exporters/map_images.h"
#include "core/ground/file.h"
#include "core/image/files/image_file.h"
#include "core/image/samples/samples.h"
#include "core/scene/source.h"
#include "core/state/state_json.h"
#include "tests/core/maps/refused_memory.h"
#include <cmath>
#include <cstring>
#include <fstream>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <unistd.h>

using namespace relievo;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {
class Export : public testing::Test {
protected:
    void SetUp() override
    {
        std::string name = (fs::temp_directory_path() / "relievo-export-XXXXXX").string();
        m_folder = mkdtemp(name.data());
        const Expected<Opened> opened = openSource("sample:hammered@64", State());
        ASSERT_TRUE(opened);
        m_state = opened->state;
        m_state.mesh = "box";
    }
    void TearDown() override { fs::remove_all(m_folder); }

    Expected<Exported> run(const char* target, const std::string& name, int size = 0)
    {
        const Expected<Resources> resources = loadResources(m_state, {}, {});
        EXPECT_TRUE(resources) << message(resources.error());
        return findExport(target)->run({m_state, *resources, m_folder / name, size, {}});
    }

    // The JSON of a .glb whose container is checked on the way.
    json glb(const std::string& name)
    {
        const std::string file = readText(m_folder / name).value_or("");
        std::uint32_t head[5] = {}, binary[2] = {};
        EXPECT_GE(file.size(), 28u);
        std::memcpy(head, file.data(), sizeof head);
        EXPECT_EQ(head[0], 0x46546C67u);
        EXPECT_EQ(head[2], file.size());
        EXPECT_EQ(head[3] % 4, 0u);
        std::memcpy(binary, file.data() + 20 + head[3], sizeof binary);
        EXPECT_EQ(28 + head[3] + binary[0], file.size());
        const json document = json::parse(file.substr(20, head[3]));
        EXPECT_EQ(document["buffers"][0]["byteLength"], binary[0]);
        for (const json& view : document["bufferViews"])
            EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(), binary[0]);
        m_binary = file.substr(28 + head[3]);
        return document;
    }

    fs::path m_folder;
    State m_state;
    std::string m_binary;
};

TEST_F(Export, GltfAsTextHoldsTheSameInTwoFiles)
{
    ASSERT_TRUE(run("gltf", "a.glb"));
    const Expected<Exported> exported = run("gltf", "b \xc3\xbc#.gltf");
    ASSERT_TRUE(exported) << message(exported.error());
    ASSERT_EQ(exported->files.size(), 3u);
    EXPECT_EQ(exported->files[1].filename(), "b \xc3\xbc#.bin");
    json binary = glb("a.glb"), text = json::parse(*readText(exported->files[0]));
    EXPECT_EQ(text["buffers"][0]["uri"], "b%20%C3%BC%23.bin");
    EXPECT_EQ(text["buffers"][0]["byteLength"], std::filesystem::file_size(exported->files[1]));
    text["buffers"][0].erase("uri");
    EXPECT_EQ(text, binary);
    const auto mesh = openMesh(exported->files[0].string());
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_TRUE(mesh->materials.front().relief);
    EXPECT_EQ(findExport("gltf")->takes("x.GLTF"), true);
    EXPECT_EQ(findExport("gltf")->takes("x.obj"), false);
}

TEST_F(Export, GlbHoldsMaterialAndRelief)
{
    m_state.parameters.midlevel = 0.5f;
    m_state.parameters.normalStrength = 1.5f;
    m_state.panes[0].technique = "parallax";
    const Expected<Exported> exported = run("gltf", "a.glb");
    ASSERT_TRUE(exported) << message(exported.error());
    ASSERT_EQ(exported->files.size(), 2u);
    EXPECT_EQ(exported->files[1].filename(), "a_height.png");
    EXPECT_FALSE(exported->warnings.empty());
    const Expected<ImageRead> height = readImage(exported->files[1]);
    ASSERT_TRUE(height);
    EXPECT_EQ(height->image.type, PixelType::U16);

    const json document = glb("a.glb");
    const json& material = document["materials"][0];
    EXPECT_EQ(material["name"], "Hammered metal");
    const json& relief = material["extensions"]["RELIEVO_materials_relief"];
    EXPECT_NEAR(relief["depth"].get<float>(), m_state.parameters.depth, 1e-6f); // one tile is one metre on the box
    EXPECT_EQ(relief["midlevel"], 0.5f);
    EXPECT_EQ(relief["metresPerUV"], 1.f);
    EXPECT_EQ(relief["technique"], "parallax");
    EXPECT_EQ(relief["maxSteps"], 32);
    EXPECT_EQ(
        document["images"][document["textures"][relief["heightTexture"]["index"].get<std::size_t>()]["source"].get<std::size_t>()]["name"],
        "height");
    EXPECT_EQ(material["extras"]["relievo"]["depth"], relief["depth"]);
    EXPECT_EQ(material["normalTexture"]["scale"], 1.5f);
    EXPECT_EQ(material["pbrMetallicRoughness"]["metallicFactor"], 1.f);
    EXPECT_TRUE(material["pbrMetallicRoughness"].contains("baseColorTexture"));
    EXPECT_FALSE(material.contains("occlusionTexture")); // the sample has none
    EXPECT_EQ(document["extensionsUsed"], json::array({"RELIEVO_materials_relief"}));
    EXPECT_FALSE(document.contains("extensionsRequired"));
    EXPECT_EQ(document["meshes"][0]["primitives"].size(), 1u);
}

// EXT_materials_bump: only when asked for, the same texture with the same transform, and heights again where it is all that is left.
TEST_F(Export, HeightsAreABumpMapTooWhenAskedFor)
{
    m_state.parameters.tiling = 2.f;
    const Expected<Resources> resources = loadResources(m_state, {}, {});
    ASSERT_TRUE(resources);
    ExportJob job{m_state, *resources, m_folder / "a.gltf", 0, {}};
    ASSERT_TRUE(findExport("gltf")->run(job));
    const json plain = json::parse(*readText(job.out));
    EXPECT_EQ(plain.dump().find("EXT_materials_bump"), std::string::npos) << "off by default";
    job.cures.insert(Cure::Bump);
    ASSERT_TRUE(findExport("gltf")->run(job));
    json document = json::parse(*readText(job.out));
    json& extensions = document["materials"][0]["extensions"];
    const json relief = extensions["RELIEVO_materials_relief"];
    EXPECT_EQ(extensions["EXT_materials_bump"], (json{{"bumpTexture", relief["heightTexture"]}, {"bumpFactor", relief["depth"]}}));
    EXPECT_EQ(std::ranges::count(document["extensionsUsed"], "EXT_materials_bump"), 1);
    EXPECT_EQ(document["images"], plain["images"]) << "no picture of its own";

    extensions.erase("RELIEVO_materials_relief");
    document["materials"][0].erase("normalTexture");
    ASSERT_TRUE(writeAtomically(job.out, document.dump()));
    const auto mesh = openMesh(job.out.string());
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_TRUE(mesh->warnings.empty());
    const auto again = openSource(job.out.string(), State());
    ASSERT_TRUE(again) << message(again.error());
    const MapSlot& height = again->state.slots[std::size_t(MapKind::Height)];
    const Expected<ImageRead> bump = readImage(height.file);
    ASSERT_TRUE(bump) << message(bump.error());
    EXPECT_EQ(bump->image.data, reduced(heightImage(*resources->material->height, 8), 0, Averaging::Plain).data);
}

TEST_F(Export, GlbReadsBackAsTheSameMesh)
{
    m_state.mesh = "torus";
    ASSERT_TRUE(run("gltf", "a.glb"));
    const Expected<Mesh> torus = openMesh("torus"), again = openMesh((m_folder / "a.glb").string());
    ASSERT_TRUE(again) << message(again.error());
    EXPECT_EQ(again->indices.size(), torus->indices.size());
    EXPECT_TRUE(again->fileHasTangents);
    EXPECT_TRUE(again->warnings.empty());
    EXPECT_NEAR(again->metresPerUV, torus->metresPerUV, 1e-5f);
    for (const Vertex& v : again->vertices)
        EXPECT_GT(glm::dot(glm::cross(v.normal, glm::vec3(v.tangent)) * v.tangent.w, -v.dPdv), 0.f);
}

TEST_F(Export, TilingBecomesATextureTransform)
{
    m_state.parameters.tiling = 2.f;
    m_state.parameters.rotation = 90.f;
    m_state.parameters.offsetU = 0.25f;
    ASSERT_TRUE(run("gltf", "a.glb"));
    const json document = glb("a.glb");
    const json& material = document["materials"][0];
    const json& transform = material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"];
    EXPECT_EQ(transform["scale"], json::array({2.f, 2.f}));
    EXPECT_EQ(transform["offset"], json::array({0.25f, 0.f}));
    EXPECT_NEAR(transform["rotation"].get<float>(), -1.5707963f, 1e-6f); // glTF turns the UVs, we turn the image
    EXPECT_EQ(material["extensions"]["RELIEVO_materials_relief"]["heightTexture"]["extensions"]["KHR_texture_transform"], transform);
    EXPECT_NEAR(material["extensions"]["RELIEVO_materials_relief"]["depth"].get<float>(), m_state.parameters.depth / 2.f, 1e-6f);
    EXPECT_EQ(document["extensionsUsed"].size(), 2u);
}

TEST_F(Export, WithoutHeightThereIsNoReliefAndItIsTold)
{
    m_state.slots[std::size_t(MapKind::Height)] = {};
    const Expected<Exported> exported = run("gltf", "a.glb");
    ASSERT_TRUE(exported);
    EXPECT_EQ(exported->files.size(), 1u);
    EXPECT_EQ(exported->warnings[0].code, "no-height");
    EXPECT_FALSE(glb("a.glb").contains("extensionsUsed"));
}

// The natural name of a set's own height map is that of the file beside the .glb.
TEST_F(Export, WhatWasOpenedIsNeverWrittenOver)
{
    ASSERT_TRUE(run("textures", "set"));
    const fs::path folder = m_folder / "set";
    fs::copy_file(folder / "HammeredMetal_Height.png", folder / "a_height.png");
    m_state.slots = {};
    m_state.slots[std::size_t(MapKind::Height)].file = (folder / "a_height.png").string();
    m_state.slots[std::size_t(MapKind::Color)].file = (folder / "HammeredMetal_Color.png").string();
    const std::string heights = *readText(folder / "a_height.png"), colors = *readText(folder / "HammeredMetal_Color.png");
    const Expected<Exported> exported = run("gltf", "set/a.glb", 16);
    ASSERT_TRUE(exported);
    EXPECT_EQ(exported->files[1].filename(), "a_glb_height.png");
    EXPECT_EQ(*readText(folder / "a_height.png"), heights);
    const Expected<Exported> refused = run("textures", "set", 16);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().where.find("HammeredMetal_Color.png"), std::string::npos);
    EXPECT_EQ(*readText(folder / "HammeredMetal_Color.png"), colors);
    m_state.mesh = (folder / "a.glb").string();
    EXPECT_FALSE(run("gltf", "set/a.glb"));
}

// However many names beside the .glb the material's own files have.
TEST_F(Export, TheHeightMapBesideTakesAFreeName)
{
    ASSERT_TRUE(run("textures", "set"));
    const fs::path folder = m_folder / "set";
    const std::pair<MapKind, const char*> taken[] = {{MapKind::Height, "a_height.png"}, {MapKind::Color, "a_glb_height.png"},
        {MapKind::Roughness, "a_relievo_height.png"}, {MapKind::Metallic, "a_glb2_height.png"}, {MapKind::Normal, "a_glb3_height.png"}};
    for (const auto& [kind, name] : taken) {
        fs::copy_file(folder / "HammeredMetal_Height.png", folder / name);
        m_state.slots[std::size_t(kind)].file = (folder / name).string();
    }
    const std::string before = *readText(folder / "a_height.png");
    const Expected<Exported> exported = run("gltf", "set/a.glb", 16);
    ASSERT_TRUE(exported) << message(exported.error());
    EXPECT_EQ(exported->files[1].filename(), "a_glb4_height.png");
    for (const auto& [kind, name] : taken)
        EXPECT_TRUE(*readText(folder / name) == before) << name;
}

TEST_F(Export, AMeshThatDoesNotMoveIsNotCopied)
{
    if (!test::kMemoryCanBeRefused)
        GTEST_SKIP() << "the sanitizer's own operator new refuses nothing";
    m_state.mesh = "torus";
    const Expected<Resources> resources = loadResources(m_state, {}, {});
    ASSERT_TRUE(resources);
    const std::size_t bytes = resources->mesh->vertices.size() * sizeof(Vertex);
    const test::RefusedMemory refused(bytes, bytes + 1);
    EXPECT_TRUE(findExport("gltf")->run({m_state, *resources, m_folder / "a.glb", 0, {}}));
}

TEST_F(Export, PlainPartsStayPlainAndWithoutColorIsGrey)
{
    m_state.mesh = "spheres";
    m_state.slots[std::size_t(MapKind::Color)] = {};
    m_state.parameters.tint = glm::vec3(1.f, 0.5f, 0.f);
    ASSERT_TRUE(run("gltf", "a.glb"));
    const json document = glb("a.glb");
    const Mesh mesh = *openMesh("spheres");
    const json& primitives = document["meshes"][0]["primitives"];
    ASSERT_EQ(primitives.size(), mesh.parts.size());
    const std::vector<char> plain = plainParts(mesh, "");
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
        EXPECT_EQ(primitives[i]["material"], int(plain[i])) << i;
    ASSERT_EQ(document["materials"].size(), 2u);
    EXPECT_FALSE(document["materials"][1].contains("normalTexture"));
    EXPECT_EQ(document["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"], json::array({0.4, 0.2, 0., 1.}));
    EXPECT_EQ(document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"], json::array({0.4, 0.2, 0., 1.}));
}

TEST_F(Export, BrightEmissionGoesIntoTheStrength)
{
    Image light{2, 1, 3, PixelType::F32, 32, true, std::vector<std::byte>(24)};
    const float values[] = {5.f, 2.5f, 0.f, 1.f, 0.f, 5.f};
    std::memcpy(light.data.data(), values, sizeof values);
    ASSERT_TRUE(writeImage(m_folder / "lamp.exr", light));
    m_state.slots[std::size_t(MapKind::Emission)].file = (m_folder / "lamp.exr").string();
    m_state.parameters.emission = 2.f;
    ASSERT_TRUE(run("gltf", "a.glb"));
    const json document = glb("a.glb");
    EXPECT_NEAR(document["materials"][0]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"].get<double>(), 10., 0.01);
    const auto clipped = [&] {
        const Expected<Exported> exported = run("textures", "t");
        EXPECT_TRUE(exported);
        return exported && std::ranges::count(exported->warnings, "emission-clipped", &Warning::code) > 0;
    };
    EXPECT_TRUE(clipped());
    for (int i = 0; i < 6; ++i)
        reinterpret_cast<float*>(light.data.data())[i] = 0.2f * values[i];
    ASSERT_TRUE(writeImage(m_folder / "lamp.exr", light));
    EXPECT_FALSE(clipped());
}

TEST_F(Export, LayersComeBackFromGltf)
{
    ASSERT_TRUE(run("gltf", "plain.glb"));
    for (const char* name :
        {"KHR_materials_clearcoat", "KHR_materials_sheen", "KHR_materials_transmission", "KHR_materials_ior", "KHR_materials_anisotropy"})
        EXPECT_FALSE(glb("plain.glb")["materials"][0]["extensions"].contains(name)) << name;
    Parameters& p = m_state.parameters;
    p.clearcoat = 0.75f, p.clearcoatRoughness = 0.25f, p.sheen = 0.5f, p.sheenColor = {1.f, 0.5f, 0.25f}, p.sheenRoughness = 0.625f;
    p.transmission = 0.375f, p.ior = 1.25f, p.anisotropyStrength = 0.5f, p.anisotropyRotation = 30.f;
    ASSERT_TRUE(run("gltf", "a.glb"));
    const Expected<Opened> again = openSource((m_folder / "a.glb").string(), State());
    ASSERT_TRUE(again) << message(again.error());
    for (const char* key :
        {"clearcoat", "clearcoatRoughness", "sheen", "sheenColor", "sheenRoughness", "transmission", "ior", "anisotropyStrength"})
        EXPECT_EQ(get(again->state.parameters, *findParameter(key)), get(p, *findParameter(key))) << key;
    for (const Warning& warning : again->warnings)
        EXPECT_NE(warning.code, "not-shown") << warning.text;
    EXPECT_NEAR(again->state.parameters.anisotropyRotation, 30.f, 1e-4f);
}

// A viewer turns highlights from the mesh's tangent on, which the turn of the textures does not move; we turn them with the textures.
TEST_F(Export, TheTurnOfHighlightsIsTheTexturesInGltf)
{
    Parameters& p = m_state.parameters;
    p.anisotropyStrength = 0.5f, p.anisotropyRotation = 30.f, p.rotation = 40.f, p.tiling = 2.f;
    ASSERT_TRUE(run("gltf", "a.glb"));
    const json document = glb("a.glb");
    EXPECT_NEAR(document["materials"][0]["extensions"]["KHR_materials_anisotropy"]["anisotropyRotation"].get<double>(),
        70. * std::numbers::pi / 180., 1e-5);
    const Expected<Opened> again = openSource((m_folder / "a.glb").string(), State());
    ASSERT_TRUE(again) << message(again.error());
    EXPECT_NEAR(again->state.parameters.anisotropyRotation, 30.f, 1e-4f);
}

TEST_F(Export, WhatGltfLeavesOutIsTold)
{
    const auto codes = [&] {
        std::set<std::string> set;
        for (const Warning& warning : run("gltf", "a.glb").value_or(Exported()).warnings)
            set.insert(warning.code);
        return set;
    };
    EXPECT_FALSE(codes().contains("gltf-rest"));
    m_state.mesh = "character";
    m_state.slots[std::size_t(MapKind::Normal)] = {};
    EXPECT_TRUE(codes().contains("gltf-rest"));
    EXPECT_TRUE(codes().contains("normal-made"));
    ASSERT_TRUE(run("textures", "set"));
    m_state.slots[std::size_t(MapKind::Specular)].file = (m_folder / "set/HammeredMetal_Color.png").string();
    m_state.parameters.shading = Shading::BlinnPhong;
    EXPECT_TRUE(codes().contains("gltf-specular"));
}

TEST_F(Export, FolderHoldsEachMapAndTheNumbers)
{
    m_state.name = "Old copper";
    const Expected<Exported> exported = run("textures", "new/folder", 32);
    ASSERT_TRUE(exported) << message(exported.error());
    const json numbers = json::parse(readText(m_folder / "new/folder/relief.json").value_or("{}"));
    EXPECT_NEAR(numbers["depthMetres"].get<float>(), m_state.parameters.depth, 1e-6f);
    EXPECT_LT(numbers["depthMetres"].dump().size(), 10u) << numbers["depthMetres"]; // no float widened to a double
    EXPECT_NEAR(numbers["depthUV"].get<float>(), m_state.parameters.depth, 1e-6f);
    EXPECT_EQ(numbers["metresPerUV"], 1.f);
    EXPECT_EQ(numbers["maps"].size(), 5u); // height, color, normal (made), roughness, metallic
    for (const json& map : numbers["maps"]) {
        const Expected<ImageRead> read = readImage(m_folder / "new/folder" / map["file"].get<std::string>());
        ASSERT_TRUE(read) << map;
        EXPECT_EQ(read->image.width, 32);
        EXPECT_EQ(read->image.storedBits, map["bits"]);
    }
    // The folder opens again as the set it was.
    const Expected<TextureSet> set = openTextureSet(m_folder / "new/folder");
    ASSERT_TRUE(set) << message(set.error());
    EXPECT_EQ(set->maps.size(), 5u) << textureSetJson(*set);
}

TEST_F(Export, PresetIsReadBack)
{
    m_state.parameters.depth = 0.123f;
    ASSERT_TRUE(run("preset", "a.json"));
    const Expected<StateRead> read = readState(State(), m_folder / "a.json");
    ASSERT_TRUE(read);
    EXPECT_FLOAT_EQ(read->state.parameters.depth, 0.123f);
}

TEST_F(Export, WhatCannotBeWrittenIsAnErrorAndLeavesNothing)
{
    fs::create_directories(m_folder / "taken.glb");
    std::ofstream(m_folder / "file") << "x";
    for (const auto& [target, out] :
        {std::pair{"gltf", "file/a.glb"}, {"gltf", "taken.glb"}, {"preset", "file/below/a.json"}, {"textures", "file/below"}}) {
        const Expected<Exported> exported = run(target, out);
        ASSERT_FALSE(exported) << target;
        EXPECT_NE(exported.error().where.find(m_folder.string()), std::string::npos);
        EXPECT_FALSE(exported.error().hint.empty());
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()), 2);
}

TEST_F(Export, WhatItWritesIsToldBefore)
{
    for (const auto& [target, out] : {std::pair{"gltf", "new/deep/a.glb"}, {"preset", "far/a.json"}, {"textures", "maps/of/it"}}) {
        const Expected<Resources> resources = loadResources(m_state, {}, {});
        ASSERT_TRUE(resources);
        std::vector<fs::path> told = findExport(target)->writes({m_state, *resources, m_folder / out, 0, {}});
        Expected<Exported> exported = run(target, out); // its folders are made
        ASSERT_TRUE(exported) << message(exported.error());
        std::ranges::sort(told);
        std::ranges::sort(exported->files);
        EXPECT_EQ(told, exported->files) << target;
    }
}

TEST(ExportImages, FileStemsAreSafe)
{
    EXPECT_EQ(fileStem("Hammered metal"), "HammeredMetal");
    EXPECT_EQ(fileStem("../a b/\\\"c"), "ABC");
    EXPECT_EQ(fileStem("\xC3\xA9t\xC3\xA9 chaud"),
        "\xC3\xA9t\xC3\xA9"
        "Chaud");
    std::string cyrillic;
    while (cyrillic.size() < 120)
        cyrillic += "\xD0\x9A";
    EXPECT_EQ(fileStem("x" + cyrillic).size(), 99u); // no character is cut
    EXPECT_EQ(fileStem("/:"), "material");
    EXPECT_EQ(fileStem("rock_2K-v1.2"), "rock_2K-v1.2");
}

TEST(ExportImages, ReductionKeepsTheMean)
{
    Image image{5, 3, 1, PixelType::U16, 16, false, std::vector<std::byte>(30)};
    for (std::size_t i = 0; i < 15; ++i) {
        const auto value = std::uint16_t(i * 4000);
        std::memcpy(image.data.data() + 2 * i, &value, 2);
    }
    const Image one = reduced(image, 1, Averaging::Plain);
    EXPECT_EQ(one.width, 1);
    EXPECT_EQ(one.height, 1);
    EXPECT_NEAR(one.value(0, 0, 0), 28000.f / 65535.f, 2e-5f);
    EXPECT_EQ(reduced(image, 5, Averaging::Plain).data, image.data);
    EXPECT_EQ(reduced(image, 0, Averaging::Plain).data, image.data);
    // Black and white average to the grey of half the light, not to half the code.
    Image pair{2, 1, 3, PixelType::U8, 8, false, std::vector<std::byte>(6)};
    std::fill_n(pair.data.begin() + 3, 3, std::byte(255));
    EXPECT_NEAR(reduced(pair, 1, Averaging::Srgb).value(0, 0, 0), 0.735f, 0.005f);
}

TEST(ExportImages, PackingPutsEachMapInItsChannel)
{
    const auto flat = [](int size, int value) {
        return std::make_shared<const Image>(
            Image{size, size, 1, PixelType::U8, 8, false, std::vector<std::byte>(std::size_t(size * size), std::byte(value))});
    };
    Material material;
    EXPECT_FALSE(packedImage(material, 0));
    material.maps[std::size_t(MapKind::Gloss)] = flat(4, 55);
    material.maps[std::size_t(MapKind::AmbientOcclusion)] = flat(8, 100);
    const std::optional<Image> packed = packedImage(material, 0);
    ASSERT_TRUE(packed);
    EXPECT_EQ(packed->width, 8);
    EXPECT_NEAR(packed->value(3, 3, 0) * 255.f, 100.f, 0.5f);
    EXPECT_NEAR(packed->value(3, 3, 1) * 255.f, 200.f, 0.5f); // roughness = 1 - gloss
    EXPECT_EQ(packed->value(3, 3, 2), 0.f);
}

} // namespace
