// Floor, walls and table from quads; what stands there from the other shapes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shapes/room.h"
#include "core/mesh/shapes/character.h"
#include "core/mesh/shapes/shape_grid.h"
#include "core/mesh/shapes/teapot.h"
#include <utility>

namespace relievo {

namespace {
constexpr float kTilesPerMetre = 5.f, kHeight = 0.8f; // m, of the walls
constexpr float kTableTop = 0.3f; // m above the floor

// A flat piece: its middle, half of its sides to the right and down as seen from in front.
void addQuad(Mesh& mesh, glm::vec3 middle, glm::vec3 right, glm::vec3 down)
{
    const glm::vec3 normal = glm::normalize(glm::cross(down, right));
    const glm::vec2 tiles = 2.f * kTilesPerMetre * glm::vec2(glm::length(right), glm::length(down));
    addGrid(mesh, 1, 1, [&](float s, float t) {
        return Point{middle + (2.f * s - 1.f) * right + (2.f * t - 1.f) * down, normal, {tiles.x * s, tiles.y * t}};
    });
}

void addBox(Mesh& mesh, glm::vec3 middle, glm::vec3 half)
{
    const glm::vec3 x(half.x, 0.f, 0.f), y(0.f, half.y, 0.f), z(0.f, 0.f, half.z);
    addQuad(mesh, middle + z, x, -y);
    addQuad(mesh, middle - z, -x, -y);
    addQuad(mesh, middle + x, -z, -y);
    addQuad(mesh, middle - x, z, -y);
    addQuad(mesh, middle + y, x, z);
    addQuad(mesh, middle - y, x, -z);
}

// Scaled and turned about y so that its lowest point stands at `foot`.
void addThing(Mesh& mesh, const Mesh& thing, float scale, float degrees, glm::vec3 foot)
{
    float lowest = 0.f;
    for (const Vertex& vertex : thing.vertices)
        lowest = std::min(lowest, vertex.position.y);
    const float c = std::cos(degrees * kPi / 180.f), s = std::sin(degrees * kPi / 180.f);
    const auto turned = [c, s](glm::vec3 v) { return glm::vec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x); };
    const auto first = std::uint32_t(mesh.vertices.size());
    for (const Vertex& vertex : thing.vertices) {
        Vertex placed = vertex;
        placed.position = foot + scale * turned(vertex.position - glm::vec3(0.f, lowest, 0.f));
        placed.normal = turned(vertex.normal);
        mesh.vertices.push_back(placed);
    }
    for (const std::uint32_t index : thing.indices)
        mesh.indices.push_back(first + index);
}

// What was added since the last part.
void endPart(Mesh& mesh, const char* name, float relief)
{
    const std::uint32_t first = mesh.parts.empty() ? 0 : mesh.parts.back().firstIndex + mesh.parts.back().indexCount;
    mesh.parts.push_back({name, "material", first, std::uint32_t(mesh.indices.size()) - first, relief});
}

void addTable(Mesh& mesh, glm::vec3 middle)
{
    constexpr float kThick = 0.012f; // half of the top and of a leg
    constexpr glm::vec2 kHalf(0.24f, 0.17f);
    addBox(mesh, middle + glm::vec3(0.f, kTableTop - kThick, 0.f), {kHalf.x, kThick, kHalf.y});
    const float leg = 0.5f * kTableTop - kThick;
    for (const float x : {-1.f, 1.f})
        for (const float z : {-1.f, 1.f})
            addBox(mesh, middle + glm::vec3(x * (kHalf.x - 2.f * kThick), leg, z * (kHalf.y - 2.f * kThick)), {kThick, leg, kThick});
}
} // namespace

void makeRoom(Mesh& mesh)
{
    const glm::vec3 floor(0.f, -0.5f * kHeight, 0.f), table = floor + glm::vec3(0.05f, 0.f, -0.12f);
    addQuad(mesh, floor, {0.5f, 0.f, 0.f}, {0.f, 0.f, 0.5f});
    addQuad(mesh, {0.f, 0.f, -0.5f}, {0.5f, 0.f, 0.f}, {0.f, -0.5f * kHeight, 0.f});
    addQuad(mesh, {-0.5f, 0.f, 0.f}, {0.f, 0.f, -0.5f}, {0.f, -0.5f * kHeight, 0.f});
    endPart(mesh, "Room", 1.f);
    addTable(mesh, table);
    endPart(mesh, "Table", 0.f);
    Mesh teapot, figure;
    makeTeapot(teapot);
    makeCharacter(figure);
    addThing(mesh, teapot, 0.3f, 25.f, table + glm::vec3(-0.02f, kTableTop, 0.f));
    endPart(mesh, "Teapot", 0.5f);
    addThing(mesh, figure, 0.62f, 35.f, floor + glm::vec3(-0.33f, 0.f, 0.16f));
    endPart(mesh, "Figure", 0.8f);
}

} // namespace relievo
