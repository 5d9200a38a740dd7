// Texture Jacobians and tangents of a mesh (ARCHITECTURE.md, "Space, sign and unit"), from its triangles.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/frames/frames.h"
#include "core/mesh/frames/tangents.h"
#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <tuple>

namespace relievo {

float signedUVArea(glm::vec2 a, glm::vec2 b, glm::vec2 c)
{
    const glm::vec2 e1 = b - a, e2 = c - a;
    return e1.x * e2.y - e1.y * e2.x;
}

glm::vec3 perpendicular(glm::vec3 n)
{
    const glm::vec3 axis = std::abs(n.x) < 0.6f ? glm::vec3(1.f, 0.f, 0.f) : glm::vec3(0.f, 0.f, 1.f);
    return glm::normalize(axis - n * glm::dot(n, axis));
}

namespace {
// What one triangle says about the size and direction of the texture on it.
struct TriangleFrame {
    glm::vec3 dPdu{0.f}, dPdv{0.f};
    float area = 0.f; // m2
    float uvArea = 0.f; // 0: degenerate, dPdu and dPdv say nothing
};

TriangleFrame frameOf(const Vertex& a, const Vertex& b, const Vertex& c)
{
    TriangleFrame frame;
    const glm::vec3 p1 = b.position - a.position, p2 = c.position - a.position;
    frame.area = 0.5f * glm::length(glm::cross(p1, p2));
    const glm::vec2 t1 = b.uv - a.uv, t2 = c.uv - a.uv;
    const float twice = t1.x * t2.y - t1.y * t2.x;
    // An area below the rounding of its own edges has no direction.
    const float rounding = 1e-6f * (glm::dot(t1, t1) + glm::dot(t2, t2));
    if (!(std::abs(twice) > rounding) || !std::isfinite(twice) || !std::isfinite(frame.area) || frame.area <= 0.f)
        return frame;
    frame.dPdu = (p1 * t2.y - p2 * t1.y) / twice;
    frame.dPdv = (p2 * t1.x - p1 * t2.x) / twice;
    frame.uvArea = 0.5f * std::abs(twice);
    if (!std::isfinite(glm::dot(frame.dPdu, frame.dPdu) + glm::dot(frame.dPdv, frame.dPdv)))
        frame.uvArea = 0.f;
    return frame;
}

void measureBounds(Mesh& mesh)
{
    mesh.boundsMin = mesh.boundsMax = mesh.vertices.empty() ? glm::vec3(0.f) : mesh.vertices.front().position;
    for (const Vertex& vertex : mesh.vertices) {
        mesh.boundsMin = glm::min(mesh.boundsMin, vertex.position);
        mesh.boundsMax = glm::max(mesh.boundsMax, vertex.position);
    }
}

// The directions are the fields of a cube around the middle.
void measureOutline(Mesh& mesh)
{
    constexpr int kFields = 32; // along each side of the cube
    constexpr float kNone = -1.f;
    struct Furthest {
        float distance2 = kNone;
        glm::vec3 position{0.f};
    };
    std::vector<Furthest> furthest(std::size_t(6 * kFields * kFields));
    const glm::vec3 middle = 0.5f * (mesh.boundsMin + mesh.boundsMax);
    const auto field = [](float along) { return std::clamp(int((along + 1.f) * 0.5f * kFields), 0, kFields - 1); };
    for (const Vertex& vertex : mesh.vertices) {
        const glm::vec3 from = vertex.position - middle, size = glm::abs(from);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        if (!(size[axis] > 0.f))
            continue;
        const int face = 2 * axis + (from[axis] < 0.f ? 1 : 0);
        const int row = field(from[(axis + 1) % 3] / size[axis]), column = field(from[(axis + 2) % 3] / size[axis]);
        Furthest& most = furthest[std::size_t((face * kFields + row) * kFields + column)];
        if (const float distance2 = glm::dot(from, from); distance2 > most.distance2)
            most = {distance2, vertex.position};
    }
    mesh.outline.clear();
    for (const Furthest& one : furthest)
        if (one.distance2 != kNone)
            mesh.outline.push_back(one.position);
}

float largestSide(const Mesh& mesh)
{
    const glm::vec3 size = mesh.boundsMax - mesh.boundsMin;
    const float side = std::max({size.x, size.y, size.z});
    return side > 0.f && std::isfinite(side) ? side : 1.f;
}

// Gives each vertex the tangent of its corners; one whose corners have several (mirrored sides meet) is split.
void splitByTangents(Mesh& mesh, std::span<const glm::vec4> fileTangents)
{
    const std::size_t before = mesh.vertices.size();
    for (std::size_t i = 0; i < before; ++i)
        mesh.vertices[i].tangent = fileTangents.empty() ? glm::vec4(0.f) : fileTangents[i];
    if (!fileTangents.empty() && std::ranges::all_of(fileTangents, [](glm::vec4 t) { return t.w != 0.f; }))
        return;
    const std::vector<glm::vec4> tangents = cornerTangents(mesh);
    std::map<std::tuple<std::uint32_t, float, float, float, float>, std::uint32_t> split; // by vertex and tangent
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t at = mesh.indices[i];
        const glm::vec4 t = tangents[i];
        if (t.w == 0.f || (!fileTangents.empty() && fileTangents[at].w != 0.f) || mesh.vertices[at].tangent == t)
            continue;
        if (mesh.vertices[at].tangent.w != 0.f) {
            const auto [found, isNew] = split.try_emplace({at, t.x, t.y, t.z, t.w}, std::uint32_t(mesh.vertices.size()));
            if (isNew)
                mesh.vertices.push_back(mesh.vertices[at]);
            mesh.indices[i] = found->second;
        }
        mesh.vertices[mesh.indices[i]].tangent = t;
    }
}

// Of each triangle whether its part is without relief.
std::vector<char> plainTriangles(const Mesh& mesh)
{
    std::vector<char> plain(mesh.indices.size() / 3, 0);
    for (const MeshPart& part : mesh.parts)
        for (std::size_t i = part.firstIndex / 3; part.relief == 0.f && i < (std::size_t(part.firstIndex) + part.indexCount) / 3; ++i)
            plain.at(i) = 1;
    return plain;
}

// The Jacobian of one vertex from the weighted sums over its triangles (weight 0: none had usable UVs), and a tangent if it has none.
void setFrame(Vertex& vertex, float weight, float metresPerUV)
{
    const glm::vec3 n = vertex.normal;
    if (weight > 0.f) {
        vertex.dPdu /= weight;
        vertex.dPdv /= weight;
        vertex.dPdu -= n * glm::dot(n, vertex.dPdu);
        vertex.dPdv -= n * glm::dot(n, vertex.dPdv);
    }
    const float lengths = glm::length(vertex.dPdu) * glm::length(vertex.dPdv);
    const float turn = glm::dot(glm::cross(vertex.dPdu, vertex.dPdv), n);
    const bool useless = !(std::abs(turn) > 1e-4f * lengths) || !std::isfinite(turn) || lengths <= 1e-20f;
    const glm::vec3 alongU = useless ? perpendicular(n) : glm::normalize(vertex.dPdu);
    if (useless) {
        vertex.dPdu = alongU * metresPerUV; // of a tiny mesh too short to be normalised
        vertex.dPdv = glm::cross(vertex.dPdu, n);
    }
    if (vertex.tangent.w == 0.f)
        vertex.tangent = glm::vec4(alongU, useless || turn < 0.f ? 1.f : -1.f); // v runs down: unmirrored is negative
}

// Sets every vertex' Jacobian from its triangles; the mean size of the texture, 0 when no triangle says anything.
double setJacobians(Mesh& mesh, std::vector<float>& weights)
{
    weights.assign(mesh.vertices.size(), 0.f);
    for (Vertex& vertex : mesh.vertices)
        vertex.dPdu = vertex.dPdv = glm::vec3(0.f);
    double area = 0, uvArea = 0;
    const std::vector<char> plain = plainTriangles(mesh);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const TriangleFrame frame
            = frameOf(mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]], mesh.vertices[mesh.indices[i + 2]]);
        if (frame.uvArea <= 0.f)
            continue;
        if (!plain[i / 3])
            area += double(frame.area), uvArea += double(frame.uvArea);
        for (std::size_t k = i; k < i + 3; ++k) {
            const std::uint32_t at = mesh.indices[k];
            mesh.vertices[at].dPdu += frame.dPdu * frame.area;
            mesh.vertices[at].dPdv += frame.dPdv * frame.area;
            weights[at] += frame.area;
        }
    }
    return uvArea > 0 ? std::sqrt(area / uvArea) : 0.0;
}
} // namespace

void completeFrames(Mesh& mesh, std::span<const glm::vec4> fileTangents)
{
    assert(fileTangents.empty() || fileTangents.size() == mesh.vertices.size());
    splitByTangents(mesh, fileTangents);
    refreshFrames(mesh, true);
}

void refreshFrames(Mesh& mesh, bool renewSize)
{
    measureBounds(mesh);
    std::vector<float> weights;
    const double measured = setJacobians(mesh, weights);
    if (renewSize)
        measureOutline(mesh);
    if (renewSize)
        mesh.metresPerUV = measured > 1e-12 && measured < 1e12 ? float(measured) : largestSide(mesh);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        setFrame(mesh.vertices[i], weights[i], mesh.metresPerUV);
}

} // namespace relievo
