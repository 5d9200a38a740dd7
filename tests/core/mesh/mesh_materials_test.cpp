// A mesh file's materials become map slots: pictures are found where artists keep them, or taken out of the file.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gltf/pictures.h"
#include "core/image/files/image_file.h"
#include "tests/core/image/image_support.h"
#include "tests/core/mesh/mesh_support.h"

using namespace relievo;
namespace fs = std::filesystem;

namespace {
const std::string kTriangle = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl stone\nf 1/1 2/2 3/3\n";

// The mesh a.obj with the material file `mtl` beside it and empty files of the given names.
Expected<Mesh> withMaterial(const Scratch& scratch, const std::string& mtl, const std::vector<std::string>& pictures)
{
    for (const std::string& picture : pictures) {
        fs::create_directories((scratch.path / picture).parent_path());
        scratch.write(picture, "x");
    }
    scratch.write("a.mtl", mtl);
    return openMesh(scratch.write("a.obj", kTriangle));
}

const MapSlot& slot(const MeshMaterial& material, MapKind kind)
{
    return material.maps[std::size_t(kind)];
}

fs::path data(const std::string& name)
{
    return fs::path(RELIEVO_TEST_DATA) / "meshes" / name;
}
} // namespace

TEST(MeshMaterials, MtlNamesBecomeSlots)
{
    const Scratch scratch;
    const Expected<Mesh> mesh = withMaterial(scratch,
        "newmtl stone\nmap_Kd -s 1 1 1 my stone 2.png\nmap_Bump -bm 1.000000 stone_bump.png\nmap_Pr -imfchan g packed.png\nmap_d my stone "
        "2.png\n"
        "newmtl other\nmap_bump other_normal_dx.png\n",
        {"my stone 2.png", "stone_bump.png", "packed.png", "other_normal_dx.png"});
    ASSERT_TRUE(mesh) << message(mesh.error());
    ASSERT_EQ(mesh->materials.size(), 2u);
    const MeshMaterial &stone = mesh->materials[0], &other = mesh->materials[1];
    EXPECT_EQ(stone.name, mesh->parts[0].material);
    EXPECT_EQ(slot(stone, MapKind::Color).file, (scratch.path / "my stone 2.png").string());
    EXPECT_EQ(slot(stone, MapKind::Height).file, (scratch.path / "stone_bump.png").string());
    EXPECT_EQ(slot(stone, MapKind::Roughness).channel, Channel::G);
    EXPECT_EQ(slot(stone, MapKind::Opacity).channel, Channel::A); // the alpha of the colour picture
    EXPECT_TRUE(slot(stone, MapKind::Normal).empty());
    EXPECT_TRUE(slot(other, MapKind::Height).empty());
    EXPECT_TRUE(slot(other, MapKind::Normal).invert); // DirectX style, as its name says
    EXPECT_FALSE(told(*mesh, "map-missing"));
    EXPECT_FALSE(told(*mesh, "map-options"));
}

// Each option that changes the picture in its own words, and none that only filters it or changes nothing.
TEST(MeshMaterials, EachTextureOptionIsTold)
{
    const std::pair<const char*, const char*> options[] = {{"-s 2 1 1", "scales a.png; set tiling"}, {"-s 1 1 2", "scales a.png"},
        {"-o 0.5", "shifts a.png; set the offset"}, {"-t 0 0.1", "gives turbulence to a.png"}, {"-mm 0 2", "changes the values of a.png"},
        {"-mm 1 1", "changes the values of a.png"}, {"-bm 0.2", "sets the strength of a.png; set depth"},
        {"-clamp on", "does not repeat a.png; set wrap"}, {"-cc on", "corrects the colors of a.png"},
        {"-imfchan m", "takes another channel"}, {"-s 1 1 1", ""}, {"-o 0 0", ""}, {"-t 0", ""}, {"-mm 0 1", ""}, {"-bm 1.0", ""},
        {"-clamp off", ""}, {"-CLAMP OFF", ""}, {"-cc off", ""}, {"-imfchan l", ""}, {"-imfchan r", ""}, {"-boost 2", ""},
        {"-texres 512", ""}, {"-blendu off", ""}, {"-type sphere", ""}};
    for (const auto& [option, told] : options) {
        const Scratch scratch;
        const Expected<Mesh> mesh = withMaterial(scratch, std::string("newmtl stone\nmap_Bump ") + option + " a.png\n", {"a.png"});
        ASSERT_TRUE(mesh) << option;
        EXPECT_FALSE(slot(mesh->materials[0], MapKind::Height).empty()) << option;
        std::string text;
        for (const Warning& warning : mesh->warnings)
            if (warning.code == "map-options")
                text += warning.text;
        EXPECT_NE(text.find(told), text.npos) << option << ": " << text;
        EXPECT_EQ(text.empty(), std::string_view(told).empty()) << option << ": " << text;
    }
}

TEST(MeshMaterials, PathsOfOtherMachinesAreFollowedBesideTheMesh)
{
    for (const char* written : {".\\textures\\Stone.png", "C:\\work\\textures\\stone.PNG", "/home/else/Stone.png", "textures/stone.png",
             "\"textures/Stone.png\""}) {
        const Scratch scratch;
        const std::string kept
            = std::string(written).find("textures") == 1 || std::string(written).starts_with(".") || std::string(written).starts_with("t")
            ? "textures/Stone.png"
            : "Stone.png";
        const Expected<Mesh> mesh = withMaterial(scratch, std::string("newmtl stone\nmap_Kd ") + written + "\n", {kept});
        ASSERT_TRUE(mesh);
        ASSERT_EQ(mesh->materials.size(), 1u);
        EXPECT_EQ(slot(mesh->materials[0], MapKind::Color).file, (scratch.path / kept).string()) << written;
    }
}

TEST(MeshMaterials, WhatIsMissingOrNotFollowedIsTold)
{
    const Scratch scratch;
    const Expected<Mesh> mesh = withMaterial(scratch, "newmtl stone\nmap_Kd gone.png\nmap_Ks -s 2 2 2 here.png\nmap_Ke\n", {"here.png"});
    ASSERT_TRUE(mesh);
    EXPECT_TRUE(told(*mesh, "map-missing"));
    EXPECT_TRUE(told(*mesh, "map-options"));
    EXPECT_TRUE(slot(mesh->materials[0], MapKind::Color).empty());
    const Expected<Mesh> alone = opened("a.obj", kTriangle);
    ASSERT_TRUE(alone);
    EXPECT_TRUE(told(*alone, "material-missing"));
    EXPECT_TRUE(alone->materials.empty());
}

TEST(MeshMaterials, RealObjFilesFindTheirPictures)
{
    if (!fs::exists(data("obj2gltf")))
        GTEST_SKIP() << "no test data at " << data("obj2gltf");
    const Expected<Mesh> options = openMesh(data("obj2gltf/box-texture-options/box-texture-options.obj").string());
    ASSERT_TRUE(options);
    ASSERT_EQ(options->materials.size(), 1u);
    const auto pictures = [](const Mesh& mesh) {
        return std::ranges::count_if(mesh.materials[0].maps, [](const MapSlot& s) { return !s.empty() && fs::exists(s.file); });
    };
    EXPECT_EQ(pictures(*options) + std::ranges::count(options->warnings, "map-missing", &Warning::code), 5);
    const Expected<Mesh> missing = openMesh(data("obj2gltf/box-missing-texture/box-missing-texture.obj").string());
    ASSERT_TRUE(missing);
    EXPECT_TRUE(told(*missing, "map-missing"));
}

TEST(MeshMaterials, GltfChannelsAndPictures)
{
    if (!fs::exists(data("Avocado")))
        GTEST_SKIP() << "no test data at " << data("Avocado");
    const Expected<Mesh> mesh = openMesh(data("Avocado/glTF/Avocado.gltf").string());
    ASSERT_TRUE(mesh);
    ASSERT_EQ(mesh->materials.size(), 1u);
    const MeshMaterial& material = mesh->materials[0];
    EXPECT_EQ(material.name, mesh->parts[0].material);
    EXPECT_TRUE(fs::equivalent(slot(material, MapKind::Color).file, data("Avocado/glTF/Avocado_baseColor.png")));
    EXPECT_EQ(slot(material, MapKind::Roughness).channel, Channel::G);
    EXPECT_EQ(slot(material, MapKind::Metallic).channel, Channel::B);
    EXPECT_FALSE(slot(material, MapKind::Normal).empty());
    EXPECT_TRUE(slot(material, MapKind::Height).empty());
}

TEST(MeshMaterials, PicturesInsideTheFileAreReadAsImages)
{
    if (!fs::exists(data("NormalTangentMirrorTest.glb")))
        GTEST_SKIP() << "no test data at " << data("NormalTangentMirrorTest.glb");
    for (const char* name : {"NormalTangentMirrorTest.glb", "BoxTextured_embedded.gltf"}) {
        const Expected<Mesh> mesh = openMesh(data(name).string());
        ASSERT_TRUE(mesh);
        ASSERT_EQ(mesh->materials.size(), 1u);
        const std::string& file = slot(mesh->materials[0], MapKind::Color).file;
        EXPECT_TRUE(namesEmbeddedPicture(file)) << file;
        const Expected<ImageRead> read = readImage(file);
        ASSERT_TRUE(read) << message(read.error());
        EXPECT_GE(read->image.width, 64);
        const Expected<ImageRead> beyond = readImage(data(name).string() + "#77");
        ASSERT_FALSE(beyond);
        expectSentence(beyond.error(), name);
    }
    EXPECT_FALSE(namesEmbeddedPicture("a.png#1"));
    EXPECT_FALSE(namesEmbeddedPicture("a.glb#x"));
    EXPECT_FALSE(namesEmbeddedPicture("a.glb"));
}

TEST(MeshMaterials, AnyBytesAsMtlAreHarmless)
{
    const Scratch scratch;
    for (const std::string& mtl : {std::string("newmtl"), std::string("map_Kd x.png\n"), std::string(3000, '\\'),
             std::string("newmtl stone\nmap_Kd -s\nmap_Kd -s 1 2 3 4\nmap_Kd \"\nbump -bm\n\0\0", 52)}) {
        const Expected<Mesh> mesh = withMaterial(scratch, mtl, {});
        ASSERT_TRUE(mesh);
        expectSound(*mesh);
    }
}

namespace {
// A quad in xy with two UV sets (the second twice the first) and the given base colour and normal texture.
std::string texturedQuad(const std::string& material, const std::string& node = "")
{
    GltfBuffer buffer;
    const int points = buffer.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3", 3),
              first = buffer.floats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2", 2), second = buffer.floats({0, 2, 2, 2, 2, 0, 0, 0}, "VEC2", 2),
              tangents = buffer.floats({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4", 4);
    const int indices = buffer.accessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, 5123, "SCALAR", 1);
    return buffer.file("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0" + node
        + "}],\"meshes\":[{\"primitives\":[{\"material\":0,\"indices\":" + std::to_string(indices)
        + ",\"attributes\":{\"POSITION\":" + std::to_string(points) + ",\"TEXCOORD_0\":" + std::to_string(first)
        + ",\"TEXCOORD_1\":" + std::to_string(second) + ",\"TANGENT\":" + std::to_string(tangents) + "}}]}],\"materials\":[" + material
        + "],\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"x%20y.png\"}],");
}

std::string transformed(const std::string& transform)
{
    return "{\"index\":0,\"extensions\":{\"KHR_texture_transform\":" + transform + "}}";
}
} // namespace

TEST(MeshMaterials, TextureTransformMovesTheUVs)
{
    const std::string base = transformed(R"({"offset":[0.25,0.5],"rotation":0.5,"scale":[2,3]})");
    const Expected<Mesh> plain = opened("a.gltf", texturedQuad("{}"));
    const Expected<Mesh> mesh
        = opened("a.gltf", texturedQuad("{\"pbrMetallicRoughness\":{\"baseColorTexture\":" + base + "},\"normalTexture\":" + base + "}"));
    ASSERT_TRUE(plain && mesh) << message(mesh.error());
    EXPECT_FALSE(told(*mesh, "texture-transforms"));
    EXPECT_TRUE(told(*mesh, "map-missing"));
    ASSERT_EQ(plain->vertices.size(), mesh->vertices.size());
    for (std::size_t i = 0; i < plain->vertices.size(); ++i) {
        // Scaled, turned counter-clockwise as the image is seen, shifted.
        const glm::vec2 uv = plain->vertices[i].uv * glm::vec2(2.f, 3.f);
        const glm::vec2 turned(std::cos(0.5f) * uv.x + std::sin(0.5f) * uv.y, -std::sin(0.5f) * uv.x + std::cos(0.5f) * uv.y);
        EXPECT_LT(glm::distance(mesh->vertices[i].uv, turned + glm::vec2(0.25f, 0.5f)), 1e-5f);
        EXPECT_GT(
            glm::dot(glm::vec3(mesh->vertices[i].tangent), glm::normalize(mesh->vertices[i].dPdu)), 0.999f); // the file's no longer fit
    }
}

TEST(MeshMaterials, DifferentTransformsAreTold)
{
    const Expected<Mesh> mesh = opened("a.gltf",
        texturedQuad(
            "{\"pbrMetallicRoughness\":{\"baseColorTexture\":" + transformed(R"({"scale":[2,2]})") + "},\"normalTexture\":{\"index\":0}}"));
    ASSERT_TRUE(mesh);
    const auto warning = std::ranges::find(mesh->warnings, "texture-transforms", &Warning::code);
    ASSERT_NE(warning, mesh->warnings.end());
    EXPECT_NE(warning->text.find("scales, turns or shifts"), std::string::npos) << warning->text;
    EXPECT_NEAR(mesh->metresPerUV, 0.5f, 1e-5f);
}

namespace {
// texturedQuad with a picture of so many channels inside the file.
std::string quadWithPicture(const std::string& material, int channels)
{
    const Image image = test::noiseImage(8, 8, channels, PixelType::U8);
    const auto png = encodePng(image);
    const std::string bytes(reinterpret_cast<const char*>(png->data()), png->size()), name = "x%20y.png";
    std::string text = texturedQuad(material);
    return text.replace(text.find(name), name.size(), "data:image/png;base64," + GltfBuffer::base64(bytes));
}
} // namespace

// A colour channel in place of an alpha that is not there would be another map: such a picture is opaque everywhere.
TEST(MeshMaterials, OpacityAndGlossAreReadFromAlphaOnly)
{
    const std::string blend = R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})",
                      mask = R"({"alphaMode":"MASK","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})",
                      shiny = R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{"specularGlossinessTexture":{"index":0}}}})";
    const Scratch scratch;
    for (const int channels : {1, 2, 3, 4})
        for (const auto& [text, kind] :
            {std::pair(blend, MapKind::Opacity), std::pair(mask, MapKind::Opacity), std::pair(shiny, MapKind::Gloss)}) {
            const Expected<Mesh> inside = openMesh(scratch.write("a.gltf", quadWithPicture(text, channels)));
            ASSERT_TRUE(inside) << message(inside.error());
            EXPECT_EQ(slot(inside->materials[0], kind).empty(), channels % 2 == 1) << text << channels;
            ASSERT_TRUE(writeImage(scratch.path / "x y.png", test::noiseImage(8, 8, channels == 2 ? 4 : channels, PixelType::U8)));
            const Expected<Mesh> beside = openMesh(scratch.write("a.gltf", texturedQuad(text)));
            ASSERT_TRUE(beside);
            EXPECT_EQ(slot(beside->materials[0], kind).empty(), channels % 2 == 1) << text << channels;
        }
}

TEST(MeshMaterials, TheUVSetOfItsTexturesIsUsedAndTold)
{
    const Expected<Mesh> mesh = opened("a.gltf", texturedQuad(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":1}}})"));
    ASSERT_TRUE(mesh);
    EXPECT_TRUE(told(*mesh, "uv-set"));
    EXPECT_NEAR(mesh->metresPerUV, 0.5f, 1e-5f);
    const Expected<Mesh> both = opened(
        "a.gltf", texturedQuad(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"emissiveTexture":{"index":0,"texCoord":1}})"));
    ASSERT_TRUE(both);
    EXPECT_TRUE(told(*both, "uv-sets"));
    EXPECT_NEAR(both->metresPerUV, 1.f, 1e-5f);
    const Expected<Mesh> absent = opened("a.gltf", texturedQuad(R"({"normalTexture":{"index":0,"texCoord":7}})"));
    ASSERT_TRUE(absent);
    EXPECT_TRUE(absent->fileHasUVs);
}

TEST(MeshMaterials, QuotedNamesHoldSpacesAndNamesOfCodePagesAreFound)
{
    const Scratch scratch;
    scratch.write("my scan.png", "x");
    scratch.write("Gr\xc3\xb6\xc3\x9f"
                  "e.png",
        "x");
    scratch.write("my scan.mtl",
        "newmtl stone\nmap_Pr my%20scan.png\nmap_Kd \"my scan.png\"\nmap_Bump Gr\xf6\xdf"
        "e.png\r\n");
    scratch.write("two.mtl", "newmtl other\n");
    for (const std::string line : {"\"my scan.mtl\"", "my scan.mtl", "\"my scan.mtl\" two.mtl", "two.mtl \"my scan.mtl\""}) {
        std::string text = kTriangle;
        text.replace(text.find("a.mtl"), 5, line);
        const Expected<Mesh> mesh = openMesh(scratch.write("a.obj", text));
        ASSERT_TRUE(mesh) << message(mesh.error());
        const auto stone = std::ranges::find(mesh->materials, "stone", &MeshMaterial::name);
        ASSERT_NE(stone, mesh->materials.end()) << line;
        EXPECT_EQ(slot(*stone, MapKind::Color).file, (scratch.path / "my scan.png").string());
        EXPECT_EQ(slot(*stone, MapKind::Roughness).file, (scratch.path / "my scan.png").string());
        EXPECT_EQ(slot(*stone, MapKind::Height).file,
            (scratch.path
                / "Gr\xc3\xb6\xc3\x9f"
                  "e.png")
                .string());
        EXPECT_FALSE(told(*mesh, "material-missing") || told(*mesh, "map-missing"));
    }
}

TEST(MeshMaterials, MaterialFilesInUtf16KeepTheirNames)
{
    for (const bool bigEndian : {false, true}) {
        const Scratch scratch;
        const std::string picture = "Gr\xc3\xb6\xc3\x9f"
                                    "e \xe7\x9f\xb3.png";
        scratch.write(picture, "x");
        std::string mtl = bigEndian ? "\xfe\xff" : "\xff\xfe";
        for (const char16_t unit : std::u16string(u"newmtl stone\nmap_Kd Gr\u00f6\u00dfe \u77f3.png\n")) {
            const char high = char(unit >> 8), low = char(unit & 255);
            mtl += bigEndian ? high : low;
            mtl += bigEndian ? low : high;
        }
        scratch.write("a.mtl", mtl);
        const Expected<Mesh> mesh = openMesh(scratch.write("a.obj", kTriangle));
        ASSERT_TRUE(mesh && mesh->materials.size() == 1);
        EXPECT_EQ(slot(mesh->materials[0], MapKind::Color).file, (scratch.path / picture).string());
    }
}

TEST(MeshMaterials, SpecularGlossinessIsConverted)
{
    const auto factorsOf = [](const std::string& inside) {
        const Expected<Mesh> mesh
            = opened("a.gltf", texturedQuad(R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{)" + inside + "}}}"));
        return mesh->materials[0].factors.value();
    };
    const MeshFactors plain = factorsOf(R"("diffuseFactor":[0.5,1,0.25,1],"glossinessFactor":0.75,"specularFactor":[0.1,0.2,0.3])");
    EXPECT_EQ(plain.color, glm::vec3(0.5f, 1.f, 0.25f));
    EXPECT_FLOAT_EQ(plain.roughness, 0.25f);
    EXPECT_EQ(plain.metallic, 0.f);
    EXPECT_FLOAT_EQ(plain.specular.value(), 0.3f);
    EXPECT_EQ(factorsOf("").roughness, 0.f); // as glossy as can be, when it is not told
    const Expected<Mesh> newer = opened("a.gltf",
        texturedQuad(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"roughnessFactor":0.4},"extensions":)"
                     R"({"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0,0,0,1]}}})"));
    EXPECT_EQ(newer->materials[0].factors->color, glm::vec3(1.f)); // metallic-roughness is what is shown
    EXPECT_FLOAT_EQ(newer->materials[0].factors->roughness, 0.4f);
}

namespace {
// texturedQuad whose picture is sampled so: WebGL's 33071 clamps, 33648 mirrors, 10497 repeats.
std::string sampledQuad(int across, int down)
{
    std::string text = texturedQuad(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})");
    const std::string from = "\"textures\":[{\"source\":0}]";
    return text.replace(text.find(from), from.size(),
        "\"textures\":[{\"source\":0,\"sampler\":0}],\"samplers\":[{\"wrapS\":" + std::to_string(across)
            + ",\"wrapT\":" + std::to_string(down) + "}]");
}
} // namespace

TEST(MeshMaterials, SamplersThatClampAreFollowedAndOthersTold)
{
    for (const auto& [across, down, clamps, tells] : {std::tuple(33071, 33071, true, false), std::tuple(10497, 10497, false, false),
             std::tuple(33648, 33648, false, true), std::tuple(10497, 33071, false, true)}) {
        const Expected<Mesh> mesh = opened("a.gltf", sampledQuad(across, down));
        ASSERT_TRUE(mesh) << message(mesh.error());
        EXPECT_EQ(mesh->materials[0].factors->clamped, clamps);
        EXPECT_EQ(told(*mesh, "not-shown"), tells) << across << ' ' << down;
    }
}

TEST(MeshMaterials, WhatIsNotShownIsToldOnce)
{
    const Expected<Mesh> mesh = opened("a.gltf",
        texturedQuad(
            R"({"alphaMode":"BLEND","emissiveFactor":[1,0,0],"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.5]},"extensions":)"
            R"({"KHR_materials_unlit":{},"KHR_materials_clearcoat":{"clearcoatFactor":1,"clearcoatTexture":{"index":0}},"KHR_materials_iridescence":)"
            R"({"iridescenceFactor":1},"KHR_materials_transmission":{"transmissionFactor":0.7},"XYZ_new":{}}})"));
    ASSERT_TRUE(mesh);
    EXPECT_EQ(std::ranges::count(mesh->warnings, "not-shown", &Warning::code), 1);
    const std::string text = std::ranges::find(mesh->warnings, "not-shown", &Warning::code)->text;
    for (const char* word : {"unlit", "clearcoatTexture", "iridescence", "XYZ_new", "transparency", "emission"})
        EXPECT_NE(text.find(word), std::string::npos) << word << ": " << text;
    EXPECT_EQ(text.find("transmission"), std::string::npos); // it is
    const Expected<Mesh> plain = opened("a.gltf",
        texturedQuad(
            R"({"extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":0},"KHR_materials_iridescence":{"iridescenceFactor":0},)"
            R"("KHR_materials_emissive_strength":{"emissiveStrength":2}}})"));
    EXPECT_FALSE(told(*plain, "not-shown"));
    std::string coloured = texturedQuad("{}");
    const std::string from = "\"POSITION\":0";
    coloured.replace(coloured.find(from), from.size(), "\"POSITION\":0,\"COLOR_0\":3");
    EXPECT_TRUE(told(*opened("a.gltf", coloured), "not-shown"));
}

TEST(MeshMaterials, SameNamesAreToldApart)
{
    const Expected<Mesh> mesh = opened("a.gltf", texturedQuad(R"({"name":"a"},{"name":"a"},{})"));
    ASSERT_TRUE(mesh);
    ASSERT_EQ(mesh->materials.size(), 3u);
    EXPECT_EQ(mesh->materials[1].name, "a (2)");
    EXPECT_EQ(mesh->materials[2].name, "material 2");
}

TEST(MeshGltfNodes, ScaledToNothingIsDroppedAndTold)
{
    const Expected<Mesh> gone = opened("a.gltf", texturedQuad("{}", ",\"scale\":[0,0,0]"));
    ASSERT_FALSE(gone);
    expectSentence(gone.error(), "a.gltf");
    const Expected<Mesh> one = opened("a.gltf", texturedQuad("{}", ",\"children\":[1]},{\"mesh\":0,\"scale\":[0,0,0]"));
    ASSERT_TRUE(one) << message(one.error());
    EXPECT_EQ(one->indices.size(), 6u);
    EXPECT_TRUE(told(*one, "nodes-dropped"));
    const Expected<Mesh> flat = opened("a.gltf", texturedQuad("{}", ",\"scale\":[1,2,0]"));
    ASSERT_TRUE(flat);
    expectSound(*flat);
}

TEST(MeshGltfNodes, QuantizedAttributesAreTheSameMesh)
{
    GltfBuffer buffer;
    const int points
        = buffer.accessor(std::vector<std::int16_t>{0, 0, 0, 0, 32767, 0, 0, 0, 32767, 32767, 0, 0, 0, 32767, 0, 0}, 5122, "VEC4", 4, true);
    const int good = buffer.accessor(std::vector<std::uint16_t>{0, 0, 0, 1000, 0, 0, 1000, 1000, 0, 0, 1000, 0}, 5123, "VEC3", 3);
    const int normals = buffer.accessor(std::vector<std::int8_t>{0, 0, 127, 0, 0, 127, 0, 0, 127, 0, 0, 127}, 5120, "VEC3", 3, true);
    const int uvs = buffer.accessor(std::vector<std::uint8_t>{0, 255, 255, 255, 255, 0, 0, 0}, 5121, "VEC2", 2, true);
    const int indices = buffer.accessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}, 5121, "SCALAR", 1);
    const auto file = [&](int position) {
        return buffer.file("\"extensionsRequired\":[\"KHR_mesh_quantization\"],\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,"
                           "\"scale\":[0.001,0.001,0.001]}],\"meshes\":[{\"primitives\":[{"
                           "\"indices\":"
            + std::to_string(indices) + ",\"attributes\":{\"POSITION\":" + std::to_string(position)
            + ",\"NORMAL\":" + std::to_string(normals) + ",\"TEXCOORD_0\":" + std::to_string(uvs) + "}}]}],");
    };
    const Expected<Mesh> mesh = opened("a.gltf", file(good));
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_LT(glm::distance(mesh->boundsMax, glm::vec3(1.f, 1.f, 0.f)), 1e-5f);
    EXPECT_NEAR(mesh->metresPerUV, 1.f, 1e-4f);
    for (const Vertex& v : mesh->vertices)
        EXPECT_NEAR(v.normal.z, 1.f, 1e-4f);
    const Expected<Mesh> wrong = opened("a.gltf", file(points)); // positions of four numbers
    ASSERT_FALSE(wrong);
    expectSentence(wrong.error(), "a.gltf");
}
