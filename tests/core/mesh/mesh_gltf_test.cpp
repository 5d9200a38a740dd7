// glTF files as exporters write them, bent and broken ones too: buffers, pictures, skeletons, morph targets and UV sets.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gltf/pictures.h"
#include "core/mesh/animation/pose.h"
#include "tests/core/mesh/mesh_support.h"

using namespace relievo;

namespace {
const std::string kScene = "\"scenes\":[{\"nodes\":[0]}],";
const std::string kTriangleBase64 = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"; // the buffer of tinyGltf
const std::string kTriangleUri = "data:application/octet-stream;base64," + kTriangleBase64;

std::string number(std::size_t n)
{
    return std::to_string(n);
}

std::string triangleBytes()
{
    const float points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    return {reinterpret_cast<const char*>(points), sizeof points};
}

// A binary glTF of the triangle whose header claims `extra` bytes more in its buffer than follow.
std::string glb(std::uint32_t extra)
{
    std::string json = tinyGltf(",\"uri\":\"" + kTriangleUri + '"', "");
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string file = "glTF";
    const auto put = [&file](std::size_t value) {
        const auto word = std::uint32_t(value);
        file.append(reinterpret_cast<const char*>(&word), 4);
    };
    put(2), put(12 + 8 + json.size() + 8 + 36), put(json.size()), put(0x4E4F534A);
    file += json;
    put(36 + extra), put(0x004E4942);
    return file + triangleBytes();
}

Expected<Mesh> withPicture(const std::string& image, const Scratch& scratch)
{
    return openMesh(scratch.write("a.gltf",
        tinyGltf("\"mode\":4}]}],",
            "\"mode\":4,\"material\":0}]}],\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],"
            "\"textures\":[{\"source\":0}],\"images\":["
                + image + "],")));
}

std::string textOf(const Mesh& mesh, std::string_view code)
{
    const auto found = std::ranges::find(mesh.warnings, code, &Warning::code);
    return found == mesh.warnings.end() ? "" : found->text;
}

// A unit square that an armature of scale 0.01 holds and whose only joint undoes that scale.
std::string armature(bool animated)
{
    GltfBuffer buffer;
    const int points = buffer.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3", 3),
              uvs = buffer.floats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2", 2);
    const int indices = buffer.accessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}, 5121, "SCALAR", 1);
    const int joints = buffer.accessor(std::vector<std::uint8_t>(16, 0), 5121, "VEC4", 4);
    const int weights = buffer.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
    const int bind = buffer.floats({100, 0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0, 0, 0, 1}, "MAT4", 16);
    const int times = buffer.floats({0, 1}, "SCALAR", 1), moves = buffer.floats({0, 0, 0, 0, 5, 0}, "VEC3", 3);
    const auto n = [](int value) { return std::to_string(value); };
    return buffer.file(kScene
        + "\"nodes\":[{\"scale\":[0.01,0.01,0.01],\"children\":[1,2]},{\"mesh\":0,\"skin\":0},{}],\"skins\":[{\"joints\":[2],"
          "\"inverseBindMatrices\":"
        + n(bind) + "}],\"meshes\":[{\"primitives\":[{\"indices\":" + n(indices) + ",\"attributes\":{\"POSITION\":" + n(points)
        + ",\"TEXCOORD_0\":" + n(uvs) + ",\"JOINTS_0\":" + n(joints) + ",\"WEIGHTS_0\":" + n(weights) + "}}]}],"
        + (animated ? "\"animations\":[{\"samplers\":[{\"input\":" + n(times) + ",\"output\":" + n(moves)
                    + "}],\"channels\":[{\"sampler\":0,\"target\":{\"node\":2,\"path\":\"translation\"}}]}],"
                    : ""));
}

// A mesh of `primitives` triangles with `targets` targets that lift them by 1; behind it `vertices` zeros in another mesh.
std::string morphing(std::size_t primitives, std::size_t vertices, std::size_t targets)
{
    GltfBuffer buffer;
    std::vector<float> points(300, 0.f), lift(300, 0.f); // a hundred vertices, of which three are shown
    points[3] = points[7] = 1.f;
    for (std::size_t i = 1; i < lift.size(); i += 3)
        lift[i] = 1.f;
    const int at = buffer.floats(points, "VEC3", 3), up = buffer.floats(lift, "VEC3", 3);
    const int indices = buffer.accessor(std::vector<std::uint8_t>{0, 1, 2}, 5121, "SCALAR", 1);
    std::string target, primitive, all;
    for (std::size_t t = 0; t < targets; ++t)
        target += std::string(t > 0 ? "," : "") + "{\"POSITION\":" + std::to_string(up) + "}";
    for (std::size_t p = 0; p < primitives; ++p)
        all += std::string(p > 0 ? "," : "") + "{\"indices\":" + std::to_string(indices)
            + ",\"attributes\":{\"POSITION\":" + std::to_string(at) + "},\"targets\":[" + target + "]}";
    const std::string zeros = ",{\"componentType\":5126,\"type\":\"VEC3\",\"count\":" + number(vertices) + "}";
    std::string file = buffer.file("\"scenes\":[{\"nodes\":[1,0]}],\"nodes\":[{\"mesh\":0},{\"mesh\":1}],\"meshes\":[{\"primitives\":["
        + all + "]},{\"primitives\":[{\"indices\":2,\"attributes\":{\"POSITION\":3}}]}],");
    const std::size_t end = file.find("],\"bufferViews\"");
    return file.insert(end, zeros);
}
} // namespace

TEST(MeshGltfSkin, TheSkeletonPlacesTheMesh)
{
    for (const bool animated : {false, true}) {
        const Expected<Mesh> mesh = opened("a.gltf", armature(animated));
        ASSERT_TRUE(mesh) << message(mesh.error());
        EXPECT_EQ(mesh->deformation != nullptr, animated);
        EXPECT_LT(glm::distance(mesh->boundsMax, glm::vec3(1.f, 1.f, 0.f)), 1e-5f);
        EXPECT_NEAR(mesh->metresPerUV, 1.f, 1e-5f);
        const Mesh rest = posed(*mesh, poseAt(*mesh, -1, 0.f));
        expectSound(rest);
        EXPECT_LT(glm::distance(rest.boundsMax, mesh->boundsMax), 1e-5f);
        for (const Vertex& v : rest.vertices)
            EXPECT_NEAR(glm::length(v.dPdu), 1.f, 1e-4f);
    }
}

TEST(MeshGltfMorph, ManyPrimitivesOfOneMeshKeepTheirTargets)
{
    const Expected<Mesh> mesh = opened("a.gltf", morphing(300, 3, 4));
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_FALSE(told(*mesh, "morph-too-large"));
    ASSERT_EQ(mesh->deformation->targets.size(), 4u);
    for (std::size_t i = 0; i + 3 < mesh->indices.size(); ++i)
        ASSERT_EQ(mesh->deformation->targets[3].deltas[mesh->indices[i + 3]].position, glm::vec3(0.f, 1.f, 0.f)) << i;
}

TEST(MeshGltfMorph, WhatIsTooLargeLosesWholeTargets)
{
    const std::size_t vertices = 1 << 20, targets = 20; // of so many vertices 15 targets fit
    const Expected<Mesh> mesh = opened("a.gltf", morphing(2, vertices, targets));
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_TRUE(told(*mesh, "morph-too-large"));
    ASSERT_EQ(mesh->deformation->targets.size(), 15u);
    for (const MorphTarget& target : mesh->deformation->targets)
        for (std::size_t i = 3; i < mesh->indices.size(); ++i)
            ASSERT_EQ(target.deltas[mesh->indices[i]].position, glm::vec3(0.f, 1.f, 0.f)) << i;
}

// A small file whose triangles, flat without normals, share 255 positions: its vertices are many more, and each has a delta.
TEST(MeshGltfMorph, VerticesThatAreMadeCountAsWell)
{
    GltfBuffer buffer;
    std::mt19937 random(3);
    std::vector<float> points(3 * 255);
    for (float& coordinate : points)
        coordinate = float(random() % 1000);
    std::vector<std::uint8_t> corners(3 * 15000);
    for (std::uint8_t& corner : corners)
        corner = std::uint8_t(random() % 255);
    const int at = buffer.floats(points, "VEC3", 3), indices = buffer.accessor(corners, 5121, "SCALAR", 1);
    std::string targets = "{}";
    for (int t = 1; t < 500; ++t)
        targets += ",{}";
    const Expected<Mesh> mesh = opened("a.gltf",
        buffer.file(kScene + "\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"indices\":" + std::to_string(indices)
            + ",\"attributes\":{\"POSITION\":" + std::to_string(at) + "},\"targets\":[" + targets + "]}]}],"));
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_TRUE(told(*mesh, "morph-too-large"));
    EXPECT_GT(mesh->vertices.size(), 40000u);
    EXPECT_EQ(mesh->deformation->targets.size(), (1u << 24) / mesh->vertices.size());
}

TEST(MeshGltfDocument, BinaryChunksEndWithinTheFile)
{
    EXPECT_TRUE(opened("a.glb", glb(0)));
    for (const std::uint32_t extra : {4u, 8u}) {
        const Expected<Mesh> mesh = opened("a.glb", glb(extra));
        ASSERT_FALSE(mesh) << extra;
        expectSentence(mesh.error(), "a.glb");
    }
}

TEST(MeshGltfDocument, DataOfAnyMediaTypeAreBuffers)
{
    for (const char* type : {"data:;base64,", "data:application/octet-stream;charset=utf-8;base64,", "data:image/webp;BASE64,"}) {
        const Expected<Mesh> mesh = opened("a.gltf", tinyGltf("data:application/octet-stream;base64,", type));
        EXPECT_TRUE(mesh) << type;
    }
}

TEST(MeshGltfDocument, BufferFilesAreFoundAsPicturesAre)
{
    const std::pair<const char*, const char*> names[]
        = {{"BUF.BIN", "buf.bin"}, {"..\\\\old\\\\buf.bin", "buf.bin"}, {"geo.png", "geo.png"}, {"a%20b+c.bin", "a b+c.bin"}};
    for (const auto& [written, kept] : names) {
        const Scratch scratch;
        scratch.write(kept, triangleBytes());
        const Expected<Mesh> mesh = openMesh(scratch.write("a.gltf", tinyGltf(kTriangleUri, written)));
        EXPECT_TRUE(mesh) << written << ": " << message(mesh.error());
    }
    const Expected<Mesh> none = opened("a.gltf", tinyGltf(kTriangleUri, std::string(500, 'x') + ".bin"));
    ASSERT_FALSE(none);
    EXPECT_LT(none.error().what.size(), 200u);
}

TEST(MeshGltfPictures, DataOfAnyMediaTypeAreInTheFile)
{
    for (const char* type : {"image/webp", "application/octet-stream", "image/png;charset=utf-8", ""}) {
        const Scratch scratch;
        const Expected<Mesh> mesh = withPicture("{\"uri\":\"data:" + std::string(type) + ";base64,AAECAw==\"}", scratch);
        ASSERT_TRUE(mesh) << message(mesh.error());
        const std::string& file = mesh->materials.at(0).maps[std::size_t(MapKind::Color)].file;
        ASSERT_TRUE(namesEmbeddedPicture(file)) << type;
        const Expected<std::vector<std::byte>> bytes = readEmbeddedPicture(file);
        ASSERT_TRUE(bytes) << message(bytes.error());
        EXPECT_EQ(*bytes, (std::vector{std::byte(0), std::byte(1), std::byte(2), std::byte(3)}));
    }
}

TEST(MeshGltfPictures, LongUrisAreNotPrintedWhole)
{
    const Scratch scratch;
    const Expected<Mesh> mesh = withPicture("{\"uri\":\"data:image/svg+xml," + std::string(100000, 'x') + "\"}", scratch);
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_FALSE(textOf(*mesh, "map-missing").empty());
    EXPECT_LT(textOf(*mesh, "map-missing").size(), 300u);
}

TEST(MeshGltfPictures, BadEntriesLeaveTheMesh)
{
    for (const char* image : {"{\"name\":\"x\"}", "{\"bufferView\":5,\"mimeType\":\"image/png\"}", "{\"bufferView\":-1}", "7",
             "{\"uri\":\"nothere.tga\"}", "{\"uri\":8}"}) {
        const Scratch scratch;
        const Expected<Mesh> mesh = withPicture(image, scratch);
        ASSERT_TRUE(mesh) << image << ": " << message(mesh.error());
        EXPECT_TRUE(told(*mesh, "map-missing")) << image;
    }
    const Scratch scratch;
    scratch.write("empty.tga", "");
    EXPECT_TRUE(withPicture("{\"uri\":\"empty.tga\"}", scratch));
    const Expected<Mesh> empty = withPicture("{\"uri\":\"data:image/png;base64,\"}", scratch);
    ASSERT_TRUE(empty);
    const Expected<std::vector<std::byte>> bytes = readEmbeddedPicture(empty->materials.at(0).maps[std::size_t(MapKind::Color)].file);
    ASSERT_FALSE(bytes);
    expectSentence(bytes.error(), "a.gltf");
}

TEST(MeshGltfNodes, DirectionsSurviveAnyScale)
{
    GltfBuffer buffer;
    const int points = buffer.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3), uvs = buffer.floats({0, 0, 1, 0, 0, 1}, "VEC2", 2);
    const int normals = buffer.floats({0, .6f, .8f, 0, .6f, .8f, 0, .6f, .8f}, "VEC3", 3);
    const int tangents = buffer.floats({1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1}, "VEC4", 4);
    for (const char* scale : {"1e-4", "1e-6", "-1e-6", "1e-9", "1e9"}) {
        const Expected<Mesh> mesh = opened("a.gltf",
            buffer.file(kScene + "\"nodes\":[{\"mesh\":0,\"scale\":[" + scale + ',' + scale + ',' + scale
                + "]}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + std::to_string(points)
                + ",\"NORMAL\":" + std::to_string(normals) + ",\"TEXCOORD_0\":" + std::to_string(uvs)
                + ",\"TANGENT\":" + std::to_string(tangents) + "}}]}],"));
        ASSERT_TRUE(mesh) << scale;
        EXPECT_FALSE(told(*mesh, "normals-repaired")) << scale;
        const float side = scale[0] == '-' ? -1.f : 1.f;
        for (const Vertex& v : mesh->vertices) {
            EXPECT_LT(glm::distance(v.normal, side * glm::vec3(0.f, .6f, .8f)), 1e-5f) << scale;
            EXPECT_EQ(v.tangent, glm::vec4(side, 0.f, 0.f, -side)) << scale; // as the file has it, although MikkTSpace's w would be 1
        }
    }
}

TEST(MeshGltfNodes, InstancesThatAreNotShownAreTold)
{
    const Expected<Mesh> mesh = opened(
        "a.gltf", tinyGltf("\"mesh\":0,", "\"mesh\":0,\"extensions\":{\"EXT_mesh_gpu_instancing\":{\"attributes\":{\"TRANSLATION\":0}}},"));
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_TRUE(told(*mesh, "instances-skipped"));
}

TEST(MeshGltfNodes, ScenesOfZerosHaveOneBudget)
{
    GltfBuffer buffer;
    buffer.accessor(std::vector<std::uint8_t>{0, 1, 2}, 5121, "SCALAR", 1);
    buffer.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
    std::string file = buffer.file("\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"mesh\":0},{\"mesh\":0}],\"meshes\":[{\"primitives\":[{"
                                   "\"indices\":0,\"attributes\":{\"POSITION\":2}}]}],");
    file.insert(file.find("],\"bufferViews\""),
        ",{\"componentType\":5126,\"type\":\"VEC3\",\"count\":3000000,\"sparse\":{\"count\":3,\"indices\":{\"bufferView\":0,"
        "\"componentType\":5121},\"values\":{\"bufferView\":1}}}");
    const Expected<Mesh> both = opened("a.gltf", file);
    ASSERT_FALSE(both);
    expectSentence(both.error(), "a.gltf");
    file.replace(file.find("[0,1]"), 5, "[0]");
    EXPECT_TRUE(opened("a.gltf", file));
}

TEST(MeshGltfUVs, TheSetThatIsUsedIsTold)
{
    GltfBuffer buffer;
    const int points = buffer.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3), uvs = buffer.floats({0, 0, 1, 0, 0, 1}, "VEC2", 2);
    const auto file = [&](const std::string& set, const std::string& more) {
        return buffer.file(kScene + "\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{" + more
            + "\"attributes\":{\"POSITION\":" + std::to_string(points) + ",\"TEXCOORD_" + set + "\":" + std::to_string(uvs)
            + "}}]}],\"materials\":[{\"name\":\"m\",\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"texCoord\":1}}}],");
    };
    const Expected<Mesh> only = opened("a.gltf", file("1", "")), missing = opened("a.gltf", file("0", "\"material\":0,"));
    const Expected<Mesh> right = opened("a.gltf", file("1", "\"material\":0,"));
    ASSERT_TRUE(only && missing && right);
    EXPECT_TRUE(only->fileHasUVs);
    EXPECT_FALSE(told(*only, "uvs-made"));
    EXPECT_NE(textOf(*only, "uv-set").find("UV set 1"), std::string::npos);
    EXPECT_NE(textOf(*missing, "uv-set").find("set 0 is used"), std::string::npos);
    EXPECT_NE(textOf(*right, "uv-set").find("mapped by UV set 1"), std::string::npos);
}

TEST(MeshGltfMaterials, SameNamesAreNumberedInOrder)
{
    const Expected<Mesh> mesh = opened("a.gltf",
        tinyGltf(
            "\"scene\":0,", R"names("scene":0,"materials":[{"name":"a"},{"name":"a (2)"},{"name":"a"},{"name":"a"},{"name":"a"}],)names"));
    ASSERT_TRUE(mesh);
    std::string names;
    for (const MeshMaterial& material : mesh->materials)
        names += material.name + ';';
    EXPECT_EQ(names, "a;a (2);a (3);a (4);a (5);");
}
