// Whatever is wrong with a mesh's UVs, sizes or winding: frames, tangents and curvature stay sound.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/frames/curvature.h"
#include "core/mesh/frames/tangents.h"
#include "tests/core/mesh/mesh_support.h"

using namespace relievo;

namespace {
// An n x n grid bent like a bowl, with UVs written by `uv` (text after "vt "; "" writes none).
template <class UV> std::string bowl(int n, UV uv, bool inverted = false)
{
    std::string text;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = double(i) / n - 0.5, z = double(j) / n - 0.5;
            text += "v " + std::to_string(x) + ' ' + std::to_string(x * x + z * z) + ' ' + std::to_string(z) + '\n';
            if (const std::string at = uv(double(i) / n, double(j) / n); !at.empty())
                text += "vt " + at + '\n';
        }
    const bool mapped = text.find("vt") != text.npos;
    const auto corner = [mapped](int at) { return ' ' + std::to_string(at) + (mapped ? '/' + std::to_string(at) : std::string()); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i + 1, b = a + n + 1;
            text += inverted ? "f" + corner(a) + corner(a + 1) + corner(b + 1) + corner(b) + '\n'
                             : "f" + corner(a) + corner(b) + corner(b + 1) + corner(a + 1) + '\n';
        }
    return text;
}

std::string pair(double u, double v)
{
    return std::to_string(u) + ' ' + std::to_string(v);
}

void expectAllSound(const std::string& obj)
{
    const Expected<Mesh> mesh = opened("a.obj", obj);
    ASSERT_TRUE(mesh) << message(mesh.error());
    expectSound(*mesh);
    for (const Curvature& c : vertexCurvatures(*mesh))
        ASSERT_TRUE(std::isfinite(glm::dot(c.full, glm::vec3(1.f)) + c.axes.x + c.axes.y));
    for (const glm::vec4& tangent : cornerTangents(*mesh))
        ASSERT_TRUE(tangent.w == 0.f || std::abs(glm::length(glm::vec3(tangent)) - 1.f) < 1e-3f);
    inspectMesh(*mesh);
}
} // namespace

TEST(MeshBadInput, UVs)
{
    expectAllSound(bowl(8, [](double, double) { return std::string(); }));
    expectAllSound(bowl(8, [](double, double) { return std::string("0.5 0.5"); }));
    expectAllSound(bowl(8, [](double u, double v) { return u < 0.5 ? "nan nan" : pair(u, v); }));
    expectAllSound(bowl(8, [](double u, double v) { return pair(1e6 + u, -1e6 + v); }));
    expectAllSound(bowl(8, [](double u, double v) { return pair(1e12 * u, 1e12 * v); }));
    expectAllSound(bowl(8, [](double u, double v) { return pair(1e-7 * u, v); }));
    expectAllSound(bowl(8, [](double u, double) { return pair(u, u); })); // a line of the image
    expectAllSound(bowl(8, [](double u, double v) { return pair(std::abs(u - 0.5), v); })); // mirrored
}

TEST(MeshBadInput, UVsFarFromZeroKeepTheirFrames)
{
    const Expected<Mesh> mesh = opened("a.obj", bowl(8, [](double u, double v) { return pair(1000.0 + u, v - 500.0); }));
    ASSERT_TRUE(mesh);
    EXPECT_NEAR(mesh->metresPerUV, 1.1f, 0.2f);
}

TEST(MeshBadInput, NeedlesAndSingleTriangles)
{
    expectAllSound("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expectAllSound("v 0 0 0\nv 1000000 0 0\nv 500000 0.000001 0\nvt 0 0\nvt 1 0\nvt 0.5 0.000001\nf 1/1 2/2 3/3\n");
    expectAllSound("v 0 0 0\nv 1e-12 0 0\nv 0 1e-12 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    expectAllSound("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 2/2 4/3\n"); // one without area
}

TEST(MeshBadInput, MoreVerticesThanSixteenBitsCount)
{
    const std::string text = bowl(260, pair);
    const Expected<Mesh> mesh = opened("a.obj", text);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->vertices.size(), 261u * 261u);
    expectSound(*mesh);
}

// Made normals follow the winding, so an inverted bowl is a bowl seen from below: it bends the other way.
TEST(MeshBadInput, InvertedWindingTurnsNormalsAndCurvature)
{
    const Expected<Mesh> up = opened("a.obj", bowl(16, pair)), down = opened("a.obj", bowl(16, pair, true));
    ASSERT_TRUE(up && down);
    expectSound(*down);
    const auto sumOf = [](const Mesh& mesh) {
        float sum = 0.f;
        for (const Curvature& c : vertexCurvatures(mesh))
            sum += c.full.x;
        return sum / float(mesh.vertices.size());
    };
    EXPECT_LT(sumOf(*up), -0.5f);
    EXPECT_GT(sumOf(*down), 0.5f);
}
