// The distance volume against distances to a densely sampled surface: interpolated anywhere, it exceeds the true distance by at most
// half a voxel's diagonal.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/maps.h"
#include "tests/core/maps/maps_support.h"
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;

namespace {

constexpr double kScale = double(kDistanceHeightScale);

// Least distance to surface samples on a grid of `step` tiles within a quarter of a tile around, the farthest it can be. Never below the
// true distance.
double sampledDistance(const HeightField& field, glm::dvec3 p, int samples)
{
    const int reach = samples / 4 + 1;
    double best = 1e9;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) {
            const double u = p.x + double(i) / samples, v = p.y + double(j) / samples;
            const double above = std::max(0., (1. - p.z) - double(field.at(glm::vec2(float(u), float(v)))));
            best = std::min(best, std::hypot(u - p.x, v - p.y, kScale * above));
        }
    return best;
}

// Trilinear interpolation as a GPU does it.
double interpolated(const BakedMap& map, Wrap wrap, glm::dvec3 p)
{
    const Image& image = map.levels[0];
    const int width = image.width, height = image.height / map.slices;
    const double x = p.x * width - 0.5, y = p.y * height - 0.5, z = p.z * map.slices - 0.5;
    double sum = 0.;
    for (int corner = 0; corner < 8; ++corner) {
        const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
        const auto weight = [](double c, int d) { return d ? c - std::floor(c) : 1. - (c - std::floor(c)); };
        const int i = wrapIndex(int(std::floor(x)) + dx, width, wrap), j = wrapIndex(int(std::floor(y)) + dy, height, wrap);
        const int k = std::clamp(int(std::floor(z)) + dz, 0, map.slices - 1);
        sum += weight(x, dx) * weight(y, dy) * weight(z, dz) * double(image.value(i, k * height + j, 0));
    }
    return sum;
}

class Distance : public testing::TestWithParam<Wrap> { };

TEST_P(Distance, InterpolatedExceedsTheTrueDistanceByHalfADiagonal)
{
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(0., 1.);
    for (const HardField& hard : kHardFields)
        for (const auto [width, height] : {std::array{1, 1}, {7, 12}, {150, 131}}) {
            const HeightField field = hardField(hard, width, height, GetParam());
            const BakedMap map = *bakeMap(*findBakedMap("distance"), field, Parameters());
            ASSERT_EQ(map.slices, kDistanceSlices);
            ASSERT_EQ(map.levels[0].width, std::min(width, kDistanceSize));
            ASSERT_EQ(map.levels[0].height, std::min(height, kDistanceSize) * map.slices);
            const double half
                = 0.5 * glm::length(glm::dvec3(1. / std::min(width, 128), 1. / std::min(height, 128), kScale / kDistanceSlices));
            for (int n = 0; n < 24; ++n) {
                glm::dvec3 p(1.4 * unit(random) - 0.2, 1.4 * unit(random) - 0.2, unit(random));
                if (n % 3 == 0) // just above the surface, where it matters
                    p.z = std::max(0., 1. - double(field.at(glm::vec2(p))) - 0.02 * unit(random));
                ASSERT_LE(interpolated(map, GetParam(), p), sampledDistance(field, p, 160) + half + 1e-7)
                    << hard.name << ' ' << width << 'x' << height << ' ' << p.x << ' ' << p.y << ' ' << p.z;
            }
        }
}

// At voxel centres it is never above the true distance, and short of it by less than the diagonal of a column and the sampling.
TEST_P(Distance, IsNearTheTrueDistance)
{
    for (const char* name : {"waves", "one wave", "domes", "one needle", "terraces", "flat"}) {
        const auto hard = std::ranges::find_if(kHardFields, [&](const HardField& f) { return std::string_view(f.name) == name; });
        const HeightField field = hardField(*hard, 128, 128, GetParam());
        const BakedMap map = *bakeMap(*findBakedMap("distance"), field, Parameters());
        for (int n = 0; n < 100; ++n) {
            const int i = n * 37 % 128, j = n * 59 % 128, k = n % kDistanceSlices;
            const glm::dvec3 p((i + 0.5) / 128, (j + 0.5) / 128, (k + 0.5) / kDistanceSlices);
            const double stored = double(map.levels[0].value(i, k * 128 + j, 0)), real = sampledDistance(field, p, 256);
            EXPECT_LE(stored, real + 1e-7) << name << ' ' << i << ' ' << j << ' ' << k;
            EXPECT_GE(stored, real - (std::sqrt(2.) + 1.) / 256) << name << ' ' << i << ' ' << j << ' ' << k;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Wraps, Distance, testing::Values(Wrap::Repeat, Wrap::Clamp),
    [](const auto& wrap) { return wrap.param == Wrap::Repeat ? "Repeat" : "Clamp"; });

} // namespace
