// What `relievo info` says about a mesh that could be mended.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/shapes.h"
#include "tests/core/mesh/mesh_support.h"
#include <map>

using namespace relievo;

namespace {
// Code and leading number of each fault.
std::map<std::string, int> faultsOf(const std::string& obj)
{
    const Expected<Mesh> mesh = opened("a.obj", obj);
    EXPECT_TRUE(mesh);
    std::map<std::string, int> faults;
    for (const Warning& warning : inspectMesh(mesh.value_or(Mesh{})))
        faults[warning.code] = std::stoi(warning.text);
    return faults;
}
using Faults = std::map<std::string, int>;
const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 -1\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nvn 0 0 -1\n";
} // namespace

TEST(MeshInspect, ShapesHaveNoFaults)
{
    for (const std::string_view shape : kShapes)
        EXPECT_TRUE(inspectMesh(*openMesh(std::string(shape))).empty()) << shape;
}

TEST(MeshInspect, EachFaultIsCounted)
{
    EXPECT_EQ(faultsOf(kPoints + "f 1/1/1 2/2/1 3/3/1\n"), Faults());
    EXPECT_EQ(faultsOf(kPoints + "f 1/1/2 2/2/2 3/3/2\n"), (Faults{{"flipped-normals", 1}}));
    EXPECT_EQ(faultsOf(kPoints + "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 2/2/1 2/3/1\n"), (Faults{{"degenerate-triangles", 1}}));
    EXPECT_EQ(faultsOf(kPoints + "f 1/1/1 2/1/1 3/1/1\n"), (Faults{{"degenerate-uvs", 1}}));
    EXPECT_EQ(faultsOf(kPoints + "f 1/1 2/2 3/3\nf 1/1 2/2 4/3\nf 2/2 1/1 5/3\n"), (Faults{{"non-manifold-edges", 1}}));
    EXPECT_EQ(faultsOf(kPoints + "v 0 0 0\nf 1/1/1 2/2/1 3/3/1\nf 6/1/1 2/2/1 3/3/1\n"), (Faults{{"duplicate-vertices", 1}}));
}

TEST(MeshInspect, NormalsOfNoDirectionAreTold)
{
    const Expected<Mesh> mesh = opened("a.obj", kPoints + "vn 0 0 0\nf 1/1/3 2/2/3 3/3/3\n");
    ASSERT_TRUE(mesh);
    EXPECT_TRUE(told(*mesh, "normals-repaired"));
}

TEST(MeshParts, PlainPartsHaveNoReliefOrAnotherMaterialThanTheChosen)
{
    Mesh mesh;
    mesh.parts = {{"a", "stone", 0, 3}, {"b", "wood", 3, 3}, {"c", "stone", 6, 3, 0.f}, {"d", "", 9, 3}};
    const std::pair<const char*, std::vector<char>> expected[]
        = {{"", {0, 0, 1, 0}}, {"stone", {0, 1, 1, 1}}, {"wood", {1, 0, 1, 1}}, {"of another mesh", {0, 0, 1, 0}}};
    for (const auto& [chosen, plain] : expected)
        EXPECT_EQ(plainParts(mesh, chosen), plain) << chosen;
}
