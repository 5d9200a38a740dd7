// The maximum pyramid, texel by texel, against the highest corner of the cells below.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/maps.h"
#include "tests/core/maps/maps_support.h"
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;

namespace {
float highest(const HeightField& field, int level, int i, int j)
{
    float best = 0.f;
    for (int y = j << level; y < std::min((j + 1) << level, field.height()); ++y)
        for (int x = i << level; x < std::min((i + 1) << level, field.width()); ++x)
            for (const int dy : {0, 1})
                for (const int dx : {0, 1})
                    best = std::max(best, field.texel(x + dx, y + dy));
    return best;
}
} // namespace

TEST(Pyramid, HoldsTheHighestCornerOfItsCells)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    for (int width = 1; width <= 20; ++width)
        for (int height = 1; height <= 20; height += 1 + width % 3) {
            const HeightField field = fieldOf(
                width, height, [&](int, int) { return unit(random); }, (width + height) % 2 ? Wrap::Repeat : Wrap::Clamp);
            const BakedMap map = *bakeMap(*findBakedMap("pyramid"), field, Parameters());
            int w = width, h = height;
            for (std::size_t l = 0; l < map.levels.size(); ++l) {
                const Image& level = map.levels[l];
                ASSERT_EQ(level.width, w);
                ASSERT_EQ(level.height, h);
                for (int j = 0; j < h; ++j)
                    for (int i = 0; i < w; ++i)
                        ASSERT_EQ(level.value(i, j, 0), highest(field, int(l), i, j)) << width << 'x' << height;
                w = (w + 1) / 2;
                h = (h + 1) / 2;
            }
            EXPECT_EQ(map.levels.back().texelCount(), 1u);
        }
}

TEST(Pyramid, SixteenBitHeightsAreStoredAsTheyAre)
{
    const HeightField field = fieldOf(64, 64, [](int x, int y) { return float((x * 997 + y * 64 * 31) % 65536) / 65535.f; });
    const BakedMapRow& row = *findBakedMap("pyramid");
    const BakedMap map = *bakeMap(row, field, Parameters()), stored = storedMap(row, map, 16);
    for (std::size_t l = 0; l < map.levels.size(); ++l)
        for (int i = 0; i < map.levels[l].width; ++i)
            EXPECT_EQ(stored.levels[l].value(i, 0, 0), map.levels[l].value(i, 0, 0));
}
