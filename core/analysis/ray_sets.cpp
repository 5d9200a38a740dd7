// Rays by band and special rays, from a seeded generator whose numbers do not depend on the standard library.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/ray_sets.h"
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace relievo {

namespace {

constexpr double kTau = 2. * std::numbers::pi;

class Random {
public:
    explicit Random(std::uint32_t seed) : m_engine(seed) { }
    double unit() { return double(m_engine()) * 0x1p-32; } // [0, 1)
    glm::dvec2 point()
    {
        const double u = unit();
        return {u, unit()};
    }

private:
    std::mt19937 m_engine; // its sequence is fixed by the standard, its distributions are not
};

glm::dvec2 asFloats(glm::dvec2 v)
{
    return glm::dvec2(glm::vec2(v));
}

using Rays = std::vector<SearchRay>;

// `count` rays of `make(random)`.
template <class Make> Rays repeated(int count, std::uint32_t seed, Make make)
{
    Random random(seed);
    Rays rays;
    rays.reserve(std::size_t(count));
    for (int i = 0; i < count; ++i)
        rays.push_back(make(random));
    return rays;
}

SearchRay ray(glm::dvec2 uv, glm::dvec2 duv, double depth)
{
    uv = asFloats(uv), duv = asFloats(duv);
    const double travel = std::hypot(duv.x, duv.y), cosine = depth / std::hypot(depth, travel);
    return {uv, duv, double(float(std::isfinite(cosine) && cosine > 0. ? cosine : 1e-6))};
}

Rays straightDown(int, int, double depth, int count, std::uint32_t seed)
{
    return repeated(count, seed, [&](Random& random) { return ray(random.point(), {0., 0.}, depth); });
}

Rays diagonal(int, int, double depth, int count, std::uint32_t seed)
{
    int k = 0;
    return repeated(count, seed, [&](Random& random) {
        const int side = k++ % 8; // along each axis and each diagonal
        const glm::dvec2 axis[] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
        return ray(random.point(), axis[side] * (depth / std::hypot(axis[side].x, axis[side].y)), depth);
    });
}

// On the lines between texel centres, exactly, to the right and up.
Rays alongEdges(int width, int height, double depth, int count, std::uint32_t seed)
{
    int k = 0;
    return repeated(count, seed, [&](Random& random) {
        const double angle = 85. * random.unit(), travel = depth * std::tan(angle * kTau / 360.);
        const double u = (std::floor(random.unit() * width) + 0.5) / width, v = (std::floor(random.unit() * height) + 0.5) / height;
        return k++ % 2 ? ray({random.unit(), v}, {travel, 0.}, depth) : ray({u, random.unit()}, {0., -travel}, depth);
    });
}

// From vertex to vertex: starts on a texel centre, crosses a whole number of texels.
Rays throughVertices(int width, int height, double depth, int count, std::uint32_t seed)
{
    return repeated(count, seed, [&](Random& random) {
        const glm::dvec2 size(width, height);
        const glm::dvec2 start = glm::dvec2(std::floor(random.unit() * width), std::floor(random.unit() * height)) + 0.5;
        const double way = std::floor(1. + random.unit() * 40.);
        const glm::dvec2 steps[] = {{1, 1}, {-1, 1}, {1, -1}, {2, 1}, {-1, -3}};
        return ray(start / size, steps[int(random.unit() * 5.)] * way / size, depth);
    });
}

Rays zeroComponents(int, int, double depth, int count, std::uint32_t seed)
{
    int k = 0;
    return repeated(count, seed, [&](Random& random) {
        const double travel = depth * std::tan(89. * random.unit() * kTau / 360.);
        return k++ % 2 ? ray(random.point(), {-0., travel}, depth) : ray(random.point(), {-travel, 0.}, depth);
    });
}

Rays negative(int, int, double depth, int count, std::uint32_t seed)
{
    return repeated(count, seed,
        [&](Random& random) { return rayAt(random.point() - 1., 88. * random.unit(), kTau * (0.5 + 0.25 * random.unit()), depth); });
}

Rays depths(int, int, double, int count, std::uint32_t seed)
{
    int k = 0;
    return repeated(count, seed, [&](Random& random) {
        constexpr double kDepths[] = {0.005, 0.02, 0.08, 0.2, 0.5};
        return rayAt(random.point(), 85. * random.unit(), kTau * random.unit(), kDepths[k++ % 5]);
    });
}

Rays tiled(int, int, double depth, int count, std::uint32_t seed)
{
    return repeated(
        count, seed, [&](Random& random) { return rayAt(64. * random.point(), 80. * random.unit(), kTau * random.unit(), depth); });
}

Rays scales(int, int, double depth, int count, std::uint32_t seed)
{
    int k = 0;
    return repeated(count, seed, [&](Random& random) {
        constexpr double kScales[] = {1e-12, 1e-6, 1e-3, 1e2};
        const double turn = kTau * random.unit();
        return ray(random.point(), glm::dvec2(std::cos(turn), std::sin(turn)) * kScales[k++ % 4] * (0.1 + random.unit()), depth);
    });
}

Rays grazing(int, int, double depth, int count, std::uint32_t seed)
{
    return repeated(count, seed, [&](Random& random) { return rayAt(random.point(), 89.9, kTau * random.unit(), depth); });
}

// As far out as a float still tells texels apart well.
Rays farAway(int width, int, double depth, int count, std::uint32_t seed)
{
    return repeated(count, seed, [&](Random& random) {
        const double tiles = 16384. / width;
        return rayAt(tiles * (random.point() - 0.5), 80. * random.unit(), kTau * random.unit(), depth);
    });
}

Rays enormous(int, int, double depth, int count, std::uint32_t seed)
{
    return repeated(count, seed, [&](Random& random) {
        const double size = std::pow(10., 6. + 30. * random.unit());
        const bool start = random.unit() < 0.5;
        return ray((random.point() - 0.5) * (start ? size : 1.), (random.point() - 0.5) * (start ? 1. : size), depth);
    });
}

// Every combination of values that are not numbers, not finite, or denormal.
Rays broken(int, int, double depth, int, std::uint32_t)
{
    constexpr double kInf = std::numeric_limits<double>::infinity(), kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kValues[] = {0., 0.25, kNan, kInf, -kInf, 1e-45, -1e-40, 3e38};
    Rays rays;
    for (const double u : kValues)
        for (const double v : kValues)
            for (const double du : kValues)
                for (const double dv : kValues)
                    rays.push_back(ray({u, v}, {du, dv}, depth));
    return rays;
}

} // namespace

SearchRay rayAt(glm::dvec2 uv, double angle, double turn, double depth)
{
    const double radians = angle * kTau / 360., travel = depth * std::tan(radians);
    return {asFloats(uv), asFloats({travel * std::cos(turn), travel * std::sin(turn)}), double(float(std::cos(radians)))};
}

std::vector<SearchRay> atMesh(const TechniqueRow& technique, std::span<const SearchRay> rays)
{
    std::vector<SearchRay> moved(rays.begin(), rays.end());
    if (technique.meshDepth() > 0.f)
        for (SearchRay& ray : moved)
            ray.uv += ray.duv * double(technique.meshDepth());
    return moved;
}

std::vector<SearchRay> bandRays(AngleBand band, double depth, int count, std::uint32_t seed)
{
    return repeated(count, seed, [&](Random& random) {
        const double angle = band.from + (band.to - band.from) * random.unit();
        const double turn = kTau * random.unit();
        return rayAt(random.point(), angle, turn, depth);
    });
}

const std::array<RaySetRow, 13> kSpecialRays = {{
    {"straight-down", straightDown, true, "Exactly 0 degrees: duv = 0."},
    {"45", diagonal, true, "Exactly 45 degrees, along the axes and the diagonals."},
    {"edges", alongEdges, true, "Along the lines between texel centres."},
    {"vertices", throughVertices, true, "From texel centre to texel centre, through others."},
    {"zero-components", zeroComponents, true, "du or dv is 0 or -0."},
    {"negative", negative, true, "Both components negative, starts below 0."},
    {"depths", depths, true, "Depths from 0.005 to 0.5 of the tile."},
    {"tiled", tiled, true, "Starts within 64 tiles."},
    {"scales", scales, true, "Lateral travel from 1e-12 to 100 tiles."},
    {"grazing", grazing, true, "Exactly 89.9 degrees."},
    {"far", farAway, true, "Starts thousands of texels from the origin."},
    {"enormous", enormous, false, "Starts or travel up to 1e36."},
    {"broken", broken, false, "NaN, infinities, denormals and their neighbours."},
}};

} // namespace relievo
