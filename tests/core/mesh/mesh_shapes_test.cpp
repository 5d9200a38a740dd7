// The built-in shapes keep the conventions of ARCHITECTURE.md, "Space, sign and unit": size, orientation, UVs, Jacobian and tangents.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.h"
#include "core/state/shapes.h"
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>

using namespace relievo;

static Mesh shape(std::string_view key)
{
    Expected<Mesh> mesh = openMesh(std::string(key));
    EXPECT_TRUE(mesh) << key;
    return mesh.value_or(Mesh{});
}

// The share of the picture's width or height that the mesh takes, whichever is larger.
static float filled(const Mesh& mesh, const Camera& camera, float aspect)
{
    const CameraView view = cameraOnto(mesh, camera, aspect);
    float most = 0.f;
    for (const Vertex& vertex : mesh.vertices) {
        const glm::vec4 clip = view.clipFromView * view.viewFromWorld * glm::vec4(vertex.position, 1.f);
        most = std::max({most, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
    }
    return most;
}

class Shapes : public testing::TestWithParam<std::string_view> { };

TEST_P(Shapes, FillsThePictureAsTheCameraSays)
{
    const Mesh mesh = shape(GetParam());
    for (const float aspect : {0.5f, 1.f, 1.8f})
        for (const float pitch : {0.f, 8.f, 35.f, 90.f})
            for (const float yaw : {-100.f, 0.f, 30.f}) {
                Camera camera;
                camera.yaw = yaw, camera.pitch = pitch, camera.fill = 0.87f;
                const float share = filled(mesh, camera, aspect);
                EXPECT_GE(share, 0.85f) << pitch << ' ' << yaw << ' ' << aspect;
                EXPECT_LE(share, 0.90f) << pitch << ' ' << yaw << ' ' << aspect;
            }
}

TEST_P(Shapes, IsOneMetreAndCentred)
{
    const Mesh mesh = shape(GetParam());
    const glm::vec3 size = mesh.boundsMax - mesh.boundsMin, middle = mesh.boundsMax + mesh.boundsMin;
    EXPECT_NEAR(std::max({size.x, size.y, size.z}), 1.f, 1e-5f);
    EXPECT_LT(glm::length(middle), 1e-5f);
    std::size_t drawn = 0;
    for (const MeshPart& part : mesh.parts)
        drawn += part.firstIndex == drawn ? part.indexCount : 0;
    EXPECT_EQ(drawn, mesh.indices.size());
    EXPECT_TRUE(mesh.warnings.empty());
}

TEST_P(Shapes, TrianglesFaceOutwardsAlongTheirNormals)
{
    const Mesh mesh = shape(GetParam());
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]], &c = mesh.vertices[mesh.indices[i + 2]];
        const glm::vec3 face = glm::cross(b.position - a.position, c.position - a.position);
        EXPECT_GT(glm::length(face), 0.f);
        for (const Vertex* v : {&a, &b, &c})
            EXPECT_GT(glm::dot(v->normal, glm::normalize(face)), 0.9f);
    }
}

TEST_P(Shapes, FramesFollowTheTexture)
{
    const Mesh mesh = shape(GetParam());
    for (const Vertex& v : mesh.vertices) {
        EXPECT_NEAR(glm::length(v.normal), 1.f, 1e-4f);
        EXPECT_NEAR(glm::dot(v.normal, v.dPdu), 0.f, 1e-4f);
        EXPECT_NEAR(glm::dot(v.normal, glm::vec3(v.tangent)), 0.f, 1e-4f);
        EXPECT_NEAR(glm::length(glm::vec3(v.tangent)), 1.f, 1e-4f);
        EXPECT_GT(glm::dot(glm::vec3(v.tangent), v.dPdu), 0.f);
        // glTF's bitangent is image up, which is -v; no shape mirrors the image.
        EXPECT_EQ(v.tangent.w, 1.f);
        EXPECT_GT(glm::dot(glm::cross(v.normal, glm::vec3(v.tangent)) * v.tangent.w, -v.dPdv), 0.f);
    }
}

// Moving by dPdu du + dPdv dv on an edge, with the mean of its ends' Jacobians, must lead to its other end.
TEST_P(Shapes, JacobianPredictsTheEdges)
{
    const Mesh mesh = shape(GetParam());
    double error = 0, length = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]];
        const glm::vec2 d = b.uv - a.uv;
        const glm::vec3 step = 0.5f * ((a.dPdu + b.dPdu) * d.x + (a.dPdv + b.dPdv) * d.y);
        error += double(glm::length(a.position + step - b.position));
        length += double(glm::distance(a.position, b.position));
    }
    EXPECT_LT(error / length, 0.01);
}

TEST_P(Shapes, TexelsAreAboutSquare)
{
    const Mesh mesh = shape(GetParam());
    double sum = 0;
    for (const Vertex& v : mesh.vertices)
        sum += double(std::abs(std::log2(glm::length(v.dPdu) / glm::length(v.dPdv))));
    EXPECT_LT(sum / double(mesh.vertices.size()), 1.0); // poles and the inside of the torus shrink one side
}

INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::ValuesIn(kShapes), [](const auto& row) { return std::string(row.param); });

TEST(ShapesSize, PlaneLiesInXZWithUVsAlongIt)
{
    const Mesh mesh = shape("plane");
    EXPECT_FLOAT_EQ(mesh.metresPerUV, 1.f);
    for (const Vertex& v : mesh.vertices) {
        EXPECT_EQ(v.normal, glm::vec3(0.f, 1.f, 0.f));
        EXPECT_FLOAT_EQ(v.position.x, v.uv.x - 0.5f);
        EXPECT_FLOAT_EQ(v.position.z, v.uv.y - 0.5f);
        EXPECT_LT(glm::distance(v.dPdu, glm::vec3(1.f, 0.f, 0.f)), 1e-6f);
        EXPECT_LT(glm::distance(v.dPdv, glm::vec3(0.f, 0.f, 1.f)), 1e-6f);
    }
}

TEST(ShapesSize, MetresPerUVIsTheRootOfTheAreas)
{
    EXPECT_NEAR(shape("sphere").metresPerUV, std::sqrt(3.14159f / 8.f), 0.01f); // pi m2 over 4 x 2 tiles
    EXPECT_NEAR(shape("cylinder").metresPerUV, 0.5f, 0.001f);
    EXPECT_NEAR(shape("box").metresPerUV, 1.f, 1e-5f);
}

TEST(ShapesSize, SpheresArePlainInAPlaneWithRelief)
{
    const Mesh mesh = shape("spheres");
    ASSERT_EQ(mesh.parts.size(), 2u);
    EXPECT_EQ(mesh.parts[0].relief, 1.f);
    EXPECT_EQ(mesh.parts[0].indexCount, 6u);
    EXPECT_EQ(mesh.parts[1].relief, 0.f);
    EXPECT_FLOAT_EQ(mesh.metresPerUV, 1.f); // the plane's alone
    int under = 0;
    for (const Vertex& v : mesh.vertices)
        under += v.position.y < -0.05f;
    EXPECT_GT(under, 1000); // they are whole
}

// Every piece has whole tiles around: where a vertex has a twin of the same place and normal, their u differ by whole tiles.
TEST(ShapesSize, TeapotsSeamsRepeatWholeTiles)
{
    const Mesh mesh = shape("teapot");
    std::map<std::array<float, 7>, std::vector<float>> ofPlace;
    for (const Vertex& v : mesh.vertices)
        ofPlace[{v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z, v.uv.y}].push_back(v.uv.x);
    int seams = 0;
    for (const auto& [place, u] : ofPlace)
        if (u.size() == 2) { // more of them meet at a pole
            const float apart = std::abs(u[1] - u[0]);
            ++seams;
            EXPECT_GT(apart, 0.5f);
            EXPECT_NEAR(apart, std::round(apart), 1e-4f);
        }
    EXPECT_GT(seams, 200);
}

TEST(MeshJson, SaysWhatTheCommandLinePromises)
{
    const auto json = nlohmann::json::parse(meshJson(shape("box")));
    EXPECT_EQ(json["vertices"], 24);
    EXPECT_EQ(json["triangles"], 12);
    EXPECT_EQ(json["parts"][0]["triangles"], 12);
    EXPECT_EQ(json["uvs"], true);
    EXPECT_EQ(json["normals"], true);
    EXPECT_EQ(json["tangents"], false);
    EXPECT_EQ(json["bounds"][0][0], -0.5);
    EXPECT_TRUE(json["warnings"].empty());
}
