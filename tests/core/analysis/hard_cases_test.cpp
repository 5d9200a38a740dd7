// The hard height fields and the ray sets: range, size, seed, tiling, and that the rays are what their names say.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/metrics.h"
#include "core/analysis/ray_sets.h"
#include "core/image/samples/hard_cases.h"
#include "core/scene/resources.h"
#include "core/scene/source.h"
#include "core/state/techniques.h"
#include "core/trace/exact_search.h"
#include "core/trace/reference.h"
#include "core/trace/shader_on_cpu.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

using namespace relievo;

namespace {
bool same(const HeightField& a, const HeightField& b)
{
    return a.width() == b.width() && std::ranges::equal(a.texels(), b.texels());
}
double share(const HeightField& field, auto wanted)
{
    return double(std::ranges::count_if(field.texels(), wanted)) / double(field.texels().size());
}
HeightField made(std::string_view key, int size = 128)
{
    return findHardCase(key)->make(size, 1);
}
} // namespace

TEST(HardCases, AnySizeStaysInRangeAndRepeats)
{
    std::set<std::string_view> keys;
    for (const HardCaseRow& row : kHardCases) {
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        EXPECT_EQ(findHardCase(row.key), &row);
        for (const int size : {1, 2, 3, 17, 64, 100}) {
            const HeightField field = row.make(size, 1);
            EXPECT_LE(std::max(field.width(), field.height()), size) << row.key;
            EXPECT_EQ(field.wrap(), Wrap::Repeat);
            EXPECT_TRUE(std::ranges::all_of(field.texels(), [](float h) { return h >= 0.f && h <= 1.f; })) << row.key;
            EXPECT_TRUE(same(field, row.make(size, 1))) << row.key;
        }
    }
    EXPECT_EQ(findHardCase("soft"), nullptr);
}

TEST(HardCases, RandomOnesFollowTheSeed)
{
    for (const char* key : {"needles", "noise", "holes", "saddles", "bricks", "fbm", "oblong"})
        EXPECT_FALSE(same(made(key), findHardCase(key)->make(128, 2))) << key;
}

TEST(HardCases, AreWhatTheyAreCalled)
{
    EXPECT_NEAR(share(made("needles", 256), [](float h) { return h == 1.f; }), 0.002, 0.0006);
    EXPECT_EQ(share(made("low"), [](float h) { return h == 0.f; }), 1.);
    EXPECT_EQ(share(made("high"), [](float h) { return h == 1.f; }), 1.);
    EXPECT_EQ(std::ranges::count(made("dot").texels(), 1.f), 1);
    EXPECT_EQ(std::ranges::count(made("edge").texels(), 1.f), 128);
    const HeightField checker = made("checker");
    EXPECT_NE(checker.texel(4, 4), checker.texel(5, 4));
    EXPECT_EQ(checker.texel(4, 4), checker.texel(5, 5));
    const HeightField nearFlat = made("near-flat");
    const auto [low, high] = std::ranges::minmax(nearFlat.texels());
    EXPECT_GT(high - low, 0.0005f);
    EXPECT_LT(high - low, 0.0011f);
    const HeightField stairs = made("stairs"); // named: texels() is a view
    for (const float h : stairs.texels())
        EXPECT_NEAR(h * 255.f, std::round(h * 255.f), 1e-3f);
    const HeightField seam = made("seam");
    EXPECT_GT(seam.texel(127, 3) - seam.texel(128, 3), 0.98f);
    const HeightField oblong = made("oblong");
    EXPECT_NE(oblong.width(), oblong.height());
    EXPECT_NE(oblong.width() & (oblong.width() - 1), 0);
    const HeightField walls = made("walls");
    EXPECT_EQ(walls.texel(8, 3), 1.f);
    EXPECT_EQ(walls.texel(8, 2), 0.f);
    EXPECT_EQ(walls.texel(8, 4), 0.f);
}

// The patterns that look continuous have no seam: across the border neighbours differ no more than elsewhere.
TEST(HardCases, TileWithoutASeam)
{
    for (const char* key : {"waves", "ridges", "fbm", "hemispheres", "near-flat", "terraces"}) {
        const HeightField field = made(key, 192);
        float inside = 0.f, border = 0.f;
        for (int j = 0; j < 192; ++j)
            for (int i = 0; i < 192; ++i) {
                const float step
                    = std::max(std::abs(field.texel(i + 1, j) - field.texel(i, j)), std::abs(field.texel(j, i + 1) - field.texel(j, i)));
                (i == 191 ? border : inside) = std::max(i == 191 ? border : inside, step);
            }
        EXPECT_LE(border, inside * 1.05f) << key;
    }
}

TEST(HardCases, OpenAsASource)
{
    for (const std::string source : {"hard:needles@32", "sample:hard-needles@32"}) {
        const auto opened = openSource(source, State());
        ASSERT_TRUE(opened) << message(opened.error());
        EXPECT_FLOAT_EQ(opened->state.parameters.depth, kHardCaseDepth);
        const auto resources = loadResources(opened->state, {}, {});
        ASSERT_TRUE(resources);
        ASSERT_TRUE(resources->material->height);
        EXPECT_TRUE(same(*resources->material->height, made("needles", 32)));
        EXPECT_TRUE(resources->material->warnings.empty());
    }
    for (const char* source : {"hard:soft", "hard:needles@0", "hard:needles@x", "hard:", "sample:hard-soft"})
        EXPECT_FALSE(openSource(source, State())) << source;
    EXPECT_NE(openSource("hard:soft", State()).error().hint.find("needles"), std::string::npos);
}

TEST(RaySets, BandsHoldTheirAngles)
{
    for (const AngleBand band : kAngleBands) {
        const auto rays = bandRays(band, 0.08, 2000, 7);
        ASSERT_EQ(rays.size(), 2000u);
        double least = 90., most = 0., mean = 0.;
        for (const SearchRay& ray : rays) {
            const double angle = std::atan(std::hypot(ray.duv.x, ray.duv.y) / 0.08) * 180. / 3.14159265358979;
            EXPECT_NEAR(std::cos(angle * 3.14159265358979 / 180.), ray.cosView, 1e-6);
            EXPECT_TRUE(ray.uv.x >= 0. && ray.uv.x < 1. + 1e-6 && ray.uv.y >= 0.);
            EXPECT_EQ(ray.duv.x, double(float(ray.duv.x)));
            least = std::min(least, angle), most = std::max(most, angle), mean += angle / 2000.;
        }
        EXPECT_GE(least, band.from - 1e-3);
        EXPECT_LE(most, band.to + 1e-3);
        EXPECT_NEAR(mean, 0.5 * (band.from + band.to), 0.04 * (band.to - band.from));
    }
    EXPECT_EQ(bandRays(kAngleBands[2], 0.08, 10, 3).back().uv, bandRays(kAngleBands[2], 0.08, 10, 3).back().uv);
    EXPECT_NE(bandRays(kAngleBands[2], 0.08, 10, 3).back().uv, bandRays(kAngleBands[2], 0.08, 10, 4).back().uv);
}

TEST(RaySets, SpecialOnesAreWhatTheyAreCalled)
{
    for (const RaySetRow& row : kSpecialRays) {
        const auto rays = row.make(24, 18, 0.08, 64, 1);
        EXPECT_GE(rays.size(), 64u) << row.key;
        bool finite = true;
        for (const SearchRay& ray : rays) {
            finite &= std::isfinite(ray.uv.x) && std::isfinite(ray.uv.y) && std::isfinite(ray.duv.x) && std::isfinite(ray.duv.y);
            EXPECT_TRUE(ray.cosView > 0. && ray.cosView <= 1.) << row.key;
        }
        EXPECT_EQ(finite, row.key != "broken") << row.key;
    }
    for (const SearchRay& ray : kSpecialRays[0].make(8, 8, 0.1, 9, 1))
        EXPECT_EQ(ray.duv, glm::dvec2(0.));
    for (const SearchRay& ray : kSpecialRays[1].make(8, 8, 0.1, 8, 1))
        EXPECT_NEAR(ray.cosView, std::sqrt(0.5), 1e-6);
    for (const SearchRay& ray : kSpecialRays[3].make(16, 8, 0.1, 50, 1)) {
        EXPECT_NEAR(std::remainder(ray.uv.x * 16. - 0.5, 1.), 0., 1e-5);
        EXPECT_NEAR(std::remainder(ray.duv.y * 8., 1.), 0., 1e-4);
    }
}

// Rays that run along a wall so nearly that a step beyond it rounds back onto it: no search may stand still there.
TEST(RaySets, RaysAlmostAlongAWallArriveAll)
{
    const HeightField field = findHardCase("noise")->make(256, 1);
    const SearchRay rays[] = {{{0.193373919, 0.67387563}, {-0.131045178, -0.000282375928}, 0.5},
        {{0.0333252661, 0.69795537}, {-0.00176860718, -0.846462548}, 0.1}};
    for (const TechniqueRow& row : kTechniques) {
        if (!row.isExact || row.file.empty())
            continue;
        const auto hits = *traceRays(row.key, Parameters(), &field, rays);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_NEAR(hits[i].t, exactHit(field, rays[i]).t, 1e-4) << row.key;
            EXPECT_LT(hits[i].fetches, 1000) << row.key;
        }
    }
}

// Rays of hundreds of steps that just touch the surface: the rounding of so many steps, added up, would let them through or stop them.
TEST(RaySets, ManySmallStepsDoNotAddUpToAnError)
{
    constexpr struct {
        std::string_view field;
        std::size_t ray;
    } kTouching[] = {{"needles", 20684}, {"checker", 46134}};
    for (const auto& [key, ray] : kTouching) {
        const HeightField field = findHardCase(key)->make(kHardCaseSize, 1);
        const std::vector<SearchRay> rays = {bandRays(kAngleBands[3], kHardCaseDepth, int(ray) + 1, 1)[ray]};
        const std::vector<SearchHit> exact = {exactHit(field, rays[0])};
        for (const TechniqueRow& row : kTechniques)
            if (row.isExact && !row.file.empty()) {
                const HitErrors errors = compareHits(field, rays, *traceRays(row.key, Parameters(), &field, rays), exact);
                EXPECT_EQ(errors.tooDeep + errors.tooShort, 0u) << row.key << " on " << key;
            }
    }
}

// Every technique survives every special ray on every hard case, and those that are exact stay exact.
TEST(RaySets, EveryTechniqueSurvivesThem)
{
    for (const HardCaseRow& hard : kHardCases) {
        const HeightField field = hard.make(24, 1);
        for (const TechniqueRow& row : kTechniques) {
            if (row.file.empty())
                continue; // the reference is measured against, and walks every cell of an enormous ray
            const auto maps = searchMaps(row.key, Parameters(), &field);
            ASSERT_TRUE(maps) << row.key;
            for (const RaySetRow& set : kSpecialRays) {
                const auto rays = set.make(field.width(), field.height(), 0.08, 40, 5);
                const auto hits = traceRays(row.key, Parameters(), *maps, rays);
                ASSERT_TRUE(hits);
                for (std::size_t i = 0; i < rays.size(); ++i) {
                    const SearchHit& hit = (*hits)[i];
                    EXPECT_TRUE(hit.t >= 0. && hit.t <= 1. && hit.fetches >= 0) << row.key << ' ' << set.key;
                }
                if (!set.measured)
                    continue;
                std::vector<SearchHit> exact;
                for (const SearchRay& ray : rays)
                    exact.push_back(exactHit(field, ray));
                const HitErrors errors = compareHits(field, rays, *hits, exact);
                EXPECT_EQ(errors.invalid, 0u) << row.key << ' ' << set.key;
                if (row.isExact) {
                    EXPECT_EQ(errors.tooDeep + errors.tooShort, 0u) << row.key << ' ' << set.key << ' ' << hard.key;
                }
            }
        }
    }
}

// The paper's distances lead near the surface in few steps; made safe, they never lead through it.
TEST(HardCases, BallsAreLongOrSafe)
{
    Parameters parameters;
    parameters.leapSteps = 32;
    const auto errorsOf = [&](const char* key, bool safe) {
        const HeightField field = made(key);
        const auto rays = bandRays(kAngleBands[0], kHardCaseDepth, 1000, 5);
        const ExactSearch search(field);
        std::vector<SearchHit> exact;
        for (const SearchRay& ray : rays)
            exact.push_back(search.hit(ray));
        parameters.safeBalls = safe;
        return compareHits(field, rays, *traceRays("sphere", parameters, &field, rays), exact);
    };
    EXPECT_LT(errorsOf("waves", false).rmse, 0.03);
    EXPECT_GT(errorsOf("waves", true).rmse, errorsOf("waves", false).rmse);
    for (const HardCaseRow& row : kHardCases)
        EXPECT_EQ(errorsOf(std::string(row.key).c_str(), true).tooDeep, 0u) << row.key;
}
