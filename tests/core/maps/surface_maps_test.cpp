// Horizons, sky visibility and curvature against direct marching and surfaces with a known answer.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/maps.h"
#include "tests/core/maps/maps_support.h"
#include <gtest/gtest.h>
#include <numbers>

using namespace relievo;
using namespace relievo::test;

namespace {

constexpr float kDepth = 0.3f;

// Sine of the elevation by marching from the texel in steps of `step` tiles over two tiles.
double marchedSine(const HeightField& field, int x, int y, double angle, double step)
{
    const glm::dvec2 from((x + 0.5) / field.width(), (y + 0.5) / field.height()), way(std::cos(angle), std::sin(angle));
    double tangent = 0.;
    for (double s = step; s < 2.; s += step) {
        const double rise = double(field.at(glm::vec2(from + s * way))) - double(field.texel(x, y));
        tangent = std::max(tangent, double(kDepth) * rise / s);
    }
    return tangent / std::hypot(1., tangent);
}

Parameters atDepth()
{
    Parameters parameters;
    parameters.depth = kDepth;
    return parameters;
}

// What horizonSines defines, towards azimuth 3 or 5 of 8, whose lines move by shorter / longer texels across per texel along: in whole
// numbers, so that nothing but the heights is rounded.
struct DiagonalHorizon {
    const HeightField& field;
    bool alongU = field.width() >= field.height();
    int length = alongU ? field.width() : field.height(), width = alongU ? field.height() : field.width();
    int shear; // 1 / length texels across per texel along
    bool backward;

    DiagonalHorizon(const HeightField& f, int index) : field(f)
    {
        const int u = -1, v = index == 3 ? 1 : -1;
        shear = (alongU ? v : u) * width;
        backward = (alongU ? u : v) < 0;
    }
    double texel(int k, int across) const
    {
        const int along = backward ? length - 1 - k : k;
        return double(alongU ? field.texel(along, across) : field.texel(across, along));
    }
    // n / length as whole texels and a share of one
    std::pair<int, double> parts(int n) const
    {
        const int rest = (n % length + length) % length;
        return {(n - rest) / length, double(rest) / length};
    }
    double height(int line, int k) const
    {
        const auto [low, share] = parts(line * length + k * shear);
        return (1. - share) * texel(k, low) + share * texel(k, low + 1);
    }
    double slope(int line, int k) const
    {
        double steepest = -1e9;
        for (int far = k + 1; far < 2 * length; ++far)
            steepest = std::max(steepest, (height(line, far) - height(line, k)) / (far - k));
        return steepest;
    }
    double sine(int x, int y) const
    {
        const int along = alongU ? x : y, k = backward ? length - 1 - along : along;
        const auto [line, share] = parts((alongU ? y : x) * length - k * shear);
        const double between = (1. - share) * slope(line, k) + (share > 0. ? share * slope(line + 1, k) : 0.);
        const double tangent = std::max(0., double(kDepth) * between * length / std::numbers::sqrt2);
        return tangent / std::hypot(1., tangent);
    }
};

double stored(const BakedMap& map, int x, int y, int index)
{
    return double(map.levels[0].value(x, index / 4 * (map.levels[0].height / map.slices) + y, index % 4));
}

} // namespace

// Along rows and columns, and along diagonals of square tiles, the scan lines pass through texel centres: there the horizon is exact.
TEST(Horizon, AlongTheAxesItIsTheHighestTexel)
{
    std::mt19937 random(8);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp})
        for (const auto [width, height] : {std::array{1, 1}, {1, 5}, {6, 1}, {16, 16}, {20, 13}}) {
            const HeightField field = fieldOf(
                width, height, [&](int, int) { return unit(random); }, wrap);
            const BakedMap map = *bakeMap(*findBakedMap("horizon"), field, atDepth());
            ASSERT_EQ(map.slices, 2);
            ASSERT_EQ(map.levels[0].height, 2 * height);
            for (int index = 0; index < 8; index += width == height ? 1 : 2) {
                const int dx = std::array{1, 1, 0, -1, -1, -1, 0, 1}[std::size_t(index)],
                          dy = std::array{0, 1, 1, 1, 0, -1, -1, -1}[std::size_t(index)];
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x) {
                        double tangent = 0.;
                        for (int k = 1; k < 2 * std::max(width, height); ++k)
                            tangent = std::max(tangent,
                                double(kDepth) * double(field.texel(x + k * dx, y + k * dy) - field.texel(x, y))
                                    / std::hypot(double(k * dx) / width, double(k * dy) / height));
                        ASSERT_NEAR(stored(map, x, y, index), tangent / std::hypot(1., tangent), 1e-5)
                            << width << 'x' << height << ' ' << x << ',' << y << " azimuth " << index;
                    }
            }
        }
}

TEST(Horizon, AlongDiagonalsOfOblongTilesLinesAreFoundWhereTheyWereSwept)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp})
        for (const auto [width, height] : {std::array{64, 32}, {32, 64}, {48, 32}}) {
            const HeightField field = fieldOf(
                width, height, [&](int, int) { return unit(random); }, wrap);
            for (const int index : {3, 5}) {
                const std::vector<float> sines = horizonSines(field, kDepth, index, 8);
                const DiagonalHorizon horizon(field, index);
                for (int n = 0; n < width * height; ++n)
                    ASSERT_NEAR(double(sines[std::size_t(n)]), horizon.sine(n % width, n / width), 1e-5)
                        << width << 'x' << height << ' ' << n % width << ',' << n / width << " azimuth " << index;
            }
        }
}

TEST(Horizon, InAnyDirectionItIsWhatMarchingSees)
{
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp})
        for (const auto [width, height] : {std::array{96, 96}, {128, 80}}) {
            const HeightField field = fieldOf(
                width, height,
                [&](int x, int y) {
                    return 0.5f + 0.25f * (std::sin(12.566f * float(x) / float(width)) + std::cos(18.85f * float(y) / float(height)));
                },
                wrap);
            const BakedMap map = *bakeMap(*findBakedMap("horizon-16"), field, atDepth());
            double sum = 0.;
            int count = 0, far = 0;
            for (int index = 0; index < 16; ++index)
                for (int n = 0; n < width * height; n += 97, ++count) {
                    const int x = n % width, y = n / width;
                    const double marched = marchedSine(field, x, y, 2. * std::numbers::pi * index / 16., 1. / 1024);
                    far += std::abs(stored(map, x, y, index) - marched) > 0.05; // at the edge of what a near crest hides
                    sum += std::abs(stored(map, x, y, index) - marched);
                }
            EXPECT_LT(sum / count, 0.008);
            EXPECT_LT(far, count / 50);
        }
}

TEST(Ao, IsTheMeanOverTheHorizons)
{
    const HeightField field = hardField(kHardFields[0], 48, 64);
    const BakedMap ao = *bakeMap(*findBakedMap("ao"), field, atDepth()), horizons = *bakeMap(*findBakedMap("horizon-16"), field, atDepth());
    for (int n = 0; n < 48 * 64; ++n) {
        double open = 0.;
        for (int index = 0; index < 16; ++index)
            open += (1. - std::pow(stored(horizons, n % 48, n / 48, index), 2.)) / 16.;
        ASSERT_NEAR(double(ao.levels[0].value(n % 48, n / 48, 0)), open, 1e-5);
    }
}

// At the foot of a wall as high as the well is wide the horizon is at 45 degrees on that side.
TEST(Ao, OpensUpwardsAndClosesInHoles)
{
    const HeightField flat = hardField(kHardFields.back(), 16, 16);
    const BakedMap open = *bakeMap(*findBakedMap("ao"), flat, atDepth());
    for (int i = 0; i < 16; ++i)
        EXPECT_EQ(open.levels[0].value(i, i, 0), 1.f);
    const HeightField well = fieldOf(64, 64, [](int x, int y) { return std::hypot(x - 32, y - 32) < 3. ? 0.f : 1.f; });
    const Image ao = bakeMap(*findBakedMap("ao"), well, atDepth())->levels[0];
    EXPECT_LT(ao.value(32, 32, 0), 0.1f);
    EXPECT_EQ(ao.value(5, 5, 0), 1.f);
}

TEST(Curvature, OfASphereAndOfAPlane)
{
    constexpr double kRadius = 0.8;
    Parameters parameters;
    parameters.depth = 1.f;
    const HeightField sphere = fieldOf(200, 160, [](int x, int y) {
        const double u = (x + 0.5) / 200. - 0.5, v = (y + 0.5) / 160. - 0.5;
        return float(0.2 + std::sqrt(kRadius * kRadius - u * u - v * v));
    });
    const auto curvatureOf
        = [](float value) { return double(kCurvatureHalf) * double(2.f * value - 1.f) / (1. - std::abs(double(2.f * value - 1.f))); };
    const Image bump = bakeMap(*findBakedMap("curvature"), sphere, parameters)->levels[0];
    for (const auto [x, y] : {std::array{100, 80}, {70, 60}, {130, 110}})
        EXPECT_NEAR(curvatureOf(bump.value(x, y, 0)), 1. / kRadius, 0.05);
    const HeightField ramp = hardField(kHardFields[11], 64, 64);
    EXPECT_NEAR(bakeMap(*findBakedMap("curvature"), ramp, parameters)->levels[0].value(30, 30, 0), 0.5f, 1e-4f);
}
