// glTF scenes far from the origin keep their detail, at rest and in motion, as meshes of the other formats do.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/animation/pose.h"
#include "tests/core/mesh/mesh_support.h"

using namespace relievo;

namespace {
std::string number(int n)
{
    return std::to_string(n);
}

// A square of 10 cm in xy, mesh 0, and one of 40 km, mesh 1, under the nodes and further members that are given.
std::string squares(const std::string& nodes, const std::string& roots, const std::string& animationOf = "")
{
    GltfBuffer buffer;
    const auto square = [&buffer](float side) { return buffer.floats({0, 0, 0, side, 0, 0, side, side, 0, 0, side, 0}, "VEC3", 3); };
    const int small = square(.1f), large = square(40000.f);
    const int indices = buffer.accessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}, 5121, "SCALAR", 1);
    const int joints = buffer.accessor(std::vector<std::uint8_t>(16, 0), 5121, "VEC4", 4);
    const int weights = buffer.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
    const int times = buffer.floats({0, 1}, "SCALAR", 1), moves = buffer.floats({0, 0, 0, 0, .5f, 0}, "VEC3", 3);
    const auto mesh = [&](int points) {
        return "{\"primitives\":[{\"indices\":" + number(indices) + ",\"attributes\":{\"POSITION\":" + number(points)
            + ",\"JOINTS_0\":" + number(joints) + ",\"WEIGHTS_0\":" + number(weights) + "}}]}";
    };
    const std::string animation = animationOf.empty() ? ""
                                                      : "\"animations\":[{\"samplers\":[{\"input\":" + number(times) + ",\"output\":"
            + number(moves) + "}],\"channels\":[{\"sampler\":0,\"target\":{\"node\":" + animationOf + ",\"path\":\"translation\"}}]}],";
    return buffer.file("\"scenes\":[{\"nodes\":[" + roots + "]}],\"nodes\":[" + nodes + "],\"skins\":[{\"joints\":[1]}]," + animation
        + "\"meshes\":[" + mesh(small) + ',' + mesh(large) + "],");
}

const std::string kFar = "\"translation\":[4500000.25,0,-1000000.5]";

void expectSize(const Mesh& mesh, glm::vec3 size)
{
    EXPECT_LT(glm::distance(mesh.boundsMax - mesh.boundsMin, size), 1e-6f);
    EXPECT_LT(glm::length(mesh.boundsMax), 10.f);
}
} // namespace

TEST(MeshGltfFar, NodesFarFromTheOriginKeepTheirDetail)
{
    // The second lies 13 mm above the first, under another node.
    const Expected<Mesh> mesh = opened("a.gltf",
        squares("{" + kFar
                + ",\"children\":[1]},{\"mesh\":0,\"translation\":[0.001,0,0]},"
                  "{\"translation\":[0,0.013,0],\"children\":[3]},{\"mesh\":0,"
                + kFar + "}",
            "0,2"));
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_TRUE(told(*mesh, "mesh-moved"));
    expectSize(*mesh, glm::vec3(.101f, .113f, 0.f));
    expectSound(*mesh);
}

TEST(MeshGltfFar, WhatMovesThereMovesHere)
{
    const Expected<Mesh> mesh = opened(
        "a.gltf", squares("{" + kFar + ",\"children\":[1]},{\"children\":[2]},{\"mesh\":0,\"translation\":[0,0.013,0]}", "0", "1"));
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_TRUE(told(*mesh, "mesh-moved"));
    const Mesh before = posed(*mesh, poseAt(*mesh, 0, 0.f)), after = posed(*mesh, poseAt(*mesh, 0, 1.f));
    expectSize(before, glm::vec3(.1f, .1f, 0.f));
    expectSize(after, glm::vec3(.1f, .1f, 0.f));
    EXPECT_LT(glm::distance(before.boundsMin, mesh->boundsMin), 1e-6f);
    EXPECT_LT(glm::distance(after.boundsMin, mesh->boundsMin + glm::vec3(0.f, .5f, 0.f)), 1e-6f);
}

// A skin places its mesh whatever the mesh's own node says: the skeleton far, the node far, both far.
TEST(MeshGltfFar, SkinnedMeshesAreWhereTheirSkeletonIs)
{
    for (const bool isMeshFar : {false, true})
        for (const bool isSkeletonFar : {false, true})
            for (const char* animated : {"", "1"}) {
                SCOPED_TRACE(number(isMeshFar) + number(isSkeletonFar) + animated);
                const Expected<Mesh> mesh = opened("a.gltf",
                    squares("{\"mesh\":0,\"skin\":0" + (isMeshFar ? ',' + kFar : "") + "},{},{\"children\":[1]"
                            + (isSkeletonFar ? ',' + kFar : "") + "}",
                        "0,2", animated));
                ASSERT_TRUE(mesh) << message(mesh.error());
                EXPECT_EQ(told(*mesh, "mesh-moved"), isSkeletonFar);
                expectSize(*mesh, glm::vec3(.1f, .1f, 0.f));
                expectSize(posed(*mesh, poseAt(*mesh, 0, 0.f)), glm::vec3(.1f, .1f, 0.f));
            }
}

// Behind a sky, or beside another that is far away, a small thing loses nothing.
TEST(MeshGltfFar, SmallThingsNearTheOriginKeepTheirDetail)
{
    for (const char* other : {"{\"mesh\":1,\"translation\":[-20000,-20000,9000]}", "{\"mesh\":0,\"translation\":[30000,0,0]}"}) {
        const Expected<Mesh> mesh = opened("a.gltf", squares(std::string(other) + ",{\"mesh\":0,\"translation\":[0.0001,0,0]}", "0,1"));
        ASSERT_TRUE(mesh) << message(mesh.error());
        EXPECT_FALSE(told(*mesh, "mesh-moved"));
        float least = 1.f, most = 0.f;
        for (const Vertex& v : mesh->vertices)
            if (glm::length(v.position) < 1.f)
                least = std::min(least, v.position.x), most = std::max(most, v.position.x);
        EXPECT_NEAR(least, .0001f, 1e-7f);
        EXPECT_NEAR(most, .1001f, 1e-7f);
    }
}
