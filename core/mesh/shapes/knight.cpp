// Tubes along curves, of elliptic sections.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shapes/knight.h"
#include "core/mesh/shapes/shape_grid.h"
#include <algorithm>
#include <glm/common.hpp>
#include <span>

namespace relievo {

namespace {
// Where a tube's middle goes in the plane of x and y, and its half widths in that plane and along z; m.
struct Station {
    glm::vec2 middle, half;
};
struct Tube {
    std::span<const Station> stations; // at least two
    float z = 0.f; // of the first station
    float spread = 0.f; // how far it moves along z up to the last
    float tilesAround = 1.f;
    unsigned columns = 40, rows = 60;
    float waves = 0.f; // along it, of its width in the plane
    float cap = 0.6f; // length of its rounded ends over its half width there; little: flat ends
};

// The base from its top down: stations at its axis make a body of revolution.
constexpr Station kBase[] = {{{0.f, -0.13f}, {0.17f, 0.17f}}, {{0.f, -0.2f}, {0.19f, 0.19f}}, {{0.f, -0.235f}, {0.235f, 0.235f}},
    {{0.f, -0.27f}, {0.235f, 0.235f}}, {{0.f, -0.3f}, {0.19f, 0.19f}}, {{0.f, -0.345f}, {0.215f, 0.215f}}, {{0.f, -0.39f}, {0.28f, 0.28f}},
    {{0.f, -0.42f}, {0.3f, 0.3f}}, {{0.f, -0.47f}, {0.3f, 0.3f}}};
constexpr Station kNeck[] = {{{0.29f, 0.125f}, {0.05f, 0.045f}}, {{0.255f, 0.17f}, {0.06f, 0.055f}}, {{0.195f, 0.245f}, {0.075f, 0.062f}},
    {{0.13f, 0.31f}, {0.075f, 0.075f}}, {{0.035f, 0.345f}, {0.08f, 0.08f}}, {{-0.06f, 0.28f}, {0.09f, 0.085f}},
    {{-0.085f, 0.16f}, {0.11f, 0.095f}}, {{-0.07f, 0.04f}, {0.155f, 0.11f}}, {{-0.03f, -0.09f}, {0.165f, 0.13f}},
    {{0.f, -0.21f}, {0.15f, 0.145f}}};
constexpr Station kMane[] = {{{0.02f, 0.385f}, {0.025f, 0.02f}}, {{-0.07f, 0.385f}, {0.04f, 0.028f}}, {{-0.16f, 0.3f}, {0.05f, 0.03f}},
    {{-0.2f, 0.18f}, {0.05f, 0.03f}}, {{-0.21f, 0.05f}, {0.045f, 0.028f}}, {{-0.185f, -0.08f}, {0.03f, 0.02f}}};
constexpr Station kCheek[] = {{{0.115f, 0.235f}, {0.08f, 0.084f}}, {{0.08f, 0.265f}, {0.09f, 0.09f}}};
constexpr Station kEar[] = {{{0.005f, 0.47f}, {0.01f, 0.008f}}, {{0.015f, 0.42f}, {0.03f, 0.02f}}, {{0.035f, 0.33f}, {0.04f, 0.03f}}};

// A cubic B-spline by the stations: near them, and without a kink in its bend.
template <class Member> Member between(std::span<const Station> stations, Member Station::*member, float at)
{
    const int last = int(stations.size()) - 1, i = std::clamp(int(at), 0, last - 1);
    const float f = at - float(i), g = 1.f - f;
    const auto value = [&](int k) { return stations[std::size_t(std::clamp(k, 0, last))].*member; };
    return (g * g * g * value(i - 1) + (4.f + 3.f * f * f * (f - 2.f)) * value(i) + (4.f + 3.f * g * g * (g - 2.f)) * value(i + 1)
               + f * f * f * value(i + 2))
        / 6.f;
}

// t in [0, 1]; a quarter of the way is spent on the rounded ends.
glm::vec3 pointOf(const Tube& tube, float s, float t)
{
    constexpr float kCap = 0.125f;
    const float inner = std::clamp((t - kCap) / (1.f - 2.f * kCap), 0.f, 1.f), at = inner * float(tube.stations.size() - 1);
    const float angle = 0.5f * kPi * std::min(std::min(t, 1.f - t) / kCap, 1.f); // 0 at the tip
    const float step = 1e-2f, most = float(tube.stations.size() - 1);
    const glm::vec2 way = glm::normalize(between(tube.stations, &Station::middle, std::min(at + step, most))
        - between(tube.stations, &Station::middle, std::max(at - step, 0.f)));
    const glm::vec2 half = between(tube.stations, &Station::half, at);
    const float width = half.x * (1.f + 0.12f * std::sin(2.f * kPi * tube.waves * inner));
    const float turn = 2.f * kPi * (s - std::floor(s)), round = std::sin(angle);
    const float cap = std::cos(angle) * tube.cap * std::min(half.x, half.y) * (t < 0.5f ? -1.f : 1.f);
    const glm::vec2 middle = between(tube.stations, &Station::middle, at) + way * cap;
    const glm::vec2 across{way.y, -way.x}; // way x z, to the right
    return glm::vec3(middle + across * (width * round * std::cos(turn)), tube.z + tube.spread * inner + half.y * round * std::sin(turn));
}

glm::vec3 normalOf(const Tube& tube, float s, float t)
{
    const float step = 1e-3f, inside = std::clamp(t, 0.02f, 0.98f);
    if (t <= 0.f || t >= 1.f) // of the tip: the mean around it
        return glm::normalize(
            normalOf(tube, 0.f, inside) + normalOf(tube, 0.25f, inside) + normalOf(tube, 0.5f, inside) + normalOf(tube, 0.75f, inside));
    const glm::vec3 across = pointOf(tube, s + step, t) - pointOf(tube, s - step, t);
    const glm::vec3 down = pointOf(tube, s, t + step) - pointOf(tube, s, t - step);
    return glm::normalize(glm::cross(down, across));
}

void addTube(Mesh& mesh, const Tube& tube)
{
    // v grows with the way down over the girth there, so that texels are square.
    std::vector<float> v(tube.rows + 1, 0.f);
    for (unsigned j = 1; j <= tube.rows; ++j) {
        const float before = float(j - 1) / float(tube.rows), here = float(j) / float(tube.rows), middle = 0.5f * (before + here);
        const float half = 0.25f
            * (glm::distance(pointOf(tube, 0.f, middle), pointOf(tube, 0.5f, middle))
                + glm::distance(pointOf(tube, 0.25f, middle), pointOf(tube, 0.75f, middle)));
        v[j] = v[j - 1]
            + glm::distance(pointOf(tube, 0.25f, before), pointOf(tube, 0.25f, here)) * tube.tilesAround
                / (2.f * kPi * std::max(half, 0.02f));
    }
    addGrid(mesh, tube.columns, tube.rows, [&](float s, float t) {
        return Point{pointOf(tube, s, t), normalOf(tube, s, t), {tube.tilesAround * s, v[std::size_t(std::lround(t * float(tube.rows)))]}};
    });
}
} // namespace

void makeKnight(Mesh& mesh)
{
    addTube(mesh, {.stations = kBase, .tilesAround = 4.f, .columns = 64, .rows = 192, .cap = 0.2f});
    addTube(mesh, {.stations = kNeck, .tilesAround = 3.f, .columns = 56, .rows = 96});
    addTube(mesh, {.stations = kMane, .tilesAround = 1.f, .columns = 32, .rows = 128, .waves = 6.f});
    addTube(mesh, {.stations = kCheek, .tilesAround = 2.f, .columns = 40, .rows = 48, .cap = 1.f});
    for (const float side : {-1.f, 1.f})
        addTube(mesh, {.stations = kEar, .z = side * 0.055f, .spread = side * -0.015f, .columns = 24, .rows = 40});
    // 1 m high, its box around the origin.
    glm::vec3 low = mesh.vertices.front().position, high = low;
    for (const Vertex& vertex : mesh.vertices)
        low = glm::min(low, vertex.position), high = glm::max(high, vertex.position);
    for (Vertex& vertex : mesh.vertices)
        vertex.position = (vertex.position - 0.5f * (low + high)) / (high.y - low.y);
}

} // namespace relievo
