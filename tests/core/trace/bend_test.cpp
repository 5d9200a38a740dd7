// Searches on curved surfaces: the bent ray against brute force in double precision.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/techniques.h"
#include "core/trace/shader_on_cpu.h"
#include "tests/core/trace/bilinear.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace relievo;

namespace {

// Depth of the ray less depth of the surface: the ray is inside where it is not negative.
double inside(const HeightField& field, const SearchRay& ray, double t)
{
    return t - (ray.bend.x + (ray.bend.y + ray.bend.z * t) * t) - (1. - heightAt(field, ray.uv + ray.duv * t));
}

double firstInside(const HeightField& field, const SearchRay& ray)
{
    constexpr int kSteps = 20000;
    for (int i = 0; i <= kSteps; ++i) {
        const double t = double(i) / kSteps;
        if (inside(field, ray, t) < 0.)
            continue;
        double from = std::max(0., t - 1. / kSteps), to = t;
        for (int k = 0; k < 40; ++k) {
            const double middle = 0.5 * (from + to);
            (inside(field, ray, middle) < 0. ? from : to) = middle;
        }
        return to;
    }
    return 2.;
}

HeightField noise(std::mt19937& random, bool smooth)
{
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    const int size = 5 + int(random() % 20);
    std::vector<float> heights;
    for (int i = 0; i < size * size; ++i)
        heights.push_back(
            smooth ? 0.4f + 0.3f * std::sin(float(i % size) * 0.8f) * std::cos(float(i / size) * 0.5f) : unit(random) * 0.98f);
    return {size, size, heights, random() % 4 ? Wrap::Repeat : Wrap::Clamp, 32};
}

// As view_ray/view_ray_curved.glsl bends rays: view rays over a surface whose fall is k t^2 (convex rays that leave, rays that come to the
// floor, hollows), and of light that comes in over the rim of a hollow, begins below the top and sinks after its highest point.
SearchRay bentRay(std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(-1., 1.);
    SearchRay ray{{unit(random), unit(random)}, {1.5 * unit(random), 1.5 * unit(random)}, 0.5};
    if (random() % 4 == 0) {
        const double top = 0.15 + 0.15 * unit(random), rise = (top + std::sqrt(top)) * (1. + unit(random)); // up to the polygon at most
        ray.bend = {-top, 1. + rise, -(1. - top + rise)}; // depth top - rise t + ..., 1 at the end
        return ray;
    }
    const double k = std::pow(10., unit(random) * 1.5) * (random() % 3 ? 1. : -1.);
    const bool leaves = k > 0.25;
    const double whole = leaves ? 1. / k : 2. / (1. + std::sqrt(1. - 4. * k)), bend = k * whole * whole;
    ray.bend = {0., leaves ? 1. - bend : -bend, bend};
    return ray;
}

struct Tally {
    int rays = 0, wrong = 0;
    double fetches = 0.;
};

Tally searched(std::string_view key, const Parameters& parameters, unsigned seed, bool bent = true)
{
    std::mt19937 random(seed);
    Tally tally;
    for (int i = 0; i < 60; ++i) {
        const HeightField field = noise(random, i % 2 == 0);
        std::vector<SearchRay> rays;
        for (int k = 0; k < 20; ++k)
            rays.push_back(bentRay(random)), rays.back().bend *= bent ? 1. : 0.;
        const auto hits = traceRays(key, parameters, &field, rays);
        EXPECT_TRUE(hits) << key;
        for (std::size_t k = 0; hits && k < rays.size(); ++k) {
            const double truth = firstInside(field, rays[k]);
            const SearchHit& hit = (*hits)[k];
            ++tally.rays;
            tally.fetches += hit.fetches;
            EXPECT_TRUE(std::isfinite(hit.t)) << key;
            // A ray that only touches a peak between two steps of the brute force counts where its own hit lies on the surface.
            const bool touches = hit.found && hit.t < truth && std::abs(inside(field, rays[k], hit.t)) < 2e-4;
            tally.wrong += !touches && (hit.found != (truth <= 1.) || (hit.found && std::abs(hit.t - truth) > 2e-3));
        }
    }
    return tally;
}

} // namespace

TEST(Bend, ExactTechniquesStayExact)
{
    for (const std::string_view key : {"pyramid", "cell-cone"}) {
        const Tally tally = searched(key, Parameters(), 1);
        EXPECT_EQ(tally.rays, 1200);
        EXPECT_EQ(tally.wrong, 0) << key;
    }
}

// The others are as right as on flat polygons: fine steps find nearly all, and no cone leaps too far because of the bend (on noise some do
// without it).
TEST(Bend, OthersFollowTheBend)
{
    Parameters fine;
    fine.minSteps = fine.maxSteps = 512, fine.refineSteps = 12, fine.leapSteps = 2048, fine.provenStep = true, fine.lastBracket = true;
    for (const TechniqueRow& row : kTechniques)
        if (row.hasShadowsAndOutlines() && !row.file.empty() && row.key != "relief-fixed" && row.key != "sphere") {
            const Tally tally = searched(row.key, fine, 2);
            const Tally straight = searched(row.key, fine, 2, false);
            EXPECT_LE(tally.wrong, straight.wrong + tally.rays / 50) << row.key << ", straight " << straight.wrong;
        }
}

// The way out of the relief is no floor: over ground that is nowhere high a ray that bends out again finds nothing.
TEST(Bend, RaysThatLeaveAreMissed)
{
    const HeightField low(4, 4, std::vector<float>(16, 0.2f));
    SearchRay ray{{0.1, 0.2}, {0.7, 0.4}, 0.5};
    ray.bend = {0., 0., 1.}; // depth t - t^2, at most a quarter
    for (const TechniqueRow& row : kTechniques)
        if (row.hasShadowsAndOutlines() && !row.file.empty() && row.key != "cone"
            && row.key != "cone-quad") { // those stop short and call it a hit
            Parameters parameters;
            parameters.leapSteps = 400, parameters.lastBracket = true;
            const auto hits = traceRays(row.key, parameters, &low, std::vector<SearchRay>{ray});
            ASSERT_TRUE(hits) << row.key;
            EXPECT_FALSE(hits->front().found) << row.key;
        }
}
