// Mesh files open whole or are refused with a sentence: small files written here, and the real and broken ones beside the checkout.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "core/mesh/mesh.h"
#include "tests/core/mesh/mesh_support.h"
#include <set>

using namespace relievo;
namespace fs = std::filesystem;

TEST(MeshObj, KeepsUVsFlippedAndParts)
{
    const Expected<Mesh> mesh = opened("a.obj",
        std::string("\xEF\xBB\xBF") + kQuad + "o wall\nusemtl stone\nf 1/1 2/2 3/3\no floor\nusemtl wood\nf -4/-4 \\\n -2/-2 -1/-1\n");
    ASSERT_TRUE(mesh) << message(mesh.error());
    expectSound(*mesh);
    EXPECT_EQ(mesh->indices.size(), 6u);
    ASSERT_EQ(mesh->parts.size(), 2u);
    EXPECT_EQ(mesh->parts[0].name + "/" + mesh->parts[0].material, "wall/stone");
    EXPECT_EQ(mesh->parts[1].name + "/" + mesh->parts[1].material, "floor/wood");
    for (const Vertex& v : mesh->vertices)
        EXPECT_FLOAT_EQ(v.uv.y, 1.f - v.position.y / 2.f);
    EXPECT_FLOAT_EQ(mesh->metresPerUV, 2.f);
    EXPECT_TRUE(mesh->fileHasUVs);
    EXPECT_FALSE(mesh->fileHasNormals);
    EXPECT_TRUE(told(*mesh, "normals-made"));
    for (const Vertex& v : mesh->vertices) {
        EXPECT_NEAR(v.normal.z, 1.f, 1e-5f);
        EXPECT_EQ(v.tangent.w, 1.f);
    }
}

TEST(MeshObj, MirroredTextureTurnsTheBitangent)
{
    const Expected<Mesh> mesh = opened("a.obj", std::string(kQuad) + "f 1/2 2/1 3/4 4/3\n"); // u runs to the left
    ASSERT_TRUE(mesh);
    for (const Vertex& v : mesh->vertices) {
        EXPECT_EQ(v.tangent.w, -1.f);
        EXPECT_GT(glm::dot(glm::cross(v.normal, glm::vec3(v.tangent)) * v.tangent.w, -v.dPdv), 0.f);
    }
}

TEST(MeshObj, JacobianIsThatOfASkewedTexture)
{
    // u along (1, 0), v down along (0.5, -1) per unit: position = 3 u x + v (1.5, -4).
    const Expected<Mesh> mesh = opened("a.obj", "v 0 0 0\nv 3 0 0\nv 1.5 -4 0\nvt 0 1\nvt 1 1\nvt 0 0\nf 1/1 3/3 2/2\n");
    ASSERT_TRUE(mesh);
    for (const Vertex& v : mesh->vertices) {
        EXPECT_LT(glm::distance(v.dPdu, glm::vec3(3.f, 0.f, 0.f)), 1e-4f);
        EXPECT_LT(glm::distance(v.dPdv, glm::vec3(1.5f, -4.f, 0.f)), 1e-4f);
    }
    EXPECT_NEAR(mesh->metresPerUV, std::sqrt(12.f), 1e-4f);
}

TEST(MeshObj, ConcavePolygonsKeepTheirArea)
{
    // A U shape: a fan from its first corner would cover the gap.
    const Expected<Mesh> mesh
        = opened("u.obj", "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8\n");
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->indices.size(), 18u);
    float area = 0.f;
    for (std::size_t i = 0; i < mesh->indices.size(); i += 3) {
        const glm::vec3 a = mesh->vertices[mesh->indices[i]].position, b = mesh->vertices[mesh->indices[i + 1]].position,
                        c = mesh->vertices[mesh->indices[i + 2]].position;
        EXPECT_GE(glm::cross(b - a, c - a).z, 0.f);
        area += 0.5f * glm::length(glm::cross(b - a, c - a));
    }
    EXPECT_NEAR(area, 7.f, 1e-4f);
}

TEST(MeshObj, KeepsFacesWhereMoreThanTwoMeet)
{
    const Expected<Mesh> mesh
        = opened("fan.obj", "v 0 0 0\nv 0 1 0\nv 1 0 0\nv -1 0 0\nv 0 0 1\nv 0 0 -1\nf 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 2 6\nf 1 2 2\n");
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->indices.size(), 15u);
    expectSound(*mesh);
}

TEST(MeshObj, NotFinitePositionsAreDroppedAndTold)
{
    const Expected<Mesh> mesh = opened("a.obj", std::string(kQuad) + "v nan 0 0\nv 1e39 0 0\nf 1 2 3\nf 1 2 5\nf 1 2 6\n");
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->indices.size(), 3u);
    EXPECT_TRUE(told(*mesh, "triangles-dropped"));
    expectSound(*mesh);
}

TEST(MeshObj, BoxProjectionIsToldAndOneTilePerLargestSide)
{
    const Expected<Mesh> mesh = opened("a.obj", "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\nf 1 2 3 4\n");
    ASSERT_TRUE(mesh);
    EXPECT_FALSE(mesh->fileHasUVs);
    EXPECT_TRUE(told(*mesh, "uvs-made"));
    EXPECT_NEAR(mesh->metresPerUV, 4.f, 1e-4f);
    for (const Vertex& v : mesh->vertices) {
        EXPECT_NEAR(v.dPdu.x, 4.f, 1e-4f); // u to the right, v down
        EXPECT_NEAR(v.dPdv.y, -4.f, 1e-4f);
    }
}

TEST(MeshObj, SharpEdgesStaySharpAndRoundOnesRound)
{
    const Expected<Mesh> box = opened("box.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf "
        "2 3 7 6\n");
    ASSERT_TRUE(box);
    EXPECT_EQ(box->vertices.size(), 24u);
    const Expected<Mesh> roof = opened("roof.obj", "v 0 0 0\nv 1 0 0\nv 1 0.2 1\nv 0 0.2 1\nv 1 0 2\nv 0 0 2\nf 4 3 2 1\nf 6 5 3 4\n");
    ASSERT_TRUE(roof);
    for (const Vertex& v : roof->vertices)
        if (v.position.y > 0.1f) {
            EXPECT_NEAR(v.normal.y, 1.f, 1e-4f); // the ridge is shared
        }
}

TEST(MeshObj, RefusesBrokenFacesByLine)
{
    const Expected<Mesh> mesh = opened("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    ASSERT_FALSE(mesh);
    expectSentence(mesh.error(), "bad.obj");
    EXPECT_NE(mesh.error().what.find("line 4"), std::string::npos);
}

TEST(MeshPly, BinaryOfBothOrdersWithWindowsLineEnds)
{
    for (const bool big : {false, true}) {
        std::string file = std::string("ply\r\nformat binary_") + (big ? "big" : "little")
            + "_endian 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\nproperty double z\r\nproperty float "
              "s\r\nproperty float t\r\n"
              "element face 1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n";
        const auto put = [&file, big](const auto value) {
            char raw[sizeof value];
            std::memcpy(raw, &value, sizeof value);
            if (big)
                std::reverse(raw, raw + sizeof value);
            file.append(raw, sizeof value);
        };
        for (const auto& [x, y] : {std::pair{0.f, 0.f}, {1.f, 0.f}, {0.f, 1.f}}) {
            put(x);
            put(y);
            put(7.0);
            put(x);
            put(y);
        }
        put(std::uint8_t(3));
        for (const int i : {0, 1, 2})
            put(i);
        const Expected<Mesh> mesh = opened("a.ply", file);
        ASSERT_TRUE(mesh) << message(mesh.error());
        expectSound(*mesh);
        EXPECT_TRUE(mesh->fileHasUVs);
        EXPECT_EQ(mesh->boundsMax, glm::vec3(1.f, 1.f, 7.f));
        for (const Vertex& v : mesh->vertices)
            EXPECT_FLOAT_EQ(v.uv.y, 1.f - v.position.y);
        const Expected<Mesh> cut = opened("cut.ply", file.substr(0, file.size() - 3));
        ASSERT_FALSE(cut);
        expectSentence(cut.error(), "cut.ply");
    }
}

TEST(MeshPly, ClaimsBeyondTheFileAreRefusedAtOnce)
{
    const std::string header = "ply\nformat ascii 1.0\nelement vertex ";
    for (const std::string& rest : {std::string("4000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n"),
             std::string("1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uint int "
                         "vertex_indices\nend_header\n"
                         "0 0 0\n4294967295 0 0 0\n")}) {
        const Expected<Mesh> mesh = opened("bomb.ply", header + rest);
        ASSERT_FALSE(mesh);
        expectSentence(mesh.error(), "bomb.ply");
    }
}

TEST(MeshOff, ReadsPolygonsAndRefusesWrongCounts)
{
    const Expected<Mesh> mesh = opened("a.off", "OFF\n# a comment\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_EQ(mesh->indices.size(), 6u);
    expectSound(*mesh);
    for (const char* text : {"OFF\n4000000000 1 0\n0 0 0\n", "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n4000000000 0 1 2\n", "OFF\n3 1 0\n0 0 0\n",
             "OFX\n", "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 -2\n"}) {
        const Expected<Mesh> bad = opened("bad.off", text);
        ASSERT_FALSE(bad) << text;
        expectSentence(bad.error(), "bad.off");
    }
}

TEST(MeshStl, BinaryAndText)
{
    std::string binary(80, 'x');
    const std::uint32_t count = 2;
    binary.append(reinterpret_cast<const char*>(&count), 4);
    const float corners[2][12] = {{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0}};
    for (const auto& triangle : corners) {
        binary.append(reinterpret_cast<const char*>(triangle), sizeof triangle);
        binary.append(2, '\0');
    }
    const Expected<Mesh> mesh = opened("a.STL", binary);
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_EQ(mesh->indices.size(), 6u);
    expectSound(*mesh);
    const Expected<Mesh> cut = opened("cut.stl", binary.substr(0, 100));
    ASSERT_FALSE(cut);
    expectSentence(cut.error(), "cut.stl");
    const Expected<Mesh> text = opened(
        "t.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n");
    ASSERT_TRUE(text);
    EXPECT_EQ(text->indices.size(), 3u);
}

TEST(MeshGltf, NodeMatricesAndMirrorsKeepTheOutside)
{
    for (const char* scale : {"[2,2,2]", "[-2,2,2]"}) {
        const Expected<Mesh> mesh = opened("a.gltf", tinyGltf("[1,1,1]", scale));
        ASSERT_TRUE(mesh) << message(mesh.error());
        expectSound(*mesh);
        EXPECT_NEAR(mesh->boundsMax.y, 2.f, 1e-6f);
        // The triangle faces +z; mirrored in x it still does.
        const glm::vec3 a = mesh->vertices[mesh->indices[0]].position, b = mesh->vertices[mesh->indices[1]].position,
                        c = mesh->vertices[mesh->indices[2]].position;
        EXPECT_GT(glm::cross(b - a, c - a).z, 0.f) << scale;
        EXPECT_NEAR(mesh->vertices[0].normal.z, 1.f, 1e-5f);
    }
}

TEST(MeshGltf, RefusesWhatReachesBeyondItsBuffer)
{
    const std::pair<const char*, const char*> edits[] = {{"\"count\":3", "\"count\":4"}, {"\"byteLength\":36}", "\"byteLength\":360000}"},
        {"\"bufferView\":0", "\"bufferView\":7"}, {"\"buffer\":0", "\"buffer\":3"}, {"\"POSITION\":0", "\"POSITION\":5"},
        {"\"nodes\":[0]", "\"nodes\":[9]"}, {"\"mesh\":0,", "\"mesh\":0,\"children\":[0],"}, {"\"mesh\":0,", "\"mesh\":4,"},
        {"\"version\":\"2.0\"", "\"version\":\"1.0\""}, {"\"scene\":0,", "\"scene\":0,\"extensionsRequired\":[\"VENDOR_magic\"],"},
        {"\"count\":3", "\"count\":18446744073709551615"}, {"\"bufferView\":0,", "\"bufferView\":0,\"byteOffset\":18446744073709551612,"},
        {"\"bufferView\":0,\"componentType\":5126,\"count\":3", "\"componentType\":5126,\"count\":4000000000"}, {"data:", "missing.bin"}};
    for (const auto& [from, to] : edits) {
        const Expected<Mesh> mesh = opened("bad.gltf", tinyGltf(from, to));
        ASSERT_FALSE(mesh) << to;
        expectSentence(mesh.error(), "bad.gltf");
    }
}

TEST(MeshGltf, RequiredExtensionIsNamed)
{
    const Expected<Mesh> mesh = opened("a.gltf", tinyGltf("\"scene\":0,", "\"scene\":0,\"extensionsRequired\":[\"VENDOR_magic\"],"));
    ASSERT_FALSE(mesh);
    EXPECT_NE(mesh.error().what.find("VENDOR_magic"), std::string::npos);
}

TEST(MeshGltf, DeepNestingIsRefused)
{
    const Expected<Mesh> mesh = opened(
        "deep.gltf", tinyGltf("\"scene\":0,", "\"scene\":0,\"extras\":" + std::string(100000, '[') + std::string(100000, ']') + ","));
    ASSERT_FALSE(mesh);
    expectSentence(mesh.error(), "deep.gltf");
}

TEST(MeshFiles, MissingFolderAndUnknownSuffix)
{
    for (const char* name : {"/nowhere/a.obj", "/nowhere/a.glb", "/nowhere/a.xyz", "", "/tmp"}) {
        const Expected<Mesh> mesh = openMesh(name);
        ASSERT_FALSE(mesh);
        expectSentence(mesh.error(), name);
    }
}

TEST(MeshFiles, CancelledLoadingSaysSo)
{
    std::stop_source stop;
    stop.request_stop();
    const Scratch scratch;
    const Expected<Mesh> mesh = openMesh(scratch.write("a.obj", std::string(kQuad) + "f 1 2 3\n"), {{}, stop.get_token()});
    ASSERT_FALSE(mesh);
    EXPECT_TRUE(isCancelled(mesh.error()));
}

static std::vector<fs::path> meshFilesUnder(const fs::path& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        std::string suffix = entry.path().extension().string();
        std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return char(std::tolower(c)); });
        if (std::set<std::string>{".gltf", ".glb", ".obj", ".ply", ".stl", ".off"}.contains(suffix))
            files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

TEST(MeshFiles, RealFilesOpenWholeOrAreRefusedWithASentence)
{
    const fs::path data = fs::path(RELIEVO_TEST_DATA) / "meshes";
    if (!fs::exists(data))
        GTEST_SKIP() << "no test data at " << data;
    std::size_t opened = 0;
    for (const fs::path& file : meshFilesUnder(data)) {
        SCOPED_TRACE(file.string());
        const Expected<Mesh> mesh = openMesh(file.string());
        if (mesh) {
            ++opened;
            expectSound(*mesh);
        } else {
            expectSentence(mesh.error(), file.filename().string());
        }
    }
    EXPECT_GE(opened, 44u); // all but glTF 1 and the compressed ones
}

// Triangle counts of real files; scenes that show a mesh several times count each time.
TEST(MeshFiles, NoFaceIsLost)
{
    const std::pair<const char*, std::size_t> expected[] = {{"Avocado/glTF/Avocado.gltf", 682}, {"NormalTangentMirrorTest.glb", 5240},
        {"SimpleSparseAccessor.gltf", 12}, {"bunny.ply", 16301}, {"spot.obj", 5856}, {"teapot.obj", 6320}, {"stl/featuretype.STL", 3476},
        {"obj_quirks/concave_polygon.obj", 64}, {"obj_quirks/test_nm.obj", 170}, {"obj_quirks/deg_faces.obj", 4},
        {"obj_quirks/box_UTF16BE.obj", 12}, {"obj_quirks/non_manifold_wrap.obj", 12}, {"ply/fuze_ascii.ply", 1000},
        {"ply/cube_binary_header_with_RN_newline.ply", 12}, {"obj2gltf/box-negative-indices/box-negative-indices.obj", 12}};
    for (const auto& [name, triangles] : expected) {
        const fs::path file = fs::path(RELIEVO_TEST_DATA) / "meshes" / name;
        if (!fs::exists(file))
            GTEST_SKIP() << "no test data at " << file;
        const Expected<Mesh> mesh = openMesh(file.string());
        ASSERT_TRUE(mesh) << message(mesh.error());
        EXPECT_EQ(mesh->indices.size() / 3, triangles) << name;
    }
}

TEST(MeshFiles, BrokenFilesAreToldNeverSilent)
{
    const fs::path data = fs::path(RELIEVO_TEST_DATA) / "broken";
    if (!fs::exists(data))
        GTEST_SKIP() << "no test data at " << data;
    for (const char* folder : {"mesh", "assimp_gltf", "gltf_validator"}) {
        for (const fs::path& file : meshFilesUnder(data / folder)) {
            SCOPED_TRACE(file.string());
            const Expected<Mesh> mesh = openMesh(file.string());
            if (mesh) {
                expectSound(*mesh);
                EXPECT_FALSE(mesh->warnings.empty());
            } else {
                expectSentence(mesh.error(), file.filename().string());
            }
        }
    }
}
