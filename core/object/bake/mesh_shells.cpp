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

namespace relievo {

namespace {
constexpr double kBeside = 0.05; // of a triangle's size: how far beside it the winding number is asked for

struct Edge {
    std::uint64_t ends; // the lower and the higher place
    std::uint32_t shell;
    int passes; // +1 from the lower end, -1 from the higher one
};

// The number of a shell for each triangle: one of its places.
std::vector<std::uint32_t> shellNumbers(const Mesh& mesh, const std::vector<std::uint32_t>& place)
{
    std::vector<std::uint32_t> parent(mesh.vertices.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t i) {
        while (parent[i] != i)
            i = parent[i] = parent[parent[i]];
        return i;
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (std::size_t k = 1; k < 3; ++k)
            parent[root(place[mesh.indices[i]])] = root(place[mesh.indices[i + k]]);
    std::vector<std::uint32_t> numbers(mesh.indices.size() / 3);
    for (std::size_t t = 0; t < numbers.size(); ++t)
        numbers[t] = root(place[mesh.indices[3 * t]]);
    return numbers;
}

// By shell number: whether an edge is not run through as often both ways.
std::vector<char> openShells(const Mesh& mesh, const std::vector<std::uint32_t>& place, const std::vector<std::uint32_t>& shells)
{
    std::vector<Edge> edges;
    edges.reserve(mesh.indices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t from = place[mesh.indices[i + k]], to = place[mesh.indices[i + (k + 1) % 3]];
            if (from != to)
                edges.push_back({std::min(from, to) << 32 | std::max(from, to), shells[i / 3], from < to ? 1 : -1});
        }
    oneapi::tbb::parallel_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
    std::vector<char> isOpen(mesh.vertices.size(), 0);
    for (std::size_t i = 0; i < edges.size();) {
        int balance = 0;
        const std::size_t first = i;
        for (; i < edges.size() && edges[i].ends == edges[first].ends; ++i)
            balance += edges[i].passes;
        if (balance != 0)
            isOpen[edges[first].shell] = 1;
    }
    return isOpen;
}

bool enclosesNothing(const Winding& winding, const std::array<glm::dvec3, 3>& t)
{
    const glm::dvec3 up = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double twice = glm::length(up);
    if (!(twice > 0.))
        return true;
    const glm::dvec3 middle = (t[0] + t[1] + t[2]) / 3., beside = up * (kBeside / std::sqrt(twice));
    return std::abs(winding.at(middle + beside)) <= 0.5 && std::abs(winding.at(middle - beside)) <= 0.5;
}
} // namespace

MeshShells shellsOf(const Mesh& mesh, const std::vector<char>& isCut)
{
    const std::vector<std::uint32_t> place = placesOf(mesh), shells = shellNumbers(mesh, place);
    const std::vector<char> isOpen = openShells(mesh, place, shells);
    MeshShells found{std::vector<TriangleKind>(shells.size(), TriangleKind::Closed), Winding({}), 0, false};
    std::vector<Winding::Triangle> loose;
    double volume = 0.;
    for (std::size_t t = 0; t < shells.size(); ++t) {
        if (isCut[t])
            found.kinds[t] = TriangleKind::Sheet;
        else if (isOpen[shells[t]]) {
            found.kinds[t] = TriangleKind::Open;
            loose.push_back(cornersOf(mesh, t));
            ++found.openTriangles;
        } else {
            const auto c = cornersOf(mesh, t);
            const glm::dvec3 from = mesh.boundsMin;
            volume += glm::dot(c[0] - from, glm::cross(c[1] - from, c[2] - from));
        }
    }
    found.facesInwards = volume < 0.;
    found.open = Winding(std::move(loose));
    oneapi::tbb::parallel_for(std::size_t(0), shells.size(), [&](std::size_t t) {
        if (found.kinds[t] == TriangleKind::Open && enclosesNothing(found.open, cornersOf(mesh, t)))
            found.kinds[t] = TriangleKind::Sheet;
    });
    return found;
}

} // namespace relievo
