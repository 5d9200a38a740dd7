// Damaged mesh files of every format open sound or are refused with a sentence.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/fuzz_rounds.h"
#include "tests/core/mesh/mesh_support.h"

using namespace relievo;

TEST(MeshFuzz, MutatedFilesOpenSoundOrAreRefused)
{
    std::string glb = "glTF";
    {
        std::string json
            = tinyGltf(R"(,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA")", "");
        json.resize((json.size() + 3) / 4 * 4, ' ');
        const float points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        const auto put = [&glb](std::uint32_t v) { glb.append(reinterpret_cast<const char*>(&v), 4); };
        put(2);
        put(std::uint32_t(12 + 8 + json.size() + 8 + sizeof points));
        put(std::uint32_t(json.size()));
        put(0x4E4F534A);
        glb += json;
        put(sizeof points);
        put(0x004E4942);
        glb.append(reinterpret_cast<const char*>(points), sizeof points);
    }
    std::string stl(80, ' ');
    stl += std::string("\2\0\0\0", 4) + std::string(100, '\x3f');
    const std::string plyHeader
        = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int "
          "vertex_indices\nend_header\n";
    const std::pair<const char*, std::string> seeds[] = {{"a.glb", glb}, {"a.gltf", tinyGltf()},
        {"a.obj", std::string(kQuad) + "vn 0 0 1\no a\nusemtl b\nf 1/1/1 2/2/1 3/3/1 4/4/1\nl 1 2\n"},
        {"a.ply", "ply\nformat ascii 1.0\n" + plyHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"b.ply",
            "ply\nformat binary_little_endian 1.0\n" + plyHeader + std::string(36, '\x3f') + std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13)},
        {"a.stl", stl},
        {"t.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"},
        {"a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"}};
    std::mt19937 random(20240607);
    const int rounds = fuzzRounds(150);
    const Scratch scratch;
    ASSERT_TRUE(openMesh(scratch.write("seed.glb", glb)));
    for (const auto& [name, bytes] : seeds) {
        for (int round = 0; round < rounds; ++round) {
            const std::string file = scratch.write(name, mutated(bytes, random));
            const Expected<Mesh> mesh = openMesh(file);
            if (mesh)
                expectSound(*mesh);
            else
                expectSentence(mesh.error(), name);
            ASSERT_FALSE(testing::Test::HasFailure()) << name << " round " << round;
        }
    }
}

// Found by the above: the squares of such sizes are 0 in float.
TEST(MeshFuzz, ATinyMeshWithoutUVsHasTangents)
{
    const Scratch scratch;
    const Expected<Mesh> mesh = openMesh(scratch.write("a.obj", "v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n"));
    if (mesh)
        expectSound(*mesh);
    else
        expectSentence(mesh.error(), "a.obj");
}
