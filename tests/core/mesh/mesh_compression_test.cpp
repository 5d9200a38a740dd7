// glTF files compressed by Draco and meshoptimizer open as the mesh that they were made from; broken ones are a sentence.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/mesh/mesh_support.h"
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <functional>
#include <glm/trigonometric.hpp>
#include <meshoptimizer.h>

using namespace relievo;

namespace {
constexpr int kSide = 12; // vertices along a side of a curved sheet

glm::vec2 uvAt(int i)
{
    return glm::vec2(float(i % kSide), float(i / kSide)) / float(kSide - 1);
}
glm::vec3 pointAt(glm::vec2 uv)
{
    return {uv.x, 1.f - uv.y, 0.25f * std::sin(3.f * uv.x) * std::cos(2.f * uv.y)};
}

std::vector<std::uint32_t> sheetIndices()
{
    std::vector<std::uint32_t> indices;
    for (std::uint32_t y = 0; y + 1 < kSide; ++y)
        for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
            const std::uint32_t a = y * kSide + x, b = a + kSide;
            indices.insert(indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    return indices;
}

// Every vertex lies where its UV says, and the triangles cover the whole sheet once.
void expectSheet(const Expected<Mesh>& mesh, float tolerance)
{
    ASSERT_TRUE(mesh) << message(mesh.error());
    expectSound(*mesh);
    EXPECT_EQ(mesh->indices.size(), sheetIndices().size());
    EXPECT_TRUE(mesh->fileHasUVs);
    float covered = 0;
    for (std::size_t i = 0; i < mesh->indices.size(); i += 3) {
        glm::vec2 uv[3];
        for (std::size_t k = 0; k < 3; ++k)
            uv[k] = mesh->vertices[mesh->indices[i + k]].uv;
        covered += 0.5f * ((uv[1].x - uv[0].x) * (uv[2].y - uv[0].y) - (uv[1].y - uv[0].y) * (uv[2].x - uv[0].x));
    }
    EXPECT_NEAR(std::abs(covered), 1.f, 0.01f + tolerance);
    const glm::vec3 shift = mesh->vertices[0].position - pointAt(mesh->vertices[0].uv);
    for (const Vertex& vertex : mesh->vertices)
        EXPECT_LT(glm::distance(vertex.position, pointAt(vertex.uv) + shift), tolerance);
}

// A file of one primitive, its buffer 0 in base64. `lists`: accessors, bufferViews and further members, each ending in a comma.
std::string gltf(const std::string& bytes, const std::string& extension, const std::string& primitive, const std::string& lists,
    const std::string& moreBuffers = "")
{
    return R"({"asset":{"version":"2.0"},"extensionsUsed":[")" + extension + R"("],"extensionsRequired":[")" + extension
        + R"("],"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[)" + primitive + "]}]," + lists
        + "\"buffers\":[{\"byteLength\":" + std::to_string(bytes.size()) + ",\"uri\":\"data:application/octet-stream;base64,"
        + GltfBuffer::base64(bytes) + "\"}" + moreBuffers + "]}";
}

std::string dracoFile(const std::function<void(std::string&)>& spoil = {})
{
    const std::vector<std::uint32_t> indices = sheetIndices();
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(int(indices.size() / 3));
    const int point = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        glm::vec2 uvs[3];
        glm::vec3 points[3];
        for (std::size_t k = 0; k < 3; ++k)
            uvs[k] = uvAt(int(indices[i + k])), points[k] = pointAt(uvs[k]);
        const draco::FaceIndex face = draco::FaceIndex(std::uint32_t(i / 3));
        builder.SetAttributeValuesForFace(point, face, &points[0], &points[1], &points[2]);
        builder.SetAttributeValuesForFace(uv, face, &uvs[0], &uvs[1], &uvs[2]);
    }
    const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, 12);
    draco::EncoderBuffer out;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &out).ok());
    std::string bytes(out.data(), out.size());
    if (spoil)
        spoil(bytes);
    const std::string count = std::to_string(mesh->num_points());
    return gltf(bytes, "KHR_draco_mesh_compression",
        R"({"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":)"
            + std::to_string(mesh->attribute(point)->unique_id()) + ",\"TEXCOORD_0\":" + std::to_string(mesh->attribute(uv)->unique_id())
            + "}}}}",
        R"("accessors":[{"componentType":5126,"type":"VEC3","count":)" + count + R"(},{"componentType":5126,"type":"VEC2","count":)" + count
            + R"(},{"componentType":5123,"type":"SCALAR","count":)" + std::to_string(indices.size())
            + "}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":" + std::to_string(bytes.size()) + "}],");
}

template <class T> std::string meshoptVertices(const std::vector<T>& values, std::size_t count)
{
    const std::size_t stride = values.size() * sizeof(T) / count;
    std::string out(meshopt_encodeVertexBufferBound(count, stride), '\0');
    out.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(), values.data(), count, stride));
    return out;
}

std::string meshoptIndices(const std::vector<std::uint32_t>& indices, bool triangles)
{
    const std::size_t points = kSide * kSide;
    std::string out(
        triangles ? meshopt_encodeIndexBufferBound(indices.size(), points) : meshopt_encodeIndexSequenceBound(indices.size(), points),
        '\0');
    auto* at = reinterpret_cast<unsigned char*>(out.data());
    out.resize(triangles ? meshopt_encodeIndexBuffer(at, out.size(), indices.data(), indices.size())
                         : meshopt_encodeIndexSequence(at, out.size(), indices.data(), indices.size()));
    return out;
}

// inExponents: the points as the exponential filter stores them.
std::string meshoptFile(bool triangles, bool inExponents, const std::function<void(std::string&)>& spoil = {})
{
    const std::size_t points = kSide * kSide;
    std::vector<float> positions, uvs;
    for (int i = 0; i < kSide * kSide; ++i) {
        const glm::vec2 uv = uvAt(i);
        const glm::vec3 point = pointAt(uv);
        positions.insert(positions.end(), {point.x, point.y, point.z});
        uvs.insert(uvs.end(), {uv.x, uv.y});
    }
    if (inExponents) {
        std::vector<float> filtered(positions.size());
        meshopt_encodeFilterExp(filtered.data(), points, 12, 20, positions.data());
        positions = filtered;
    }
    const std::vector<std::uint32_t> indices = sheetIndices();
    std::string bytes, views;
    const auto add = [&](const std::string& piece, std::size_t count, int stride, const std::string& mode) {
        views += (views.empty() ? "" : ",") + ("{\"buffer\":1,\"byteLength\":" + std::to_string(count * std::size_t(stride)))
            + ",\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,\"byteOffset\":" + std::to_string(bytes.size())
            + ",\"byteLength\":" + std::to_string(piece.size()) + ",\"byteStride\":" + std::to_string(stride)
            + ",\"count\":" + std::to_string(count) + ",\"mode\":\"" + mode + "}}}";
        bytes += piece;
    };
    add(meshoptVertices(positions, points), points, 12, inExponents ? "ATTRIBUTES\",\"filter\":\"EXPONENTIAL\"" : "ATTRIBUTES\"");
    add(meshoptVertices(uvs, points), points, 8, "ATTRIBUTES\"");
    add(meshoptIndices(indices, triangles), indices.size(), 2, triangles ? "TRIANGLES\"" : "INDICES\"");
    if (spoil)
        spoil(bytes);
    const std::string count = std::to_string(points);
    return gltf(bytes, "EXT_meshopt_compression", R"({"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2})",
        R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" + count
            + R"(},{"bufferView":1,"componentType":5126,"type":"VEC2","count":)" + count
            + R"(},{"bufferView":2,"componentType":5123,"type":"SCALAR","count":)" + std::to_string(indices.size()) + "}],\"bufferViews\":["
            + views + "],",
        ",{\"byteLength\":4096,\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}}");
}
} // namespace

TEST(MeshCompression, DracoOpensAsTheMeshThatItWas)
{
    expectSheet(opened("a.gltf", dracoFile()), 2e-3f);
}

TEST(MeshCompression, MeshoptimizerOpensAsTheMeshThatItWas)
{
    for (const bool triangles : {true, false})
        for (const bool inExponents : {false, true})
            expectSheet(opened("a.gltf", meshoptFile(triangles, inExponents)), 1e-4f);
}

// Whatever the bytes are, the program lives on and tells.
TEST(MeshCompression, BrokenBytesAreASentence)
{
    std::mt19937 random(5);
    for (int round = 0; round < 40; ++round) {
        const auto spoil = [&](std::string& bytes) { bytes = mutated(bytes, random); };
        for (const std::string& file : {dracoFile(spoil), meshoptFile(true, false, spoil)})
            if (const Expected<Mesh> mesh = opened("a.gltf", file); mesh)
                expectSound(*mesh);
            else
                expectSentence(mesh.error(), "a.gltf");
    }
    const auto empty = [](std::string& bytes) { bytes = "xyz"; };
    for (const std::string& file : {dracoFile(empty), meshoptFile(true, false, empty)}) {
        const Expected<Mesh> mesh = opened("a.gltf", file);
        ASSERT_FALSE(mesh);
        expectSentence(mesh.error(), "a.gltf");
    }
}

TEST(MeshCompression, FilesOfOtherProgramsOpen)
{
    const std::filesystem::path folder = std::filesystem::path(RELIEVO_TEST_DATA) / "meshes";
    if (!std::filesystem::exists(folder / "gltf_transform_ext"))
        GTEST_SKIP() << "no test data at " << folder;
    for (const char* name :
        {"gltf_transform_ext/BoxDraco.gltf", "gltf_transform_ext/BoxMeshopt.glb", "gltf_transform_ext/BoxMeshopt.gltf", "Box_Draco.glb"}) {
        const Expected<Mesh> mesh = openMesh((folder / name).string());
        ASSERT_TRUE(mesh) << message(mesh.error());
        expectSound(*mesh);
        EXPECT_EQ(mesh->indices.size(), 36u);
        EXPECT_NEAR(glm::distance(mesh->boundsMin, mesh->boundsMax), std::sqrt(3.f), 1e-3f) << name;
    }
    const Expected<Mesh> truck = openMesh((folder / "CesiumMilkTruck-Draco/CesiumMilkTruck.gltf").string());
    ASSERT_TRUE(truck) << message(truck.error());
    EXPECT_EQ(truck->indices.size() / 3, 3624u);
}
