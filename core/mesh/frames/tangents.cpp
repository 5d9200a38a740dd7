// Tangents by groups of triangles around a vertex, as the description of MikkTSpace has them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/frames/tangents.h"
#include "core/mesh/numbering.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>

namespace relievo {

namespace {
constexpr std::uint32_t kNone = ~std::uint32_t(0);

// v without its part along n, unit; 0 stays 0.
glm::vec3 inPlane(glm::vec3 v, glm::vec3 n)
{
    const glm::vec3 flat = v - n * glm::dot(n, v);
    const float length = glm::length(flat);
    return length > std::numeric_limits<float>::min() ? flat / length : flat;
}

struct Triangle {
    glm::vec3 alongU{0.f}; // unit
    bool preserves = false; // whether the UVs turn the way the corners do
    bool follows = true; // it has no direction of its own and takes the side of a neighbour
    bool collapsed = false; // two corners at one place: no part in any group
    std::array<std::uint32_t, 3> neighbours{kNone, kNone, kNone}; // across the edge from corner k to k + 1
};

class TangentMaker {
public:
    explicit TangentMaker(const Mesh& mesh)
        : m_mesh(mesh)
        , m_triangles(mesh.indices.size() / 3)
        , m_tangents(mesh.indices.size(), glm::vec4(0.f))
        , m_group(mesh.indices.size(), kNone)
    {
    }

    std::vector<glm::vec4> make()
    {
        weld();
        for (std::uint32_t i = 0; i < m_triangles.size(); ++i)
            m_triangles[i] = triangleOf(i);
        findNeighbours();
        for (std::uint32_t corner = 0; corner < m_group.size(); ++corner)
            if (m_group[corner] == kNone && !m_triangles[corner / 3].follows && !m_triangles[corner / 3].collapsed)
                finishGroup(corner);
        fillCollapsed();
        return std::move(m_tangents);
    }

private:
    const Vertex& vertex(std::uint32_t corner) const { return m_mesh.vertices[m_mesh.indices[corner]]; }
    std::uint32_t welded(std::uint32_t corner) const { return m_welded[m_mesh.indices[corner]]; }

    // Vertices that agree in position, normal and UV get one number.
    void weld()
    {
        Numbering<8> numbering(m_mesh.vertices.size());
        m_welded.reserve(m_mesh.vertices.size());
        for (const Vertex& v : m_mesh.vertices)
            m_welded.push_back(numbering(bitsOf(v.position, v.normal, v.uv)).number);
    }

    Triangle triangleOf(std::uint32_t index) const
    {
        Triangle triangle;
        const Vertex &a = vertex(index * 3), &b = vertex(index * 3 + 1), &c = vertex(index * 3 + 2);
        triangle.collapsed = a.position == b.position || b.position == c.position || c.position == a.position;
        const glm::vec3 p1 = b.position - a.position, p2 = c.position - a.position;
        const glm::vec2 t1 = b.uv - a.uv, t2 = c.uv - a.uv;
        const float area = t1.x * t2.y - t1.y * t2.x;
        triangle.preserves = area > 0.f;
        const glm::vec3 u = p1 * t2.y - p2 * t1.y, v = p2 * t1.x - p1 * t2.x;
        const float lengthU = glm::length(u), lengthV = glm::length(v);
        constexpr float kLeast = std::numeric_limits<float>::min();
        if (!(std::abs(area) > kLeast) || !(lengthU > kLeast) || !(lengthV > kLeast) || !std::isfinite(lengthU + lengthV))
            return triangle;
        triangle.alongU = u / (triangle.preserves ? lengthU : -lengthU);
        triangle.follows = false;
        return triangle;
    }

    // Two triangles are neighbours where one runs along an edge as the other runs back; a third at the same edge finds its own mate.
    void findNeighbours()
    {
        // The edges of place p, its lower end: edges[starts[p]] .. edges[starts[p + 1] - 1], by their other end and then by corner.
        std::vector<std::uint32_t> starts(m_mesh.vertices.size() + 1, 0);
        std::vector<Edge> edges;
        for (const bool counting : {true, false}) {
            for (std::uint32_t corner = 0; corner < m_group.size(); ++corner) {
                const std::uint32_t a = welded(corner), b = welded(next(corner));
                if (m_triangles[corner / 3].collapsed)
                    continue;
                if (counting)
                    ++starts[std::min(a, b) + 1];
                else
                    edges[starts[std::min(a, b)]++] = {std::max(a, b), corner};
            }
            if (!counting)
                break;
            std::partial_sum(starts.begin(), starts.end(), starts.begin());
            edges.resize(starts.back());
        }
        for (std::uint32_t p = 0, first = 0; p + 1 < starts.size(); first = starts[p++]) { // each start has moved to the next one's place
            std::sort(edges.begin() + first, edges.begin() + starts[p],
                [](const Edge& a, const Edge& b) { return std::tie(a.high, a.corner) < std::tie(b.high, b.corner); });
            pairEdges(p, std::span(edges).subspan(first, starts[p] - first));
        }
    }

    struct Edge {
        std::uint32_t high, corner;
    };

    void pairEdges(std::uint32_t low, std::span<const Edge> edges)
    {
        for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
            m_there.clear();
            m_back.clear();
            for (last = first; last < edges.size() && edges[last].high == edges[first].high; ++last)
                (welded(edges[last].corner) == low ? m_there : m_back).push_back(edges[last].corner);
            for (std::size_t i = 0; i < std::min(m_there.size(), m_back.size()); ++i) {
                m_triangles[m_there[i] / 3].neighbours[m_there[i] % 3] = m_back[i] / 3;
                m_triangles[m_back[i] / 3].neighbours[m_back[i] % 3] = m_there[i] / 3;
            }
        }
    }

    static std::uint32_t next(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
    static std::uint32_t previous(std::uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

    // Gathers the triangles around `seed` that hang together and turn the image the same way, and gives them their tangent.
    void finishGroup(std::uint32_t seed)
    {
        const std::uint32_t place = welded(seed);
        const bool preserves = m_triangles[seed / 3].preserves;
        m_members.clear();
        m_open.assign(1, seed);
        while (!m_open.empty()) {
            const std::uint32_t corner = m_open.back();
            m_open.pop_back();
            Triangle& triangle = m_triangles[corner / 3];
            if (m_group[corner] != kNone)
                continue;
            const std::uint32_t first = corner - corner % 3;
            if (triangle.follows && m_group[first] == kNone && m_group[first + 1] == kNone && m_group[first + 2] == kNone)
                triangle.preserves = preserves; // the first group that reaches it decides
            if (triangle.preserves != preserves)
                continue;
            m_group[corner] = seed;
            m_members.push_back(corner);
            for (const std::uint32_t edge : {previous(corner), corner}) // the two edges at this corner; the one pushed last goes first
                if (const std::uint32_t across = triangle.neighbours[edge % 3]; across != kNone)
                    for (std::uint32_t k = across * 3; k < across * 3 + 3; ++k)
                        if (welded(k) == place)
                            m_open.push_back(k);
        }
        const glm::vec4 tangent = meanTangent(preserves);
        for (const std::uint32_t corner : m_members)
            m_tangents[corner] = tangent;
    }

    // Mean over m_members, each weighted by its angle as seen along the normal. v runs down, so that a preserved turn is a mirror.
    glm::vec4 meanTangent(bool preserves) const
    {
        glm::vec3 sum(0.f);
        const glm::vec3 n = vertex(m_members.front()).normal;
        for (const std::uint32_t corner : m_members) {
            if (m_triangles[corner / 3].follows)
                continue;
            const glm::vec3 at = vertex(corner).position;
            const glm::vec3 a = inPlane(vertex(previous(corner)).position - at, n), b = inPlane(vertex(next(corner)).position - at, n);
            sum += std::acos(glm::clamp(glm::dot(a, b), -1.f, 1.f)) * inPlane(m_triangles[corner / 3].alongU, n);
        }
        const float length = glm::length(sum);
        if (!(length > 1e-6f) || !std::isfinite(length))
            return glm::vec4(0.f);
        return glm::vec4(sum / length, preserves ? -1.f : 1.f);
    }

    // Triangles without extent take what another corner of the same vertex has.
    void fillCollapsed()
    {
        if (std::ranges::none_of(m_triangles, &Triangle::collapsed))
            return;
        std::vector<std::uint32_t> sound(m_mesh.vertices.size(), kNone); // by welded number, a corner with a tangent
        for (std::uint32_t corner = 0; corner < m_group.size(); ++corner)
            if (!m_triangles[corner / 3].collapsed && sound[welded(corner)] == kNone)
                sound[welded(corner)] = corner;
        for (std::uint32_t corner = 0; corner < m_group.size(); ++corner)
            if (m_triangles[corner / 3].collapsed && sound[welded(corner)] != kNone)
                m_tangents[corner] = m_tangents[sound[welded(corner)]];
    }

    const Mesh& m_mesh;
    std::vector<std::uint32_t> m_welded; // by vertex
    std::vector<Triangle> m_triangles;
    std::vector<glm::vec4> m_tangents; // by corner
    std::vector<std::uint32_t> m_group; // by corner, the corner it began with
    std::vector<std::uint32_t> m_members, m_open, m_there, m_back; // of the work at hand
};
} // namespace

std::vector<glm::vec4> cornerTangents(const Mesh& mesh)
{
    return TangentMaker(mesh).make();
}

TangentDifference tangentDifference(const Mesh& mesh)
{
    const std::vector<glm::vec4> made = cornerTangents(mesh);
    TangentDifference difference;
    for (std::size_t i = 0; i < made.size(); ++i) {
        if (made[i].w == 0.f)
            continue;
        const glm::dvec4 a(made[i]), b(mesh.vertices[mesh.indices[i]].tangent);
        const double turn = std::atan2(glm::length(glm::cross(glm::dvec3(a), glm::dvec3(b))), glm::dot(glm::dvec3(a), glm::dvec3(b)));
        const double degrees = a.w == b.w ? glm::degrees(turn) : 180.;
        ++difference.corners;
        difference.off += degrees > kTangentTolerance;
        difference.worst = std::max(difference.worst, degrees);
    }
    return difference;
}

} // namespace relievo
