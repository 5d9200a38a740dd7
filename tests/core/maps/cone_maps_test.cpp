// Cone maps against the plain definition on small fields: never wider than the true cone, never much narrower.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/acceleration/cone_search.h"
#include "core/maps/acceleration/relaxed_cell.h"
#include "core/maps/maps.h"
#include "tests/core/maps/maps_support.h"
#include <atomic>
#include <chrono>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <thread>

using namespace relievo;
using namespace relievo::test;

namespace {

constexpr double kCap = double(kWidestCone);
constexpr int kImages = 4; // of the tile to each side

struct Offset {
    int x, y; // from the apex, texels
};
// The limit that the item at (x, y), seen under `offset`, puts on an apex of height `apex`.
using Limit = std::function<double(const HeightField&, int x, int y, Offset offset, double apex)>;

double distance(const HeightField& field, double x, double y)
{
    return std::hypot(x / field.width(), y / field.height());
}

// The smallest limit over all texels (border: also column and row -1) and all images of the tile.
double bruteRatio(const HeightField& field, int x, int y, const Limit& limit, int border = 0)
{
    const int images = field.wrap() == Wrap::Repeat ? kImages : 0, first = field.wrap() == Wrap::Clamp ? -border : 0;
    double best = kCap;
    for (int tileY = -images; tileY <= images; ++tileY)
        for (int tileX = -images; tileX <= images; ++tileX)
            for (int j = first; j < field.height(); ++j)
                for (int i = first; i < field.width(); ++i)
                    best = std::min(best,
                        limit(field, i, j, {i + tileX * field.width() - x, j + tileY * field.height() - y}, double(field.texel(x, y))));
    return best;
}

double texelLimit(const HeightField& field, int x, int y, Offset offset, double apex)
{
    const double rise = double(field.texel(x, y)) - apex;
    return rise > 0. ? distance(field, offset.x, offset.y) / rise : kCap;
}

double relaxedLimit(const HeightField& field, int x, int y, Offset offset, double apex)
{
    HeightField::Corners c = field.corners(x, y);
    RelaxedCell cell{c, double(offset.x), double(offset.y), 1. / field.width(), 1. / field.height()};
    if (offset.x < 0) {
        std::swap(cell.corners.h00, cell.corners.h10);
        std::swap(cell.corners.h01, cell.corners.h11);
        cell.x = -offset.x - 1;
    }
    if (offset.y < 0) {
        std::swap(cell.corners.h00, cell.corners.h01);
        std::swap(cell.corners.h10, cell.corners.h11);
        cell.y = -offset.y - 1;
    }
    return relaxedRatio(cell, apex);
}

// Ban et al. 2024: the cell behind the texel, seen from the apex, must fall somewhere; on an axis either of the two cells.
double robustLimit(const HeightField& field, int x, int y, Offset offset, double apex)
{
    for (const int sx : {-1, 1})
        for (const int sy : {-1, 1}) {
            if (sx * offset.x < 0 || sy * offset.y < 0)
                continue;
            const float h00 = field.texel(x, y), h10 = field.texel(x + sx, y), h01 = field.texel(x, y + sy),
                        h11 = field.texel(x + sx, y + sy);
            if (h00 > h10 || h00 > h01 || h10 > h11 || h01 > h11)
                return texelLimit(field, x, y, offset, apex);
        }
    return kCap;
}

std::vector<HeightField> smallFields(Wrap wrap)
{
    std::vector<HeightField> fields;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    for (const auto [width, height] : {std::array{1, 1}, {1, 7}, {9, 1}, {2, 2}, {3, 5}, {8, 8}, {13, 6}, {11, 14}}) {
        fields.push_back(fieldOf(
            width, height, [&](int, int) { return unit(random); }, wrap));
        fields.push_back(fieldOf(
            width, height, [&](int, int) { return 0.4f + 0.2f * unit(random); }, wrap));
        fields.push_back(fieldOf(
            width, height, [&](int, int) { return unit(random) < 0.1f ? 1.f : 0.f; }, wrap));
    }
    for (const HardField& hard : kHardFields)
        fields.push_back(hardField(hard, 10, 9, wrap));
    return fields;
}

Image bakedBy(const char* key, const HeightField& field)
{
    return bakeMap(*findBakedMap(key), field, Parameters())->levels.front();
}

// `image`'s channel must lie within [true x (1 - 0.1), true] everywhere.
void expectSafeAndTight(
    const char* what, const HeightField& field, const Image& image, int channel, const std::function<double(int, int)>& truth)
{
    for (int y = 0; y < field.height(); ++y)
        for (int x = 0; x < field.width(); ++x) {
            const double baked = double(image.value(x, y, channel)), real = truth(x, y);
            ASSERT_LE(baked, real) << what << ' ' << field.width() << 'x' << field.height() << " at " << x << ',' << y;
            ASSERT_GE(baked, real * 0.9) << what << ' ' << field.width() << 'x' << field.height() << " at " << x << ',' << y;
        }
}

class ConeMaps : public testing::TestWithParam<Wrap> { };

TEST_P(ConeMaps, ConeHoldsNoTexel)
{
    for (const HeightField& field : smallFields(GetParam())) {
        const Image image = bakedBy("cone", field);
        ASSERT_EQ(image.channels, 2);
        for (int y = 0; y < field.height(); ++y)
            for (int x = 0; x < field.width(); ++x)
                ASSERT_EQ(image.value(x, y, 0), field.texel(x, y));
        expectSafeAndTight("cone", field, image, 1, [&](int x, int y) { return bruteRatio(field, x, y, texelLimit); });
    }
}

TEST_P(ConeMaps, ConeInFewBitsHoldsNoTexelEither)
{
    for (const HeightField& field : smallFields(GetParam())) {
        const BakedMapRow& row = *findBakedMap("cone");
        const BakedMap map = storedMap(row, *bakeMap(row, field, Parameters()), 8);
        for (int y = 0; y < field.height(); ++y)
            for (int x = 0; x < field.width(); ++x) {
                const float root = map.levels[0].value(x, y, 1);
                const double apex = double(map.scale[0] * map.levels[0].value(x, y, 0)), ratio = double(root * root * map.scale[1]);
                const double limit = bruteRatio(field, x, y,
                    [&](const HeightField& f, int i, int j, Offset offset, double) { return texelLimit(f, i, j, offset, apex); });
                ASSERT_LE(ratio, limit) << field.width() << 'x' << field.height() << " at " << x << ',' << y;
            }
    }
}

TEST_P(ConeMaps, QuadConeHoldsNoTexelOfItsSector)
{
    constexpr std::array<std::array<int, 2>, 4> kAxes = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    for (const HeightField& field : smallFields(GetParam())) {
        const Image image = bakedBy("cone-quad", field);
        ASSERT_EQ(image.channels, 4);
        for (std::size_t c = 0; c < 4; ++c)
            expectSafeAndTight("cone-quad", field, image, int(c), [&](int x, int y) {
                return bruteRatio(field, x, y, [&](const HeightField& f, int i, int j, Offset offset, double apex) {
                    const std::int64_t u = std::int64_t(offset.x) * f.height(), v = std::int64_t(offset.y) * f.width();
                    const std::int64_t along = u * kAxes[c][0] + v * kAxes[c][1], across = std::abs(kAxes[c][0] ? v : u);
                    return along >= across ? texelLimit(f, i, j, offset, apex) : kCap;
                });
            });
    }
}

TEST_P(ConeMaps, RobustConeIsTheSmallestOfNineLimitedByFallingEdges)
{
    for (const HeightField& field : smallFields(GetParam())) {
        std::vector<double> single;
        for (int y = 0; y < field.height(); ++y)
            for (int x = 0; x < field.width(); ++x)
                single.push_back(bruteRatio(field, x, y, robustLimit));
        expectSafeAndTight("cone-robust", field, bakedBy("cone-robust", field), 1, [&](int x, int y) {
            double best = kCap;
            for (int j = y - 1; j <= y + 1; ++j)
                for (int i = x - 1; i <= x + 1; ++i)
                    best = std::min(best,
                        single[std::size_t(
                            wrapIndex(j, field.height(), field.wrap()) * field.width() + wrapIndex(i, field.width(), field.wrap()))]);
            return best;
        });
    }
}

TEST_P(ConeMaps, RelaxedConeIsLimitedByTheNearestExitOfAnyCell)
{
    for (const HeightField& field : smallFields(GetParam()))
        expectSafeAndTight("cone-relaxed", field, bakedBy("cone-relaxed", field), 1,
            [&](int x, int y) { return std::min(kCap, bruteRatio(field, x, y, relaxedLimit, 1) * 1.0011); });
}

INSTANTIATE_TEST_SUITE_P(Wraps, ConeMaps, testing::Values(Wrap::Repeat, Wrap::Clamp),
    [](const auto& wrap) { return wrap.param == Wrap::Repeat ? "Repeat" : "Clamp"; });

// The closed form against the definition: rays from above that leave the surface at a sampled point of the cell.
TEST(RelaxedCone, CellAgreesWithSampledExitPoints)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    int limited = 0, near = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const float base = trial % 3 == 0 ? 0.7f * unit(random) : 0.f, range = 1.f - base;
        const auto corner = [&] { return base + range * (trial % 5 == 0 ? std::round(unit(random)) : unit(random)); };
        const RelaxedCell cell{
            {corner(), corner(), corner(), corner()}, double(random() % 4), double(random() % 4), 1. / 8, 1. / (8 + trial % 7)};
        const double apex = cell.x == 0 && cell.y == 0 ? double(cell.corners.h00) : 0.8 * double(unit(random));
        double sampled = HUGE_VAL;
        constexpr int kSamples = 200;
        for (int j = 0; j <= kSamples; ++j)
            for (int i = 0; i <= kSamples; ++i) {
                const double s = double(i) / kSamples, t = double(j) / kSamples;
                const HeightField::Corners& c = cell.corners;
                const double h00 = double(c.h00), h10 = double(c.h10), h01 = double(c.h01), h11 = double(c.h11);
                const double height = (h00 * (1 - s) + h10 * s) * (1 - t) + (h01 * (1 - s) + h11 * s) * t;
                const double slopeX = (h10 - h00) * (1 - t) + (h11 - h01) * t, slopeY = (h01 - h00) * (1 - s) + (h11 - h10) * s;
                const double x = cell.x + s, y = cell.y + t;
                if (height > apex && height - slopeX * x - slopeY * y > 1. + 1e-9)
                    sampled = std::min(sampled, std::hypot(x * cell.du, y * cell.dv) / (height - apex));
            }
        const double ratio = relaxedRatio(cell, apex);
        ASSERT_LE(ratio, sampled * (1 + 1e-9)) << trial;
        if (sampled < kCap) {
            ASSERT_GE(ratio, sampled * 0.7) << trial; // samples lie 1 / 200 texel apart: a thin region of exits shows few of them
            near += ratio > sampled * 0.98;
            ++limited;
        }
    }
    EXPECT_GT(limited, 300);
    EXPECT_GT(near, limited * 9 / 10);
}
// Listing 18-2 on the CPU: rays from (source, top) through the surface, `targets` to a texel each way, `steps` down to the bottom; the
// chapter has 1 and 128. A ray ends early where its ratio has outgrown the smallest.
double listingRatio(const HeightField& field, int x, int y, int targets, int steps)
{
    const glm::dvec2 size(field.width(), field.height()), source = (glm::dvec2(x, y) + 0.5) / size;
    const double sourceDepth = 1. - double(field.texel(x, y));
    double best = 1.;
    for (int j = 0; j <= (field.height() - 1) * targets; ++j)
        for (int i = 0; i <= (field.width() - 1) * targets; ++i) {
            const glm::dvec2 target = (glm::dvec2(i, j) / double(targets) + 0.5) / size;
            const double depth = 1. - double(field.at(glm::vec2(target)));
            if (depth <= 0. || (i == x * targets && j == y * targets))
                continue;
            for (int k = 1; k < steps; ++k) {
                const double z = depth + (1. - depth) * k / steps;
                const glm::dvec2 at = source + (target - source) * (z / depth);
                const double ratio = z < sourceDepth ? glm::length(at - source) / (sourceDepth - z) : best;
                if (ratio >= best)
                    break;
                if (1. - double(field.at(glm::vec2(at))) > z)
                    best = ratio;
            }
        }
    return best;
}

// Our ratio as a share of the listing's, at texels all over the field, sorted.
std::vector<double> sharesOfListing(const HeightField& field, int targets, int steps)
{
    const Image image = bakedBy("cone-relaxed", field);
    std::vector<double> shares;
    for (int n = 0; n < field.width() * field.height(); n += 61) {
        const int x = n % field.width(), y = n / field.width();
        shares.push_back(std::min(1., double(image.value(x, y, 1))) / listingRatio(field, x, y, targets, steps));
    }
    std::ranges::sort(shares);
    return shares;
}

// The listing sees only some rays and finds each exit up to a step late, so its cones are wider; the finer it samples the less.
TEST(RelaxedCone, IsWhatTheListingSamples)
{
    for (const char* name : {"one wave", "waves", "domes", "low domes", "bowl", "rough hills"}) {
        const auto hard = std::ranges::find_if(kHardFields, [&](const HardField& f) { return std::string_view(f.name) == name; });
        const HeightField field = hardField(*hard, 64, 64, Wrap::Clamp);
        const auto coarse = sharesOfListing(field, 1, 128), fine = sharesOfListing(field, 4, 2048);
        EXPECT_LE(coarse.back(), 1.001) << name;
        EXPECT_LE(fine.back(), 1.001) << name;
        EXPECT_GE(fine[fine.size() / 2], coarse[coarse.size() / 2] - 1e-9) << name;
        EXPECT_GT(fine[fine.size() / 2], 0.9) << name;
    }
}

TEST(ConeMapsAtLarge, CancelledIsAnError)
{
    const HeightField field = hardField(kHardFields[1], 1024, 1024); // one wave, seconds of work
    std::stop_source stop;
    Progress progress{[&](float share) { share > 0.f ? stop.request_stop() : false; }, stop.get_token()};
    const auto map = bakeMap(*findBakedMap("cone-relaxed"), field, Parameters(), progress);
    ASSERT_FALSE(map);
    EXPECT_TRUE(isCancelled(map.error()));
}

// Whenever the wish to stop comes there is no half-made map: before the work, at its first and at its last report, or in what follows.
TEST(ConeMapsAtLarge, CancelledAtAnyTimeIsAnErrorForEveryMap)
{
    const HeightField field = hardField(kHardFields[1], 48, 48);
    for (const BakedMapRow& row : kBakedMaps) {
        if (!row.bake)
            continue;
        std::stop_source before;
        before.request_stop();
        const auto none = bakeMap(row, field, Parameters(), {{}, before.get_token()});
        ASSERT_FALSE(none) << row.key;
        EXPECT_TRUE(isCancelled(none.error())) << row.key;
        for (const float when : {0.f, 1.f}) {
            std::stop_source stop;
            const auto map
                = bakeMap(row, field, Parameters(), {[&](float share) { share >= when ? stop.request_stop() : false; }, stop.get_token()});
            EXPECT_EQ(map.has_value(), !stop.stop_requested()) << row.key;
        }
    }
}

// The last steps report nothing: there the wish comes from another thread, sooner or later.
TEST(ConeMapsAtLarge, CancelledInTheLastStepLeavesNoHalfMap)
{
    const HeightField field = fieldOf(256, 256, [](int x, int y) { return x == 3 && y == 5 ? 1.f : 0.f; });
    for (const char* key : {"cone-robust", "distance"}) {
        const BakedMapRow& row = *findBakedMap(key);
        const BakedMap whole = *bakeMap(row, field, Parameters());
        for (int delay = 0; delay < 12; ++delay) { // 0.2 ms
            std::stop_source stop;
            std::atomic<bool> begun = key == std::string_view("distance"); // its columns come first
            std::jthread other([&] {
                while (!begun)
                    std::this_thread::yield();
                std::this_thread::sleep_for(std::chrono::microseconds(200 * delay));
                stop.request_stop();
            });
            const auto map = bakeMap(row, field, Parameters(), {[&](float share) { begun = begun || share >= 1.f; }, stop.get_token()});
            begun = true;
            if (map)
                EXPECT_TRUE(map->levels[0].data == whole.levels[0].data) << key << ' ' << delay;
            else
                EXPECT_TRUE(isCancelled(map.error()));
        }
    }
}

} // namespace
