// Error counts on cases made by hand; PSNR and FLIP on pictures whose difference is known.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/image_metrics.h"
#include "core/analysis/metrics.h"
#include "core/analysis/ray_sets.h"
#include "core/image/samples/hard_cases.h"
#include "core/state/techniques.h"
#include "core/trace/reference.h"
#include "core/trace/shader_on_cpu.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace relievo;

namespace {

SearchHit hitAt(double t, int fetches = 1)
{
    return {true, t, {0., 0.}, fetches};
}

// 10 x 5 texels of height 0.5: the exact answer is t = 0.5 for every ray.
const HeightField kGround(10, 5, std::vector<float>(50, 0.5f));

HitErrors compared(std::vector<SearchHit> hits, glm::dvec2 duv = {1., 0.})
{
    const SearchRay ray{{0.1, 0.1}, duv, 0.5};
    for (SearchHit& hit : hits)
        if (std::isfinite(hit.uv.x))
            hit.uv = ray.uv + ray.duv * hit.t;
    const std::vector<SearchRay> rays(hits.size(), ray);
    SearchHit right = hitAt(0.5);
    right.uv = ray.uv + ray.duv * right.t;
    const std::vector<SearchHit> exact(hits.size(), right);
    return compareHits(kGround, rays, hits, exact);
}

Image picture(int width, int height, auto color)
{
    Image image{width, height, 4, PixelType::U8, 8, false, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::array<int, 3> c = color(x, y);
            for (const int v : c)
                image.data.push_back(std::byte(v));
            image.data.push_back(std::byte(255));
        }
    return image;
}
Image plain(int r, int g, int b)
{
    return picture(40, 30, [=](int, int) { return std::array{r, g, b}; });
}
Image noisy(int strength, std::uint32_t seed = 1)
{
    std::mt19937 random(seed);
    return picture(60, 50, [&](int x, int) {
        const int v = 80 + x + int(random() % std::uint32_t(2 * strength + 1)) - strength;
        return std::array{v, v, v};
    });
}

double meanFlip(const Image& reference, const Image& test, double pixelsPerDegree = kPixelsPerDegree)
{
    return Flip(reference, pixelsPerDegree).mean(test);
}

} // namespace

TEST(Metrics, DeepShortAndRight)
{
    const HitErrors errors = compared({hitAt(0.5, 3), hitAt(0.7, 5), hitAt(0.3, 7), hitAt(0.501, 9)});
    EXPECT_EQ(errors.rays, 4u);
    EXPECT_EQ(errors.tooDeep, 1u);
    EXPECT_EQ(errors.tooShort, 1u);
    EXPECT_EQ(errors.ties, 0u);
    EXPECT_DOUBLE_EQ(errors.wrongShare(), 0.5);
    EXPECT_NEAR(errors.rmse, std::sqrt((0.04 + 0.04 + 1e-6) / 4.), 1e-12);
    EXPECT_NEAR(errors.largest, 0.2, 1e-12);
    EXPECT_NEAR(errors.largestTexels, 2., 1e-12); // 10 texels along u
    EXPECT_DOUBLE_EQ(errors.meanFetches, 6.);
    EXPECT_EQ(errors.maxFetches, 9);
}

TEST(Metrics, BothThresholdsMustBePassed)
{
    EXPECT_EQ(compared({hitAt(0.54)}, {1., 0.}).wrongShare(), 0.); // 0.4 texels
    EXPECT_EQ(compared({hitAt(0.56)}, {1., 0.}).wrongShare(), 1.); // 0.6 texels
    EXPECT_EQ(compared({hitAt(0.56)}, {0., 1.}).wrongShare(), 0.); // 5 texels along v
    EXPECT_EQ(compared({hitAt(0.5015)}, {100., 0.}).wrongShare(), 0.); // 1.5 texels, 0.0015 of the depth
    EXPECT_EQ(compared({hitAt(0.9)}, {0., 0.}).wrongShare(), 0.); // straight down nothing is sideways
}

TEST(Metrics, NothingFoundCountsAsTheFloor)
{
    const HitErrors errors = compared({SearchHit{false, 0.2, {0., 0.}, 4}});
    EXPECT_EQ(errors.notFound, 1u);
    EXPECT_EQ(errors.tooDeep, 1u);
    EXPECT_NEAR(errors.rmse, 0.5, 1e-12);
}

TEST(Metrics, NumbersThatAreNoneAreCountedApart)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const HitErrors errors = compared({hitAt(nan), hitAt(-0.1), hitAt(1.5), SearchHit{true, 0.5, {nan, 0.}, 1}, hitAt(0.5)});
    EXPECT_EQ(errors.invalid, 4u);
    EXPECT_EQ(errors.rays, 1u);
    EXPECT_EQ(errors.rmse, 0.);
}

TEST(Metrics, RaysWithoutAnAnswerAreLeftOut)
{
    const SearchRay rays[] = {{{0., 0.}, {1., 0.}, 1.}};
    const SearchHit hits[] = {hitAt(0.9)}, exact[] = {SearchHit{}};
    EXPECT_EQ(compareHits(kGround, rays, hits, exact).rays, 0u);
}

TEST(Metrics, PercentileOfTheFetches)
{
    std::vector<SearchHit> hits;
    for (int i = 1; i <= 200; ++i)
        hits.push_back(hitAt(0.5, i));
    const HitErrors errors = compared(hits);
    EXPECT_EQ(errors.p99Fetches, 198.);
    EXPECT_EQ(errors.maxFetches, 200);
    EXPECT_DOUBLE_EQ(errors.meanFetches, 100.5);
}

// A ray that brushes a crest within a hair: passing it is a tie, passing a crest that stands clearly in the way is not.
TEST(Metrics, TiesAreCountedApart)
{
    std::vector<float> heights(32, 0.f);
    for (int y = 0; y < 4; ++y)
        heights[std::size_t(y * 8 + 4)] = 0.5f; // a wall at u = 4.5 / 8
    const HeightField field(8, 4, heights);
    const auto errorsFor = [&](double clearance) {
        const double t = 0.5 + clearance; // height 0.5 - clearance at the crest
        const SearchRay rays[] = {{{4.5 / 8. - 0.5 * t, 0.3}, {0.5, 0.}, 0.5}};
        const SearchHit exact[] = {exactHit(field, rays[0])}, hits[] = {{true, 1., rays[0].uv + rays[0].duv, 1}};
        EXPECT_LT(exact[0].t, 0.6);
        return compareHits(field, rays, hits, exact);
    };
    EXPECT_EQ(errorsFor(0.5e-4).ties, 1u);
    EXPECT_EQ(errorsFor(0.5e-4).tooDeep, 0u);
    EXPECT_EQ(errorsFor(0.5e-4).rmse, 0.);
    EXPECT_EQ(errorsFor(3e-4).ties, 0u);
    EXPECT_EQ(errorsFor(3e-4).tooDeep, 1u);
}

// They are left out of the figures of t, and so are their rays.
TEST(Metrics, TiesDoNotDiluteTheOthers)
{
    HitErrors tie, error;
    tie.rays = tie.ties = 3;
    error.rays = 1, error.rmse = 0.2, error.rmseTexels = 4.;
    const HitErrors both = together(std::vector<HitErrors>{tie, error});
    EXPECT_DOUBLE_EQ(both.rmse, 0.2);
    EXPECT_DOUBLE_EQ(both.rmseTexels, 4.);
}

// Offset limiting shifts the texture less than the depth it finds would.
TEST(Metrics, SidewaysCountsWhereTheTextureIsRead)
{
    const SearchRay ray{{0.1, 0.1}, {20., 0.}, 0.05};
    Parameters limited;
    limited.offsetLimiting = true;
    const auto errorsOf = [&](const Parameters& parameters) {
        return compareHits(
            kGround, {&ray, 1}, *traceRays("parallax", parameters, &kGround, {&ray, 1}), std::vector{exactHit(kGround, ray)});
    };
    EXPECT_NEAR(errorsOf({}).largestTexels, 0., 1e-4); // flat ground: right at any view
    EXPECT_NEAR(errorsOf(limited).largestTexels, 0.95 * 100., 1e-3); // of 10 tiles of 10 texels only the share cosView
    EXPECT_NEAR(errorsOf(limited).largest, 0., 1e-6);
}

TEST(Metrics, RaisingTheSurfaceIsExact)
{
    std::mt19937 random(3);
    const HeightField field = findHardCase("noise")->make(8, 3);
    std::vector<float> lower(field.texels().begin(), field.texels().end());
    for (float& h : lower)
        h *= 0.5f;
    std::vector<float> raised = lower;
    for (float& h : raised)
        h += 0.25f;
    const HeightField low(8, 8, lower, Wrap::Repeat, 32), high(8, 8, raised, Wrap::Repeat, 32);
    for (const SearchRay& ray : bandRays(kAngleBands[1], 0.3, 300, 2)) {
        EXPECT_NEAR(exactHit(low, ray, 0.25).t, exactHit(high, ray).t, 1e-6);
        EXPECT_NEAR(exactHit(high, ray, -0.25).t, exactHit(low, ray).t, 1e-6);
        EXPECT_LE(exactHit(low, ray, 0.1).t, exactHit(low, ray).t);
    }
    EXPECT_EQ(exactHit(low, {{0., 0.}, {0.1, 0.}, 1.}, 5.).t, 0.);
    EXPECT_EQ(exactHit(low, {{0., 0.}, {0.1, 0.}, 1.}, -5.).t, 1.);
}

TEST(Metrics, SetsAddUp)
{
    const HitErrors a = compared({hitAt(0.7, 2), hitAt(0.5, 4)}), b = compared({hitAt(0.2, 8), hitAt(0.5, 2)});
    const HitErrors sets[] = {a, b};
    const HitErrors both = together(sets), direct = compared({hitAt(0.7, 2), hitAt(0.5, 4), hitAt(0.2, 8), hitAt(0.5, 2)});
    EXPECT_EQ(both.rays, 4u);
    EXPECT_EQ(both.tooDeep, direct.tooDeep);
    EXPECT_NEAR(both.rmse, direct.rmse, 1e-12);
    EXPECT_NEAR(both.rmseTexels, direct.rmseTexels, 1e-12);
    EXPECT_DOUBLE_EQ(both.meanFetches, direct.meanFetches);
    EXPECT_EQ(both.maxFetches, 8);
    EXPECT_EQ(together({}).rays, 0u);
}

// Techniques that are flagged exact, on random small fields and rays of every band, against the reference.
TEST(Metrics, ExactTechniquesHaveNoErrors)
{
    int exactOnes = 0;
    for (const TechniqueRow& row : kTechniques) {
        if (!row.isExact)
            continue;
        ++exactOnes;
        for (std::uint32_t seed = 0; seed < 60; ++seed) {
            const HeightField field = kHardCases[seed % kHardCases.size()].make(4 + int(seed * 5 % 23), seed);
            const auto maps = searchMaps(row.key, Parameters(), &field);
            ASSERT_TRUE(maps) << row.key;
            for (const AngleBand band : kAngleBands) {
                const auto rays = bandRays(band, 0.1, 50, seed);
                const auto hits = traceRays(row.key, Parameters(), *maps, rays), exact = traceRays("reference", Parameters(), *maps, rays);
                const HitErrors errors = compareHits(field, rays, *hits, *exact);
                EXPECT_EQ(errors.tooDeep + errors.tooShort + errors.invalid, 0u) << row.key << " seed " << seed << " from " << band.from;
            }
        }
    }
    EXPECT_GE(exactOnes, 1);
}

TEST(Psnr, KnownValues)
{
    EXPECT_EQ(psnr(plain(10, 20, 30), plain(10, 20, 30)), std::numeric_limits<double>::infinity());
    EXPECT_NEAR(psnr(plain(0, 0, 0), plain(255, 255, 255)), 0., 1e-9);
    EXPECT_NEAR(psnr(plain(100, 100, 100), plain(101, 101, 101)), 20. * std::log10(255.), 1e-9);
    EXPECT_NEAR(psnr(plain(100, 100, 100), plain(103, 100, 100)), 20. * std::log10(255. / std::sqrt(3.)), 1e-9);
}

TEST(Flip, NothingForEqualPictures)
{
    EXPECT_EQ(meanFlip(plain(90, 10, 200), plain(90, 10, 200)), 0.);
    EXPECT_EQ(meanFlip(noisy(20), noisy(20)), 0.);
}

TEST(Flip, GreenAgainstBlueIsTheMost)
{
    EXPECT_NEAR(meanFlip(plain(0, 255, 0), plain(0, 0, 255)), 1., 1e-3);
    const double blackWhite = meanFlip(plain(0, 0, 0), plain(255, 255, 255));
    EXPECT_GT(blackWhite, 0.9);
    EXPECT_LT(blackWhite, 1.);
}

// The colour pipeline by hand for two greys: lightness 53.585 (119) and 53.977 (120), no chroma, below the knee.
TEST(Flip, SmallDifferenceOfGreysByHand)
{
    const auto lightness = [](double srgb) {
        const double y = std::pow((srgb / 255. + 0.055) / 1.055, 2.4);
        return 116. * std::cbrt(y) - 16.;
    };
    // Hunt-adjusted green (87.735, -75.6, 73.0) and blue (32.297, 25.58, -34.84): chroma x lightness / 100.
    const double most
        = std::pow(std::abs(87.735 - 32.297) + std::hypot(-86.183 * 0.87735 - 79.188 * 0.32297, 83.180 * 0.87735 + 107.860 * 0.32297), 0.7);
    const double wanted = 0.95 * std::pow(lightness(120) - lightness(119), 0.7) / (0.4 * most);
    EXPECT_NEAR(meanFlip(plain(119, 119, 119), plain(120, 120, 120)), wanted, 0.002);
}

// Four pixels beside an edge that the reference lacks, the blurred colours no longer know of it but the feature detectors do: the
// difference is that far from the edge, raised to 1 - feature (sections 4.3 and 4.4).
TEST(Flip, FeaturesByHand)
{
    const Image edge = picture(80, 40, [](int x, int) { return x < 40 ? std::array{60, 60, 60} : std::array{120, 120, 120}; });
    const std::vector<float> map = Flip(picture(80, 40, [](int, int) { return std::array{110, 110, 110}; })).map(edge);
    const double deviation = 0.5 * 0.082 * kPixelsPerDegree, square = deviation * deviation;
    const int radius = int(std::ceil(3. * deviation));
    double edgeBeyond = 0., edgeAll = 0., pointBeyond = 0., pointPositive = 0., pointNegative = 0.;
    for (int x = -radius; x <= radius; ++x) {
        const double gauss = std::exp(-x * x / (2. * square)), point = (x * x / square - 1.) * gauss;
        edgeAll += x < 0 ? -x * gauss : 0.;
        edgeBeyond += x < -4 ? -x * gauss : 0.;
        (point > 0. ? pointPositive : pointNegative) += point;
    }
    for (int x = -radius; x < -4; ++x) {
        const double point = (x * x / square - 1.) * std::exp(-x * x / (2. * square));
        pointBeyond += point / (point > 0. ? pointPositive : -pointNegative);
    }
    const auto luminance = [](double srgb) { return std::pow((srgb / 255. + 0.055) / 1.055, 2.4); };
    const double step = luminance(120) - luminance(60), strongest = step * std::max(edgeBeyond / edgeAll, std::abs(pointBeyond));
    const double feature = std::sqrt(strongest / std::sqrt(2.)), far = double(map[20 * 80 + 70]);
    EXPECT_GT(feature, 0.1);
    EXPECT_NEAR(double(map[20 * 80 + 44]), std::pow(far, 1. - feature), 0.003);
}

TEST(Flip, GrowsWithTheDifference)
{
    double last = 0.;
    for (const int strength : {1, 4, 16, 60}) {
        const double flip = meanFlip(noisy(0), noisy(strength));
        EXPECT_GT(flip, last);
        last = flip;
    }
    EXPECT_LT(last, 1.);
}

TEST(Flip, IsSymmetricAndStaysInRange)
{
    const Image a = noisy(50, 1), b = noisy(50, 2);
    EXPECT_NEAR(meanFlip(a, b), meanFlip(b, a), 1e-6);
    for (const float v : Flip(a).map(b))
        EXPECT_TRUE(v >= 0.f && v <= 1.f);
}

// A line that is missing is seen where it was, and far from it nothing is.
TEST(Flip, IsLocal)
{
    const auto lined = [](int column) {
        return picture(120, 40, [=](int x, int) { return x == column ? std::array{255, 255, 255} : std::array{40, 40, 40}; });
    };
    const auto map = Flip(lined(20)).map(lined(-1));
    EXPECT_GT(map[20 * 120 + 20], 0.3f);
    EXPECT_EQ(map[20 * 120 + 100], 0.f);
}

// Seen from farther away, fine noise fades.
TEST(Flip, FollowsTheViewingDistance)
{
    EXPECT_LT(meanFlip(noisy(0), noisy(30), 200.), meanFlip(noisy(0), noisy(30), 30.));
}
