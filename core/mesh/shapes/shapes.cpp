// Plane, sphere, cylinder, torus, box and spheres in a plane by formula.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shapes/shapes.h"
#include "core/mesh/frames/frames.h"
#include "core/mesh/shapes/character.h"
#include "core/mesh/shapes/knight.h"
#include "core/mesh/shapes/room.h"
#include "core/mesh/shapes/shape_grid.h"
#include "core/mesh/shapes/teapot.h"
#include <cmath>

namespace relievo {

namespace {
void makePlane(Mesh& mesh)
{
    addGrid(mesh, 1, 1, [](float s, float t) { return Point{{s - 0.5f, 0.f, t - 0.5f}, {0.f, 1.f, 0.f}, {s, t}}; });
}

// 2 tiles x tiles. At a pole each triangle has its own vertex with the UV of its middle, so that the pinch stays a point.
void addSphere(Mesh& mesh, glm::vec3 centre, float radius, float tiles)
{
    constexpr unsigned kColumns = 80, kRows = 40;
    addGrid(mesh, kColumns, kRows, [&](float s, float t) {
        const float polar = kPi * t;
        const bool north = t == 0.f, south = t == 1.f;
        const float ring = north || south ? 0.f : std::sin(polar);
        const glm::vec3 n = around(s) * ring + glm::vec3(0.f, north ? 1.f : south ? -1.f : std::cos(polar), 0.f);
        const float halfCell = north ? 0.5f / kColumns : south ? -0.5f / kColumns : 0.f;
        return Point{centre + radius * n, n, {2.f * tiles * (s + halfCell), tiles * t}};
    });
}

void makeSphere(Mesh& mesh)
{
    addSphere(mesh, glm::vec3(0.f), 0.5f, 2.f);
}

// Plain spheres half sunk into a plane with relief (Policarpo, Oliveira and Comba 2005, figure 18): they meet where the relief does.
void makeSpheres(Mesh& mesh)
{
    makePlane(mesh);
    const auto plane = std::uint32_t(mesh.indices.size());
    addSphere(mesh, {-0.2f, 0.f, -0.16f}, 0.2f, 1.f);
    addSphere(mesh, {0.22f, 0.f, -0.04f}, 0.14f, 1.f);
    addSphere(mesh, {-0.06f, 0.f, 0.27f}, 0.09f, 0.5f);
    mesh.parts = {{"Plane", "material", 0, plane}, {"Spheres", "material", plane, std::uint32_t(mesh.indices.size()) - plane, 0.f}};
}

// The side is 4 x 2 tiles of 0.5 m; the caps carry tiles of the same size.
void makeCylinder(Mesh& mesh)
{
    constexpr float kRadius = 1.f / kPi, kTile = 0.5f;
    constexpr unsigned kColumns = 72;
    addGrid(mesh, kColumns, 16, [](float s, float t) {
        return Point{kRadius * around(s) + glm::vec3(0.f, 0.5f - t, 0.f), around(s), {4.f * s, 2.f * t}};
    });
    for (const float side : {1.f, -1.f}) {
        addGrid(mesh, kColumns, 8, [side](float s, float t) {
            // Looking down on the top s must run against the side's turn for the triangles to face outwards.
            const float turn = std::round((side > 0.f ? s : 1.f - s) * float(kColumns)) / float(kColumns); // the side's own angles
            const glm::vec3 p = kRadius * t * around(turn);
            return Point{p + glm::vec3(0.f, 0.5f * side, 0.f), {0.f, side, 0.f}, {0.5f + p.x / kTile, 0.5f + side * p.z / kTile}};
        });
    }
}

// 5 x 2 tiles; u runs around the hole.
void makeTorus(Mesh& mesh)
{
    constexpr float kTube = 1.f / 7.f, kRing = 0.5f - kTube;
    addGrid(mesh, 120, 48, [](float s, float t) {
        const float angle = 2.f * kPi * (t - std::floor(t)); // from the inside over the top to the outside
        const glm::vec3 n = around(s) * -std::cos(angle) + glm::vec3(0.f, std::sin(angle), 0.f);
        return Point{kRing * around(s) + kTube * n, n, {5.f * s, 2.f * t}};
    });
}

// Each side shows one whole tile, upright on the four walls.
void makeBox(Mesh& mesh)
{
    struct Side {
        glm::vec3 normal, right, down;
    };
    constexpr Side kSides[] = {
        {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
        {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
        {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
        {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
        {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
        {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    };
    for (const Side& side : kSides) {
        addGrid(mesh, 1, 1, [&side](float s, float t) {
            return Point{0.5f * side.normal + (s - 0.5f) * side.right + (t - 0.5f) * side.down, side.normal, {s, t}};
        });
    }
}

struct ShapeRow {
    std::string_view key, label;
    void (*make)(Mesh&);
};
constexpr ShapeRow kRows[] = {
    {"plane", "Plane", makePlane},
    {"sphere", "Sphere", makeSphere},
    {"cylinder", "Cylinder", makeCylinder},
    {"torus", "Torus", makeTorus},
    {"box", "Box", makeBox},
    {"teapot", "Teapot", makeTeapot},
    {"spheres", "Spheres", makeSpheres},
    {"character", "Character", makeCharacter},
    {"room", "Room", makeRoom},
    {"knight", "Knight", makeKnight},
};
static_assert(std::size(kRows) == kShapes.size());
} // namespace

std::optional<Mesh> makeShape(std::string_view key)
{
    for (const ShapeRow& row : kRows) {
        if (row.key != key)
            continue;
        Mesh mesh;
        mesh.name = row.label;
        row.make(mesh);
        if (mesh.parts.empty())
            mesh.parts = {{mesh.name, "material", 0, std::uint32_t(mesh.indices.size())}};
        mesh.fileVertices = mesh.vertices.size();
        completeFrames(mesh);
        return mesh;
    }
    return std::nullopt;
}

} // namespace relievo
