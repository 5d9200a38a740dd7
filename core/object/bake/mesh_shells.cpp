// Shells by joined positions, and the winding number beside each triangle of those that are open.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/object/bake/mesh_shells.h"
#include "core/mesh/edges/places.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>
#include <unordered_map>

namespace relievo {

namespace {
constexpr double kBesideTriangle = 0.05; // of a triangle's size: how far beside it the winding number is asked for
constexpr std::size_t kFew = 32; // triangles of a shell that is asked by itself
constexpr double kMayBeSheet = 0.2; // from one half: on both sides of a sheet the winding number is about that

struct Edge {
    std::uint64_t ends; // the lower and the higher place
    std::uint32_t shell;
    int passes; // +1 from the lower end, -1 from the higher one
    std::uint32_t lower() const { return std::uint32_t(ends >> 32); }
    std::uint32_t higher() const { return std::uint32_t(ends); }
};

// Numbers that are joined, by one of them.
class Joined {
public:
    explicit Joined(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), 0u); }
    std::uint32_t of(std::uint32_t i)
    {
        while (m_parent[i] != i)
            i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) { m_parent[of(a)] = of(b); }

private:
    std::vector<std::uint32_t> m_parent;
};

// The number of a shell for each triangle: one of its places. What is cut hangs together with nothing.
std::vector<std::uint32_t> shellNumbers(const Mesh& mesh, const std::vector<std::uint32_t>& place, const std::vector<char>& isCut)
{
    Joined joined(mesh.vertices.size());
    std::vector<std::uint32_t> numbers(isCut.size());
    for (std::size_t t = 0; t < numbers.size(); ++t)
        for (std::size_t k = 1; k < 3 && !isCut[t]; ++k)
            joined.join(place[mesh.indices[3 * t]], place[mesh.indices[3 * t + k]]);
    for (std::size_t t = 0; t < numbers.size(); ++t)
        numbers[t] = joined.of(place[mesh.indices[3 * t]]);
    return numbers;
}

// The edges that are not run through as often both ways; passes: by how much.
std::vector<Edge> holesOf(
    const Mesh& mesh, const std::vector<std::uint32_t>& place, const std::vector<std::uint32_t>& shells, const std::vector<char>& isCut)
{
    std::vector<Edge> edges;
    edges.reserve(mesh.indices.size());
    for (std::size_t t = 0; t < shells.size(); ++t)
        for (std::size_t k = 0; k < 3 && !isCut[t]; ++k) {
            const std::uint64_t from = place[mesh.indices[3 * t + k]], to = place[mesh.indices[3 * t + (k + 1) % 3]];
            if (from != to)
                edges.push_back({std::min(from, to) << 32 | std::max(from, to), shells[t], from < to ? 1 : -1});
        }
    oneapi::tbb::parallel_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
    std::vector<Edge> holes;
    for (std::size_t i = 0; i < edges.size();) {
        Edge edge = edges[i];
        for (++i; i < edges.size() && edges[i].ends == edge.ends; ++i)
            edge.passes += edges[i].passes;
        if (edge.passes != 0)
            holes.push_back(edge);
    }
    return holes;
}

// From each edge of a hole to the middle of the hole's corners.
std::vector<Winding::Triangle> lidsOf(const Mesh& mesh, const std::vector<std::uint32_t>& place, const std::vector<Edge>& holes)
{
    std::vector<glm::dvec3> corners(mesh.vertices.size());
    for (std::size_t i = 0; i < place.size(); ++i)
        corners[place[i]] = mesh.vertices[i].position;
    Joined joined(mesh.vertices.size());
    for (const Edge& edge : holes)
        joined.join(edge.lower(), edge.higher());
    struct Sum {
        glm::dvec3 corners{0.};
        double count = 0.;
    };
    std::unordered_map<std::uint32_t, Sum> sums;
    for (const Edge& edge : holes) {
        Sum& sum = sums[joined.of(edge.lower())];
        sum.corners += corners[edge.lower()] + corners[edge.higher()];
        sum.count += 2.;
    }
    std::vector<Winding::Triangle> lids;
    for (const Edge& edge : holes) {
        const Sum& sum = sums[joined.of(edge.lower())];
        const glm::dvec3 low = corners[edge.lower()], high = corners[edge.higher()], middle = sum.corners / sum.count;
        for (int i = 0; i < std::abs(edge.passes); ++i)
            lids.push_back(edge.passes > 0 ? Winding::Triangle{high, low, middle} : Winding::Triangle{low, high, middle});
    }
    return lids;
}

// On both sides of a triangle of the shell.
bool enclosesNothing(const Winding& shell, const Winding::Triangle& t)
{
    const glm::dvec3 up = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double twice = glm::length(up);
    if (!(twice > 0.))
        return true;
    const glm::dvec3 middle = (t[0] + t[1] + t[2]) / 3., beside = up * (kBesideTriangle / std::sqrt(twice));
    return std::abs(shell.at(middle + beside)) <= 0.5 && std::abs(shell.at(middle - beside)) <= 0.5;
}

// The triangles of each shell that is open, one shell after the other.
std::vector<std::uint32_t> openByShell(const MeshShells& found, const std::vector<std::uint32_t>& shells)
{
    std::vector<std::uint32_t> order;
    for (std::uint32_t t = 0; t < shells.size(); ++t)
        if (found.kinds[t] == TriangleKind::Open)
            order.push_back(t);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t t) { return shells[t]; });
    return order;
}

// Small shells that enclose nothing, asked by themselves: leaves by the thousand, among which trees of all triangles are slow.
void findLeaves(const Mesh& mesh, const std::vector<std::uint32_t>& shells, MeshShells& found)
{
    const std::vector<std::uint32_t> order = openByShell(found, shells);
    for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
        while (end < order.size() && shells[order[end]] == shells[order[i]])
            ++end;
        if (end - i > kFew)
            continue;
        std::vector<Winding::Triangle> own;
        for (std::size_t k = i; k < end; ++k)
            own.push_back(cornersOf(mesh, order[k]));
        const Winding shell(own);
        const auto isNothing = [&](const Winding::Triangle& t) { return enclosesNothing(shell, t); };
        if (std::ranges::all_of(own, isNothing))
            for (std::size_t k = i; k < end; ++k)
                found.kinds[order[k]] = TriangleKind::Loose;
    }
}

// Of what lies on an open shell. The lids' winding number tells the shell's but for a whole number; only where that leaves it open the
// whole shell is asked.
bool enclosesNothing(const Winding& lids, const Winding& shell, const Winding::Triangle& t)
{
    const double rest = lids.at((t[0] + t[1] + t[2]) / 3.);
    return std::abs(rest - std::floor(rest) - 0.5) <= kMayBeSheet && enclosesNothing(shell, t);
}
// Only shells that may enclose something count.
void dropLids(MeshShells& found, const std::vector<Edge>& holes, const std::vector<std::uint32_t>& shells)
{
    std::vector<char> encloses(shells.empty() ? 0 : *std::ranges::max_element(shells) + 1, 0);
    for (std::size_t t = 0; t < shells.size(); ++t)
        encloses[shells[t]] |= char(found.kinds[t] == TriangleKind::Open);
    std::vector<Winding::Triangle> kept;
    std::size_t next = 0;
    for (const Edge& edge : holes)
        for (int i = 0; i < std::abs(edge.passes); ++i, ++next)
            if (encloses[edge.shell])
                kept.push_back(found.lids[next]);
    found.lids = std::move(kept);
    found.ofLids = Winding(found.lids);
}
} // namespace

MeshShells shellsOf(const Mesh& mesh, const std::vector<char>& isCut)
{
    const std::vector<std::uint32_t> place = placesOf(mesh), shells = shellNumbers(mesh, place, isCut);
    const std::vector<Edge> holes = holesOf(mesh, place, shells, isCut);
    std::vector<char> isOpen(mesh.vertices.size(), 0);
    for (const Edge& edge : holes)
        isOpen[edge.shell] = 1;
    MeshShells found{std::vector<TriangleKind>(shells.size(), TriangleKind::Closed), lidsOf(mesh, place, holes), Winding({}), 0, false};
    double volume = 0.;
    for (std::size_t t = 0; t < shells.size(); ++t) {
        const Winding::Triangle c = cornersOf(mesh, t);
        if (isCut[t])
            found.kinds[t] = TriangleKind::Loose;
        else if (isOpen[shells[t]]) {
            found.kinds[t] = TriangleKind::Open;
            ++found.openTriangles;
        } else
            volume += glm::dot(c[0] - glm::dvec3(mesh.boundsMin), glm::cross(c[1] - c[0], c[2] - c[0]));
    }
    found.facesInwards = volume < 0.;
    findLeaves(mesh, shells, found);
    dropLids(found, holes, shells);
    std::vector<Winding::Triangle> loose;
    for (std::size_t t = 0; t < shells.size(); ++t)
        if (found.kinds[t] == TriangleKind::Open)
            loose.push_back(cornersOf(mesh, t));
    const Winding shell(std::move(loose));
    oneapi::tbb::parallel_for(std::size_t(0), shells.size(), [&](std::size_t t) {
        if (found.kinds[t] == TriangleKind::Open && enclosesNothing(found.ofLids, shell, cornersOf(mesh, t)))
            found.kinds[t] = TriangleKind::Sheet;
    });
    return found;
}

} // namespace relievo
