// Borders found by joining edges, then carried over the surface, nearest first.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edges/borders.h"
#include "core/mesh/edges/across.h"
#include <algorithm>
#include <complex>
#include <limits>
#include <queue>
#include <unordered_map>

namespace relievo {

namespace {
constexpr double kStraight = 1e-3; // UV: how far corners may lie off a segment that stands for several edges

constexpr std::size_t kLongestRun = 256; // edges in one segment: all are looked at again for each

using Point = std::complex<double>; // in UV space
Point point(glm::vec2 uv)
{
    return {double(uv.x), double(uv.y)};
}

glm::vec2 vec(Point p)
{
    return {float(p.real()), float(p.imag())};
}

struct Edges {
    const Mesh& mesh;
    std::vector<std::uint32_t> across;

    const Vertex& corner(std::uint32_t edge) const { return mesh.vertices[mesh.indices[edge]]; }
    Point uv(std::uint32_t edge) const { return point(corner(edge).uv); }
    bool hasUVArea(std::uint32_t triangle) const
    {
        const Point a = uv(3 * triangle), b = uv(3 * triangle + 1) - a, c = uv(3 * triangle + 2) - a;
        return std::imag(std::conj(b) * c) != 0.;
    }
    // Whether v runs against the triangle's turn, so that its inside lies on the left of its edges where v points up.
    bool upright(std::uint32_t triangle) const
    {
        const Point a = uv(3 * triangle), b = uv(3 * triangle + 1) - a, c = uv(3 * triangle + 2) - a;
        return std::imag(std::conj(b) * c) > 0.;
    }
};

struct Segment {
    Point from, to;
};

double distance(Point p, const Segment& s)
{
    const Point way = s.to - s.from;
    const double length = std::norm(way);
    const double share = length > 0. ? std::clamp(std::real(std::conj(way) * (p - s.from)) / length, 0., 1.) : 0.;
    return std::abs(p - s.from - way * share);
}

// Between a triangle and a segment that does not cross it.
double distance(const Edges& edges, std::uint32_t triangle, const Segment& s)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t e = 3 * triangle; e < 3 * triangle + 3; ++e) {
        const Segment side{edges.uv(e), edges.uv(nextCorner(e))};
        least = std::min({least, distance(side.from, s), distance(s.from, side), distance(s.to, side)});
    }
    return least;
}

// A segment on its way over the surface, in UVs of the triangle it has come to.
struct Visit {
    double distance;
    std::uint32_t triangle, number;
    Segment segment;
    bool operator<(const Visit& other) const { return distance > other.distance; } // the queue gives the nearest first
};

// From the UVs of one triangle to those beyond an edge, by the similarity that keeps the edge: nothing changes but at UV seams.
Segment unfolded(const Edges& edges, std::uint32_t edge, std::uint32_t other, const Segment& s)
{
    const Point a = edges.uv(edge), b = edges.uv(nextCorner(edge)), otherA = edges.uv(nextCorner(other)), otherB = edges.uv(other);
    if ((a == otherA && b == otherB) || a == b)
        return s;
    if (edges.upright(edge / 3) == edges.upright(other / 3)) {
        const Point turn = (otherB - otherA) / (b - a);
        return {otherA + (s.from - a) * turn, otherA + (s.to - a) * turn};
    }
    const Point turn = (otherB - otherA) / std::conj(b - a); // mirrored: the inside stays on the left when the ends change places
    return {otherA + std::conj(s.to - a) * turn, otherA + std::conj(s.from - a) * turn};
}

using Queue = std::priority_queue<Visit>;

// The borders, nearly straight runs as one segment, each seen from the triangles that it bounds.
void addBorders(const Edges& edges, Queue& queue)
{
    std::unordered_map<std::uint32_t, std::uint32_t> byFirst; // border edge that begins at a vertex
    std::vector<std::uint32_t> borders;
    for (std::uint32_t e = 0; e < edges.across.size(); ++e)
        if (edges.across[e] == kNoEdge && edges.hasUVArea(e / 3))
            byFirst[edges.mesh.indices[e]] = e, borders.push_back(e);
    std::vector<char> done(edges.across.size(), 0);
    std::uint32_t number = 0;
    for (const std::uint32_t first : borders) {
        std::vector<std::uint32_t> run;
        for (std::uint32_t e = first; !done[e] && run.size() < kLongestRun;) {
            const Segment whole{edges.uv(first), edges.uv(nextCorner(e))};
            if (std::ranges::any_of(run, [&](std::uint32_t r) { return distance(edges.uv(nextCorner(r)), whole) > kStraight; }))
                break;
            done[e] = 1, run.push_back(e);
            if (const auto next = byFirst.find(edges.mesh.indices[nextCorner(e)]); next != byFirst.end())
                e = next->second;
        }
        if (run.empty())
            continue;
        const Point from = edges.uv(first), to = edges.uv(nextCorner(run.back()));
        for (const std::uint32_t e : run)
            queue.push({0., e / 3, number, edges.upright(e / 3) ? Segment{from, to} : Segment{to, from}});
        ++number;
    }
}
} // namespace

Borders bordersOf(const Mesh& mesh, const BorderLimits& limits)
{
    const Edges edges{mesh, edgesAcross(mesh)};
    Queue queue;
    addBorders(edges, queue);
    if (queue.empty())
        return {};
    std::vector<std::vector<Visit>> lists(mesh.indices.size() / 3);
    std::size_t count = 0;
    while (!queue.empty()) {
        const Visit visit = queue.top();
        queue.pop();
        std::vector<Visit>& list = lists[visit.triangle];
        if (list.size() >= limits.perTriangle || std::ranges::count(list, visit.number, &Visit::number))
            continue;
        list.push_back(visit), ++count;
        for (std::uint32_t e = 3 * visit.triangle; e < 3 * visit.triangle + 3; ++e)
            if (const std::uint32_t other = edges.across[e]; other != kNoEdge) {
                const Segment segment = unfolded(edges, e, other, visit.segment);
                if (const double far = distance(edges, other / 3, segment); far <= double(limits.reach))
                    queue.push({far, other / 3, visit.number, segment});
            }
    }
    const double share = std::min(1., double(limits.budget) / double(count));
    Borders borders;
    for (const std::vector<Visit>& list : lists) {
        borders.starts.push_back(std::uint32_t(borders.segments.size()));
        for (std::size_t i = 0; i < std::size_t(double(list.size()) * share); ++i)
            borders.segments.emplace_back(vec(list[i].segment.from), vec(list[i].segment.to));
    }
    borders.starts.push_back(std::uint32_t(borders.segments.size()));
    return borders;
}

} // namespace relievo
