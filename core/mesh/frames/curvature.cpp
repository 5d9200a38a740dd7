// Curvature by least squares: quadratic patches fitted to the neighbours of each place of a mesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/frames/curvature.h"
#include "core/mesh/frames/frames.h"
#include "core/mesh/numbering.h"
#include <algorithm>
#include <cmath>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace relievo {

namespace {
// Holds what the neighbours leave open at "flat"; small against 1, the weight of one neighbour.
constexpr double kFlat = 1e-6;

// The places of a mesh: vertices of equal position and normal are one.
struct JoinedPlaces {
    std::vector<std::uint32_t> ofVertex;
    std::vector<std::uint32_t> vertex; // one of each place
    // Neighbours of place p, each once: neighbours[starts[p]] .. neighbours[starts[p + 1] - 1].
    std::vector<std::uint32_t> starts, neighbours;
    std::vector<char> atBorder; // an edge of the place has one triangle only, or it has no edge
};

void joinVertices(const Mesh& mesh, JoinedPlaces& places)
{
    Numbering<6> numbering(mesh.vertices.size());
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
        const glm::vec3 rounded = glm::round(mesh.vertices[i].normal * 512.f); // finer than any hard edge
        const auto [number, isNew] = numbering(bitsOf(mesh.vertices[i].position, rounded));
        if (isNew)
            places.vertex.push_back(i);
        places.ofVertex.push_back(number);
    }
}

// Calls act(place, neighbour) for both ends of each triangle's edges.
template <class Act> void forEdges(const Mesh& mesh, const JoinedPlaces& places, Act act)
{
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t a = places.ofVertex[mesh.indices[i]], b = places.ofVertex[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
        if (a != b) {
            act(a, b);
            act(b, a);
        }
    }
}

JoinedPlaces joinedPlaces(const Mesh& mesh)
{
    JoinedPlaces places;
    joinVertices(mesh, places);
    const std::size_t count = places.vertex.size();
    std::vector<std::size_t> starts(count + 1, 0);
    forEdges(mesh, places, [&](std::uint32_t a, std::uint32_t) { ++starts[a + 1]; });
    for (std::size_t p = 0; p < count; ++p)
        starts[p + 1] += starts[p];
    std::vector<std::uint32_t> all(starts.back());
    std::vector<std::size_t> end(starts.begin(), starts.end() - 1);
    forEdges(mesh, places, [&](std::uint32_t a, std::uint32_t b) { all[end[a]++] = b; });
    places.atBorder.assign(count, 0);
    places.starts.push_back(0);
    for (std::size_t p = 0; p < count; ++p) {
        std::sort(all.begin() + std::ptrdiff_t(starts[p]), all.begin() + std::ptrdiff_t(end[p]));
        places.atBorder[p] = starts[p] == end[p];
        for (std::size_t i = starts[p], next = i; i < end[p]; i = next) {
            while (next < end[p] && all[next] == all[i])
                ++next;
            places.atBorder[p] |= next == i + 1;
            places.neighbours.push_back(all[i]);
        }
        places.starts.push_back(std::uint32_t(places.neighbours.size()));
    }
    return places;
}

// Normal equations of z = q.x x^2 + q.y x y + q.z y^2 in an orthonormal frame of a tangent plane, lengths in units of `scale`.
struct Fit {
    glm::dvec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, n{0.0, 0.0, 1.0};
    glm::dmat3 matrix{0.0};
    glm::dvec3 right{0.0};
    double scale = 1.0; // m

    void add(glm::dvec3 row, double value)
    {
        matrix += glm::outerProduct(row, row);
        right += row * value;
    }
};

glm::dvec3 solved(const Fit& fit)
{
    const glm::dmat3 flat(kFlat, 0.0, 0.0, 0.0, 0.5 * kFlat, 0.0, 0.0, 0.0, kFlat); // does not change when the frame turns
    return glm::inverse(fit.matrix + flat) * fit.right;
}

// From where the neighbours lie and how their normals lean, weighted by the inverse of their distance. Tried on even, jittered and noisy
// tori: heights as well as normals, two rings of neighbours, and other powers of the distance; none had less error on the whole.
Fit fitAt(const Mesh& mesh, const JoinedPlaces& places, std::size_t place)
{
    const Vertex& own = mesh.vertices[places.vertex[place]];
    Fit fit;
    fit.n = glm::dvec3(own.normal);
    fit.x = glm::dvec3(perpendicular(own.normal));
    fit.y = glm::cross(fit.n, fit.x);
    const std::uint32_t from = places.starts[place], to = places.starts[place + 1];
    double sum = 0.0;
    for (std::uint32_t i = from; i < to; ++i)
        sum += glm::distance(glm::dvec3(mesh.vertices[places.vertex[places.neighbours[i]]].position), glm::dvec3(own.position));
    if (!(sum > 0.0) || !std::isfinite(sum))
        return fit;
    fit.scale = sum / (to - from);
    for (std::uint32_t i = from; i < to; ++i) {
        const Vertex& other = mesh.vertices[places.vertex[places.neighbours[i]]];
        const glm::dvec3 chord = (glm::dvec3(other.position) - glm::dvec3(own.position)) / fit.scale, n(other.normal);
        const double x = glm::dot(chord, fit.x), y = glm::dot(chord, fit.y);
        const double weight = 1.0 / glm::length(chord);
        // How far the normal leans is the slope there, taken so that it is exact on spheres and cylinders.
        fit.add(weight * glm::dvec3(2.0 * x, y, 0.0), weight * glm::dot(n, fit.x));
        fit.add(weight * glm::dvec3(0.0, x, 2.0 * y), weight * glm::dot(n, fit.y));
    }
    return fit;
}

// A bend of the surface in space: the fall along a step d in the tangent plane is dot(d, bend * d).
glm::dmat3 bendOf(const Fit& fit, glm::dvec3 q)
{
    return (q.x * glm::outerProduct(fit.x, fit.x) + q.z * glm::outerProduct(fit.y, fit.y)
               + 0.5 * q.y * (glm::outerProduct(fit.x, fit.y) + glm::outerProduct(fit.y, fit.x)))
        / fit.scale;
}

// The fit with its frame turned so that x is `tangent`, and without the mixed term.
glm::dvec2 solvedAlong(const Fit& fit, glm::dvec3 tangent)
{
    const double c = glm::dot(tangent, fit.x), s = glm::dot(tangent, fit.y);
    // Coefficients in the fit's frame from those in the turned one.
    const glm::dmat3 turn(c * c, 2 * c * s, s * s, -c * s, c * c - s * s, c * s, s * s, -2 * c * s, c * c);
    const glm::dmat3 m = glm::transpose(turn) * fit.matrix * turn;
    const glm::dvec3 r = glm::transpose(turn) * fit.right;
    const glm::dmat2 both(m[0][0] + kFlat, m[0][2], m[2][0], m[2][2] + kFlat);
    return glm::inverse(both) * glm::dvec2(r.x, r.z) / fit.scale;
}

glm::vec3 finite(glm::dvec3 v)
{
    const glm::vec3 f(v);
    return std::isfinite(f.x) && std::isfinite(f.y) && std::isfinite(f.z) ? f : glm::vec3(0.f);
}

// The shortest turn from the unit vector a to b, which do not oppose each other.
glm::dmat3 turnBetween(glm::dvec3 a, glm::dvec3 b)
{
    const glm::dvec3 axis = glm::cross(a, b);
    const glm::dmat3 cross(0.0, axis.z, -axis.y, -axis.z, 0.0, axis.x, axis.y, -axis.x, 0.0);
    return glm::dmat3(1.0) + cross + cross * cross / (1.0 + glm::dot(a, b));
}

// The mean of the inner neighbours' bends, turned into the own tangent plane; that of the place itself when it has none.
std::vector<glm::dmat3> settledAtBorders(const JoinedPlaces& places, const std::vector<Fit>& fits, const std::vector<glm::dmat3>& bends)
{
    std::vector<glm::dmat3> settled = bends;
    for (std::size_t p = 0; p < bends.size(); ++p) {
        glm::dmat3 sum(0.0);
        double count = 0.0;
        for (std::uint32_t i = places.starts[p]; places.atBorder[p] && i < places.starts[p + 1]; ++i)
            if (const std::uint32_t other = places.neighbours[i]; !places.atBorder[other] && glm::dot(fits[other].n, fits[p].n) > 0.0) {
                const glm::dmat3 turn = turnBetween(fits[other].n, fits[p].n);
                sum += turn * bends[other] * glm::transpose(turn);
                count += 1.0;
            }
        if (count > 0.0)
            settled[p] = sum / count;
    }
    return settled;
}
} // namespace

std::vector<Curvature> vertexCurvatures(const Mesh& mesh)
{
    const JoinedPlaces places = joinedPlaces(mesh);
    std::vector<Fit> fits(places.vertex.size());
    std::vector<glm::dmat3> bends(fits.size());
    for (std::size_t p = 0; p < fits.size(); ++p) {
        fits[p] = fitAt(mesh, places, p);
        bends[p] = bendOf(fits[p], solved(fits[p]));
    }
    const std::vector<glm::dmat3> settled = settledAtBorders(places, fits, bends);
    std::vector<Curvature> curvatures(mesh.vertices.size());
    for (std::size_t i = 0; i < curvatures.size(); ++i) {
        const Vertex& vertex = mesh.vertices[i];
        const std::uint32_t place = places.ofVertex[i];
        const glm::dvec3 u(vertex.dPdu), v(vertex.dPdv), tangent(vertex.tangent);
        const glm::dmat3& bend = settled[place];
        const glm::dvec3 bitangent = glm::cross(glm::dvec3(vertex.normal), tangent);
        const glm::dvec2 axes = places.atBorder[place]
            ? glm::dvec2(glm::dot(tangent, bend * tangent), glm::dot(bitangent, bend * bitangent))
            : solvedAlong(fits[place], tangent);
        curvatures[i].full = finite({glm::dot(u, bend * u), glm::dot(v, bend * v), 2.0 * glm::dot(u, bend * v)});
        curvatures[i].axes = glm::vec2(finite({axes.x * glm::dot(u, u), axes.y * glm::dot(v, v), 0.0}));
    }
    return curvatures;
}

std::vector<glm::vec3> vertexFalls(const Mesh& mesh, bool axes)
{
    const std::vector<Curvature> curvatures = vertexCurvatures(mesh);
    std::vector<glm::vec3> falls(curvatures.size());
    std::ranges::transform(curvatures, falls.begin(), [axes](const Curvature& c) { return axes ? glm::vec3(c.axes, 0.f) : c.full; });
    return falls;
}

} // namespace relievo
