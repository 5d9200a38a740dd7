// What a mesh file holds comes in whole, and what must be left out is told: numbers, faces and comments of the text formats, and STL.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/mesh/mesh_support.h"
#include <limits>
#include <numbers>

using namespace relievo;

namespace {
using Triangle = std::array<glm::vec3, 3>;
const float kNaN = std::numeric_limits<float>::quiet_NaN();

std::vector<Triangle> row(int count)
{
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; ++i)
        triangles.push_back({glm::vec3(i, 0, 0), glm::vec3(i + 1, 0, 0), glm::vec3(i, 1, 0)});
    return triangles;
}

std::string binaryStl(const std::vector<Triangle>& triangles)
{
    std::string file(80, 'x');
    const auto count = std::uint32_t(triangles.size());
    file.append(reinterpret_cast<const char*>(&count), 4);
    for (const Triangle& triangle : triangles) {
        file.append(12, '\0');
        file.append(reinterpret_cast<const char*>(triangle.data()), sizeof triangle);
        file.append(2, '\0');
    }
    return file;
}

std::string facet(const std::string& a, const std::string& b, const std::string& c)
{
    return " facet normal 0 0 1\n  outer loop\n   vertex " + a + "\n   vertex " + b + "\n   vertex " + c + "\n  endloop\n endfacet\n";
}

const std::string kFacet = facet("0 0 0", "1 0 0", "0 1 0");

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

float area(const Mesh& mesh, std::size_t triangle)
{
    const auto at = [&](std::size_t k) { return mesh.vertices[mesh.indices[3 * triangle + k]].position; };
    return 0.5f * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
}

// A face of `corners` corners around a star whose inner corners are `inner` from the middle, outer ones 1.
std::string star(int corners, double inner)
{
    std::string text, face = "f";
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners, radius = i % 2 == 0 ? 1.0 : inner;
        text += "v " + std::to_string(radius * std::cos(angle)) + ' ' + std::to_string(radius * std::sin(angle)) + " 0\n";
        face += ' ' + std::to_string(i + 1);
    }
    return text + face + '\n';
}
} // namespace

TEST(MeshLosses, StlTrianglesThatAreNotFiniteLeaveTheOthersAlone)
{
    const Triangle bad{glm::vec3(kNaN, 0, 0), glm::vec3(100, 5, 0), glm::vec3(100, 7, 0)};
    for (const bool first : {true, false}) {
        std::vector<Triangle> triangles = row(10);
        triangles.insert(first ? triangles.begin() : triangles.end(), bad);
        const Expected<Mesh> mesh = opened("a.stl", binaryStl(triangles));
        ASSERT_TRUE(mesh) << message(mesh.error());
        EXPECT_EQ(mesh->indices.size(), 30u);
        EXPECT_EQ(mesh->boundsMax, glm::vec3(10.f, 1.f, 0.f));
        EXPECT_TRUE(told(*mesh, "triangles-dropped"));
        expectSound(*mesh);
    }
}

TEST(MeshLosses, StlNumbersThatCannotBeReadAreNoOthers)
{
    const std::string bad = facet("1e-600 2 3", "1 0 0", "0 1 0"); // too small for any number: 0
    const Expected<Mesh> small = opened("a.stl", "solid a\n" + bad + kFacet + "endsolid a\n");
    ASSERT_TRUE(small);
    EXPECT_EQ(small->indices.size(), 6u);
    EXPECT_EQ(small->boundsMin, glm::vec3(0.f));
    EXPECT_EQ(small->boundsMax, glm::vec3(1.f, 2.f, 3.f));
    for (const char* word : {"nan", "x"}) {
        const Expected<Mesh> mesh
            = opened("a.stl", "solid a\n" + facet(std::string(word) + " 9 9", "1 0 0", "0 1 0") + kFacet + "endsolid a\n");
        ASSERT_TRUE(mesh) << word;
        EXPECT_EQ(mesh->indices.size(), 3u) << word;
        EXPECT_EQ(mesh->boundsMax, glm::vec3(1.f, 1.f, 0.f)) << word;
        EXPECT_TRUE(told(*mesh, "triangles-dropped")) << word;
    }
}

TEST(MeshLosses, StlFacetsWithTwoCornersAreTold)
{
    const Expected<Mesh> mesh = opened("a.stl", "solid a\n" + replaced(kFacet, "   vertex 0 0 0\n", "") + kFacet + "endsolid a\n");
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->indices.size(), 3u);
    EXPECT_TRUE(told(*mesh, "triangles-dropped"));
}

TEST(MeshLosses, StlInCapitalsAndWithAnyLineEnds)
{
    const std::string text = "solid facet vertex 7 7 7\n" + kFacet + facet("5 0 0", "6 0 0", "5 1 0") + "endsolid a\n";
    std::string capitals = text;
    std::ranges::transform(capitals, capitals.begin(), [](unsigned char c) { return char(std::toupper(c)); });
    for (const std::string& file :
        {text, capitals, replaced(text, "\n", "\r"), replaced(text, "\n", "\r\n"), replaced(text, "\n", " \n")}) {
        const Expected<Mesh> mesh = opened("a.stl", file);
        ASSERT_TRUE(mesh) << file;
        EXPECT_EQ(mesh->indices.size(), 6u) << file;
        EXPECT_EQ(mesh->boundsMax, glm::vec3(6.f, 1.f, 0.f)) << file;
        EXPECT_FALSE(told(*mesh, "triangles-dropped")) << file;
    }
}

TEST(MeshLosses, ObjCommentsEndWithTheirLine)
{
    const Expected<Mesh> mesh = opened("a.obj",
        "# from C:\\models\\\nv 0 0 0\nv 1 0 0 # as in \\\nv 1 1 0\nv 0 1 0\nv 9 9 9\n# twice\\\\\nf 1 2 \\\n 3\nf 1 3 4 # \\\nf 1 2 4\n");
    ASSERT_TRUE(mesh) << message(mesh.error());
    EXPECT_EQ(mesh->indices.size(), 9u);
    EXPECT_EQ(mesh->boundsMax, glm::vec3(1.f, 1.f, 0.f));
}

TEST(MeshLosses, DecimalCommasAreTold)
{
    const std::string ply
        = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
          "property list uchar int vertex_indices\nend_header\n0,5 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    const std::pair<const char*, std::string> files[] = {{"a.obj", "v 0,5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0,5 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"}, {"a.ply", ply},
        {"a.off", "OFF\n3 1 0\n0,5 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"a.stl", "solid\n" + facet("0,5 0 0", "1 0 0", "0 1 0") + "endsolid\n"}};
    for (const auto& [name, text] : files) {
        const Expected<Mesh> cut = opened(name, text), right = opened(name, replaced(text, "0,5", "0.5"));
        ASSERT_TRUE(cut && right) << name;
        EXPECT_TRUE(told(*cut, "numbers-cut")) << name;
        EXPECT_FALSE(told(*right, "numbers-cut")) << name;
    }
}

TEST(MeshLosses, FacesOfTwoCornersAreTold)
{
    const std::string ply
        = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 3\n"
          "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n1 2\n";
    const std::pair<const char*, std::string> files[] = {{"a.ply", ply},
        {"a.off", "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n1 2\n"}, {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\nf 3\n"}};
    for (const auto& [name, text] : files) {
        const Expected<Mesh> mesh = opened(name, text);
        ASSERT_TRUE(mesh) << name;
        EXPECT_EQ(mesh->indices.size(), 3u) << name;
        const auto warning = std::ranges::find(mesh->warnings, "triangles-dropped", &Warning::code);
        ASSERT_NE(warning, mesh->warnings.end()) << name;
        EXPECT_TRUE(warning->text.starts_with("2 faces")) << warning->text;
    }
}

TEST(MeshLosses, PlyListsOfVerticesAreChecked)
{
    const Expected<Mesh> mesh = opened("a.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty list int int foo\nelement "
        "face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 -1\n1 0 0 0\n0 1 0 0\n3 0 1 2\n");
    ASSERT_FALSE(mesh);
    expectSentence(mesh.error(), "a.ply");
}

TEST(MeshLosses, LargeConcavePolygonsAreTold)
{
    const Expected<Mesh> small = opened("a.obj", star(200, 0.5)), large = opened("a.obj", star(1200, 0.5));
    const Expected<Mesh> round = opened("a.obj", star(1200, 1.0));
    ASSERT_TRUE(small && large && round);
    EXPECT_FALSE(told(*small, "polygons-fanned"));
    EXPECT_TRUE(told(*large, "polygons-fanned"));
    EXPECT_FALSE(told(*round, "polygons-fanned"));
}

TEST(MeshLosses, CornersOnStraightSidesKeepTheirArea)
{
    const Expected<Mesh> mesh = opened("a.obj", "v 0 0 0\nv 0.5 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4 5\n");
    ASSERT_TRUE(mesh);
    ASSERT_EQ(mesh->indices.size(), 9u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_GT(area(*mesh, i), 0.1f);
}

TEST(MeshLosses, RepeatedMaterialFilesAreReadAndToldOnce)
{
    const std::string face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
    const Expected<Mesh> mesh = opened("a.obj", "mtllib none.mtl\n" + face + "mtllib none.mtl\n" + face);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(std::ranges::count(mesh->warnings, "material-missing", &Warning::code), 1);
    const Scratch scratch;
    scratch.write("b.mtl", "newmtl m\nmap_Kd gone.png\nnewmtl m\nmap_Kd other.png\n");
    const Expected<Mesh> twice = openMesh(scratch.write("b.obj", "mtllib b.mtl\nmtllib ./b.mtl\nmtllib B.MTL\n" + face));
    ASSERT_TRUE(twice);
    EXPECT_EQ(twice->materials.size(), 1u);
    EXPECT_EQ(std::ranges::count(twice->warnings, "map-missing", &Warning::code), 1);
}

// A grid of 10 cm squares whose first corner lies `far` from the origin, as text of each format.
TEST(MeshLosses, MeshesFarFromTheOriginKeepTheirShapeAndAreToldMoved)
{
    const auto grid = [](const char* before, const char* after, double far) {
        std::string text;
        for (int i = 0; i < 4; ++i) {
            char line[80];
            std::snprintf(line, sizeof line, "%s%.3f 0 %.3f%s\n", before, far + 0.1 * (i % 2), 1.3 * far + 0.1 * (i / 2), after);
            text += line;
        }
        return text;
    };
    const std::string ply
        = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\nelement face 1\n"
          "property list uchar int vertex_indices\nend_header\n";
    for (const double far : {0.0, 4500000.0}) {
        const std::pair<const char*, std::string> files[] = {{"a.obj", grid("v ", "", far) + "f 1 3 4 2\n"},
            {"a.ply", ply + grid("", "", far) + "4 0 2 3 1\n"}, {"a.off", "OFF\n4 1 0\n" + grid("", "", far) + "4 0 2 3 1\n"},
            {"a.stl", "solid\nfacet\n" + grid("vertex ", "", far) + "endfacet\nendsolid\n"}};
        for (const auto& [name, text] : files) {
            const Expected<Mesh> mesh = opened(name, text);
            ASSERT_TRUE(mesh) << name << ": " << message(mesh.error());
            EXPECT_EQ(told(*mesh, "mesh-moved"), far > 0.0) << name;
            EXPECT_LT(glm::distance(mesh->boundsMin, glm::vec3(0.f)), 1e-6f) << name;
            EXPECT_LT(glm::distance(mesh->boundsMax, glm::vec3(0.1f, 0.f, 0.1f)), 1e-6f) << name;
        }
    }
}

TEST(MeshLosses, LargeMeshesStayWhereTheyAre)
{
    const Expected<Mesh> mesh = opened("a.obj", "v 20000.5 0 0\nv 0 0 0\nv 0 20000.5 30000\nf 1 2 3\n");
    ASSERT_TRUE(mesh);
    EXPECT_FALSE(told(*mesh, "mesh-moved"));
    EXPECT_EQ(mesh->boundsMin, glm::vec3(0.f));
    EXPECT_EQ(mesh->boundsMax, glm::vec3(20000.5f, 20000.5f, 30000.f));
}
