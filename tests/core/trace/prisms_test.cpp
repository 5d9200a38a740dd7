// The walk through prisms against meshes that were moved along their normals, which a constant height is, and against formulas.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shapes/shapes.h"
#include "core/trace/prisms.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

using namespace relievo;

namespace {

using Corners = std::array<glm::vec3, 3>;

// m along the ray to the triangle's front.
std::optional<float> hitFront(const Corners& corners, glm::vec3 origin, glm::vec3 way)
{
    const glm::dvec3 a(corners[0]), b(corners[1]), c(corners[2]), o(origin), w(way);
    const glm::dvec3 up = glm::cross(b - a, c - a);
    const double speed = glm::dot(up, w);
    if (!(speed < 0.))
        return {};
    const double s = glm::dot(up, a - o) / speed;
    const glm::dvec3 p = o + w * s;
    const auto inside = [&](glm::dvec3 from, glm::dvec3 to) { return glm::dot(glm::cross(to - from, p - from), up) >= 0.; };
    return s > 0. && inside(a, b) && inside(b, c) && inside(c, a) ? std::optional(float(s)) : std::nullopt;
}

struct Front {
    float way;
    int triangle;
};
std::vector<Front> frontsOf(const std::vector<Corners>& surface, glm::vec3 origin, glm::vec3 way)
{
    std::vector<Front> fronts;
    for (std::size_t i = 0; i < surface.size(); ++i)
        if (const auto s = hitFront(surface[i], origin, way))
            fronts.push_back({*s, int(i)});
    std::ranges::sort(fronts, {}, &Front::way);
    return fronts;
}

std::vector<Corners> outerSurface(const Prisms& prisms, std::size_t triangles)
{
    std::vector<Corners> corners(triangles);
    for (std::size_t i = 0; i < triangles; ++i)
        for (int k = 0; k < 3; ++k)
            corners[i][std::size_t(k)] = prisms.outerCorner(int(i), k);
    return corners;
}

// What a picture of the prisms has: the first front that is not cut off.
PrismRayHit seenThrough(const Prisms& prisms, const std::vector<Front>& fronts, glm::vec3 origin, glm::vec3 way)
{
    for (const Front& front : fronts)
        if (const PrismRayHit hit = prisms.hit(front.triangle, origin + way * front.way, way); hit.found)
            return hit;
    return {};
}

// Moved in along the normals.
std::vector<Corners> moved(const Mesh& mesh, float by)
{
    std::vector<Corners> corners(mesh.indices.size() / 3);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const Vertex& v = mesh.vertices[mesh.indices[i]];
        corners[i / 3][i % 3] = v.position - v.normal * by;
    }
    return corners;
}

struct Eye {
    glm::vec3 origin, way;
};
// Rays towards the mesh from several sides, its outline among them.
std::vector<Eye> eyesAround(int side)
{
    std::vector<Eye> eyes;
    for (const glm::vec3 from : {glm::vec3(1.f, 0.7f, 1.9f), glm::vec3(-1.7f, -0.4f, 0.9f), glm::vec3(0.3f, 1.9f, -0.6f)}) {
        const glm::vec3 forward = glm::normalize(-from), right = glm::normalize(glm::cross(forward, glm::vec3(0.f, 1.f, 0.f))),
                        up = glm::cross(right, forward);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const glm::vec2 at = (glm::vec2(float(x), float(y)) + 0.5f) / float(side) * 2.f - 1.f;
                eyes.push_back({from, glm::normalize(forward + right * (0.31f * at.x) + up * (0.31f * at.y))});
            }
    }
    return eyes;
}

HeightField constant(float height)
{
    return HeightField(4, 4, std::vector<float>(16, height));
}

Parameters deep(float depth)
{
    Parameters p;
    p.depth = depth, p.metresPerUV = 1.f, p.tiling = 1.f;
    return p;
}

} // namespace

// Moved along its normals the mesh has the same triangles: the prisms' constant height is that mesh, to rounding.
TEST(PrismWalk, ConstantHeightsAreTheMovedMesh)
{
    const Parameters p = deep(0.12f);
    for (const char* key : {"sphere", "torus", "cylinder"}) {
        const Mesh mesh = *makeShape(key);
        for (const float height : {0.f, 0.25f, 0.5f, 0.75f, 1.f}) {
            const auto prisms = Prisms::make("cell-cone", p, mesh, constant(height));
            ASSERT_TRUE(prisms) << message(prisms.error());
            const std::vector<Corners> outer = outerSurface(*prisms, mesh.indices.size() / 3),
                                       truth = moved(mesh, (1.f - height) * p.depth);
            int rays = 0, outline = 0, off = 0;
            for (const Eye& eye : eyesAround(18)) {
                const auto fronts = frontsOf(outer, eye.origin, eye.way), answers = frontsOf(truth, eye.origin, eye.way);
                const PrismRayHit hit = seenThrough(*prisms, fronts, eye.origin, eye.way);
                const glm::vec3 answer = answers.empty() ? hit.point : eye.origin + eye.way * answers.front().way;
                // At the cylinder's rims side and end pass through each other.
                if (key == std::string("cylinder")
                    && std::max(std::abs(answer.y), std::abs(hit.point.y)) > mesh.boundsMax.y - 1.2f * p.depth)
                    continue;
                rays += hit.found || !answers.empty();
                outline += hit.found == answers.empty();
                off += hit.found && !answers.empty() && !(glm::distance(hit.point, answer) < 1e-4f);
            }
            EXPECT_GT(rays, 40) << key;
            EXPECT_EQ(outline, 0) << key << ' ' << height << " of " << rays;
            EXPECT_EQ(off, 0) << key << ' ' << height << " of " << rays;
        }
    }
}

// On a round body each has one: a point of the relief faces the light or does not.
TEST(PrismWalk, ConstantHeightsShadeThemselvesWhereTheyFaceAway)
{
    for (const char* technique : {"cell-cone", "relief"}) {
        const Mesh mesh = *makeShape("sphere");
        const auto prisms = Prisms::make(technique, deep(0.12f), mesh, constant(0.4f));
        ASSERT_TRUE(prisms);
        const std::vector<Corners> outer = outerSurface(*prisms, mesh.indices.size() / 3);
        const glm::vec3 light = glm::normalize(glm::vec3(0.8f, 0.5f, 0.1f));
        int lit = 0, dark = 0, wrong = 0;
        for (const Eye& eye : eyesAround(10)) {
            const PrismRayHit hit = seenThrough(*prisms, frontsOf(outer, eye.origin, eye.way), eye.origin, eye.way);
            const float facing = glm::dot(glm::normalize(hit.point), light);
            if (!hit.found || std::abs(facing) < 0.1f)
                continue;
            (facing > 0.f ? lit : dark) += 1;
            wrong += prisms->isHidden(hit, light) != (facing < 0.f);
        }
        EXPECT_GT(lit, 30) << technique;
        EXPECT_GT(dark, 30) << technique;
        EXPECT_EQ(wrong, 0) << technique << ' ' << lit << ' ' << dark;
    }
}

// A ramp winds in along a cylinder: its radius tells how deep it is at each angle.
TEST(PrismWalk, ARampWindsIntoTheCylinder)
{
    const Parameters p = deep(0.2f);
    const Mesh mesh = *makeShape("cylinder");
    std::vector<float> heights(256);
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = float(i) / 255.f;
    const HeightField field(256, 1, std::move(heights), Wrap::Repeat, 32);
    const auto prisms = Prisms::make("cell-cone", p, mesh, field);
    ASSERT_TRUE(prisms);
    const std::vector<Corners> outer = outerSurface(*prisms, mesh.indices.size() / 3);
    int rays = 0;
    for (const Eye& eye : eyesAround(18)) {
        const PrismRayHit hit = seenThrough(*prisms, frontsOf(outer, eye.origin, eye.way), eye.origin, eye.way);
        if (!hit.found || std::abs(hit.point.y) > mesh.boundsMax.y - 1.2f * p.depth)
            continue;
        ++rays;
        const float radius = glm::length(glm::vec2(hit.point.x, hit.point.z)),
                    expected = mesh.boundsMax.x - p.depth * (1.f - field.at(hit.uv));
        EXPECT_NEAR(radius, expected, 2e-3f) << hit.uv.x; // the cylinder is of flat triangles
        EXPECT_NEAR(hit.depth, 1.f - field.at(hit.uv), 2e-3f);
    }
    EXPECT_GT(rays, 100);
}

// Hard ways: nothing but a hit or a miss comes out, in bounded steps, and none is not a number.
TEST(PrismWalk, HardWaysEnd)
{
    Mesh mesh = *makeShape("torus");
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 97) // slivers and points
        mesh.vertices[i].position = mesh.vertices[(i + 1) % mesh.vertices.size()].position;
    for (const float depth : {0.f, 1e-6f, 0.08f, 5.f, 1e4f})
        for (const float height : {0.f, 0.5f, 1.f}) {
            const auto prisms = Prisms::make("cell-cone", deep(depth), mesh, constant(height));
            ASSERT_TRUE(prisms);
            const std::vector<Corners> outer = outerSurface(*prisms, mesh.indices.size() / 3);
            for (const Eye& eye : eyesAround(6))
                for (const Front& front : frontsOf(outer, eye.origin, eye.way)) {
                    const PrismRayHit hit = prisms->hit(front.triangle, eye.origin + eye.way * front.way, eye.way);
                    EXPECT_TRUE(std::isfinite(hit.point.x + hit.point.y + hit.point.z + hit.depth + hit.uv.x + hit.uv.y))
                        << depth << height;
                    EXPECT_TRUE(hit.depth >= 0.f && hit.depth <= 1.f) << depth << ' ' << height << ' ' << hit.depth;
                }
        }
}
