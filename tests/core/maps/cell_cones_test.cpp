// Cell cones by brute force: what a texel says holds for every point of its nodes and of the field.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/acceleration/acceleration_map.h"
#include "core/maps/acceleration/cell_cones.h"
#include "core/maps/maps.h"
#include "core/trace/reference.h"
#include "core/trace/shader_on_cpu.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

using namespace relievo;

namespace {

HeightField randomField(std::mt19937& random, int width, int height, Wrap wrap)
{
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    const int kind = int(random() % 4);
    std::vector<float> heights;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            heights.push_back(kind == 0 ? unit(random)
                    : kind == 1         ? float((x + y) % 2)
                    : kind == 2         ? (unit(random) < 0.05f ? unit(random) : 0.1f)
                                        : 0.5f + 0.4f * std::sin(float(x) * 0.7f) * std::cos(float(y) * 0.9f));
    return {width, height, std::move(heights), wrap, 32};
}

struct Node {
    float cap, steep;
};
Node nodeOf(const BakedMap& map, int cellX, int cellY, int n)
{
    const int x = cellX / 2, y = cellY / 2;
    const Image& image = map.levels.front();
    std::uint16_t code;
    std::memcpy(&code, image.data.data() + (std::size_t(y * image.width + x) * 4 + std::size_t(n)) * 2, 2);
    const float c = float(code >> 8), k = float(code & 255);
    return {map.scale.x + c * (map.scale.y / 255.f), k * k * (map.scale.z / 65025.f)};
}

} // namespace

TEST(CellCones, NothingRisesAboveCapOrCone)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    const int sizes[][2] = {{1, 1}, {1, 9}, {7, 1}, {5, 3}, {16, 16}, {13, 21}, {70, 9}};
    for (const auto& [width, height] : sizes)
        for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp})
            for (int repeat = 0; repeat < 4; ++repeat) {
                const HeightField field = randomField(random, width, height, wrap);
                const BakedMap map = bakeCellCones(field, {}, {});
                const glm::vec2 size{float(width), float(height)};
                for (int i = 0; i < 4000; ++i) {
                    const int x = int(random() % unsigned(width)), y = int(random() % unsigned(height)), n = int(random() % 4);
                    const int span = kCellConeSpans[n];
                    const glm::vec2 low{float(x / span * span), float(y / span * span)}, high = glm::min(low + float(span), size);
                    // Also the corners and edges of the node, where a cone is tightest.
                    const auto inNode = [&](float a, float b) { return a + (b - a) * std::clamp(1.4f * unit(random) - 0.2f, 0.f, 1.f); };
                    glm::vec2 place{inNode(low.x, high.x), inNode(low.y, high.y)};
                    if (wrap == Wrap::Clamp) // nodes at a border go on beyond it
                        for (int axis = 0; axis < 2; ++axis)
                            place[axis] += low[axis] == 0.f && i % 3 == 0 ? -3.f * unit(random)
                                : high[axis] == size[axis] && i % 3 == 1  ? 3.f * unit(random)
                                                                          : 0.f;
                    const glm::vec2 p = (place + 0.5f) / size;
                    const Node node = nodeOf(map, x, y, n);
                    EXPECT_LE(field.at(p), node.cap + 2e-6f);
                    const glm::vec2 q = p + (i % 2 ? 2.f : 0.2f) * (glm::vec2(unit(random), unit(random)) - 0.5f);
                    EXPECT_LE(field.at(q), node.cap + node.steep * glm::distance(p, q) + 4e-6f) << width << 'x' << height << ' ' << n;
                }
            }
}

TEST(CellCones, WithinAnEighthOfTheSteepestRise)
{
    // A single peak on level ground: from a cell at a distance the rise is known.
    std::vector<float> heights(32 * 32, 0.f);
    heights[16 * 32 + 16] = 1.f;
    const HeightField field(32, 32, heights, Wrap::Repeat, 32);
    const BakedMap map = bakeCellCones(field, {}, {});
    const float distance = 4.f / 32.f; // from the right wall of cells 10 and 11 to the peak
    const Node node = nodeOf(map, 10, 16, 0);
    EXPECT_FLOAT_EQ(node.cap, 0.f);
    EXPECT_GE(node.steep, 1.f / distance * 0.999f);
    EXPECT_LE(node.steep, 1.f / distance * 1.25f); // the bound of a cell, the search's share, and the code's step
}

// A wall is passed by a hundred-thousandth of a texel, which a nearly vertical ray takes a long way down for.
TEST(CellCones, NearlyVerticalRaysAreNotLate)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0., 1.);
    for (int repeat = 0; repeat < 40; ++repeat) {
        const HeightField field = randomField(random, 16, 16, Wrap::Repeat);
        std::vector<SearchRay> rays;
        for (int i = 0; i < 100; ++i) {
            const double travel = std::pow(10., -4. * unit(random)); // texels over the full depth
            const glm::dvec2 wall{double(random() % 16), 0.2 + 0.6 * unit(random)}, way{travel, travel * unit(random)};
            rays.push_back({(wall + 0.5 - glm::dvec2(travel * unit(random), 0.)) / 16., way / 16., 1.});
        }
        for (const char* key : {"cell-cone", "pyramid"}) {
            const auto hits = traceRays(key, {}, &field, rays);
            ASSERT_TRUE(hits);
            for (std::size_t i = 0; i < rays.size(); ++i)
                EXPECT_NEAR((*hits)[i].t, exactHit(field, rays[i]).t, 3e-5) << key << ' ' << 16. * rays[i].duv.x << " texels";
        }
    }
}

TEST(CellCones, LevelFieldsAreCrossedAtOnce)
{
    const HeightField field(64, 64, std::vector<float>(64 * 64, 0.5f), Wrap::Repeat, 16);
    const SearchRay rays[] = {{{0.3, 0.1}, {40., 25.}, 0.01}};
    const auto hits = traceRays("cell-cone", {}, &field, rays);
    ASSERT_TRUE(hits);
    EXPECT_NEAR(hits->front().t, 0.5, 1e-5);
    EXPECT_LE(hits->front().fetches, 3);
}

TEST(CellCones, SlowAxesDoNotStandStill)
{
    // A ray that crosses a wall of its slow axis by less than a float tells apart must go on all the same.
    std::mt19937 random(8);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    const HeightField field = randomField(random, 64, 64, Wrap::Repeat);
    std::vector<SearchRay> rays;
    for (int i = 0; i < 20000; ++i)
        rays.push_back({{unit(random), unit(random)}, {20.f * unit(random), -0.02f * unit(random)}, 0.01});
    for (const char* key : {"cell-cone", "pyramid"}) {
        const auto hits = *traceRays(key, {}, &field, rays);
        for (std::size_t i = 0; i < rays.size(); ++i)
            ASSERT_LT(hits[i].fetches, 8000) << key << ' ' << i;
    }
}

TEST(CellCones, LevelsOfAnySizeMakeOneTexture)
{
    std::mt19937 random(9);
    const int sizes[][2] = {{13, 21}, {1, 9}, {64, 3}, {6, 7}, {2, 2}, {1, 1}};
    for (const auto& [width, height] : sizes) {
        const HeightField field = randomField(random, width, height, Wrap::Repeat);
        const auto texture = makeAccelerationMap("cell-cone", field, {}, true);
        ASSERT_TRUE(texture);
        const std::vector<HeightField> fields = heightLevels(field);
        EXPECT_EQ(int(fields.size()), levelCount(field));
        ASSERT_EQ((*texture)->levels.size(), fields.size());
        const Image& finest = (*texture)->levels.front();
        for (std::size_t l = 0; l < fields.size(); ++l) {
            const Image& level = (*texture)->levels[l];
            EXPECT_EQ(level.width, std::max(finest.width >> l, 1)) << width << 'x' << height << ' ' << l;
            EXPECT_EQ(level.height, std::max(finest.height >> l, 1)) << width << 'x' << height << ' ' << l;
            const BakedMap map = bakeCellCones(fields[l], {}, {});
            const Image& baked = map.levels.front();
            for (int y = 0; y < baked.height; ++y)
                EXPECT_EQ(std::memcmp(level.data.data() + std::size_t(y) * std::size_t(level.width) * 8,
                              baked.data.data() + std::size_t(y) * std::size_t(baked.width) * 8, std::size_t(baked.width) * 8),
                    0);
        }
    }
}
