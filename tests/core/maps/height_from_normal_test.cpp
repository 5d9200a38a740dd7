// Heights from normals: smooth fields come back, with the depth they had.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/maps.h"
#include "core/maps/surface/normal.h"
#include "tests/core/image/image_support.h"
#include "tests/core/maps/maps_support.h"
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;

namespace {
// Smooth, and level across the borders when clamped.
HeightField smooth(int width, int height, Wrap wrap)
{
    return fieldOf(
        width, height,
        [&](int x, int y) {
            const float u = (float(x) + 0.5f) / float(width) * 6.2831853f, v = (float(y) + 0.5f) / float(height) * 6.2831853f;
            return wrap == Wrap::Repeat ? 0.5f + 0.2f * std::sin(2 * u + v) + 0.3f * std::sin(v - 1.f)
                                        : 0.5f + 0.3f * std::cos(0.5f * u) + 0.2f * std::cos(1.5f * v);
        },
        wrap);
}
} // namespace

TEST(HeightFromNormal, SmoothFieldsComeBack)
{
    constexpr float kDepth = 0.07f;
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp})
        for (const auto [width, height] : {std::array{128, 128}, {97, 60}, {64, 200}}) {
            const HeightField field = smooth(width, height, wrap);
            const auto [low, high] = std::ranges::minmax(field.texels());
            float depth = 0.f;
            const HeightField back = heightFromNormals(normalFromHeight(field, kDepth), wrap, depth);
            EXPECT_NEAR(depth, kDepth * (high - low), kDepth * 0.002f);
            for (std::size_t i = 0; i < field.texels().size(); ++i)
                ASSERT_NEAR(back.texels()[i], (field.texels()[i] - low) / (high - low), 0.002f) << width << 'x' << height << ' ' << i;
        }
}

TEST(HeightFromNormal, FlatOrSpoiltNormalsGiveALevelTop)
{
    const Image flat = makeImage(9, 5, 3, PixelType::F32, [](int x, int, int c) { return x == 3 ? NAN : c == 2 ? 1.f : 0.5f; });
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp}) {
        float depth = -1.f;
        const HeightField back = heightFromNormals(flat, wrap, depth);
        EXPECT_EQ(depth, 0.f);
        for (const float h : back.texels())
            EXPECT_EQ(h, 1.f);
    }
}

// No code of 8 or 16 bits is exactly 0: taken at its word, either middle one would be a ramp.
TEST(HeightFromNormal, FlatNormalsInWholeNumbersGiveALevelTop)
{
    for (const auto& [type, most] : {std::pair{PixelType::U8, 255.f}, {PixelType::U16, 65535.f}})
        for (const float below : {0.f, 1.f}) {
            const float middle = (std::ceil(most / 2.f) - below) / most;
            const Image flat = makeImage(40, 24, 3, type, [&](int, int, int c) { return c == 2 ? 1.f : middle; });
            for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp}) {
                float depth = -1.f;
                const HeightField back = heightFromNormals(flat, wrap, depth);
                EXPECT_EQ(depth, 0.f);
                for (const float h : back.texels())
                    ASSERT_EQ(h, 1.f);
            }
        }
}

// The codes after those are slopes: a ramp of 3 / 255 stays one.
TEST(HeightFromNormal, TheLeastSlopeOfWholeNumbersIsKept)
{
    const Image tilted = makeImage(40, 24, 3, PixelType::U8, [](int, int, int c) { return c == 0 ? 126.f / 255.f : c == 1 ? 0.5f : 1.f; });
    float depth = 0.f;
    const HeightField back = heightFromNormals(tilted, Wrap::Clamp, depth);
    EXPECT_GT(depth, 0.008f);
    EXPECT_LT(back.texel(0, 12), back.texel(39, 12));
}

TEST(HeightFromNormal, AnyImageGivesHeights)
{
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp})
        for (const auto [width, height] : {std::array{1, 1}, {1, 9}, {7, 1}, {2, 2}, {33, 31}}) {
            float depth = 0.f;
            const HeightField back = heightFromNormals(noiseImage(width, height, 3, PixelType::U8), wrap, depth);
            EXPECT_TRUE(std::isfinite(depth));
            EXPECT_EQ(back.width(), width);
            for (const float h : back.texels())
                EXPECT_TRUE(h >= 0.f && h <= 1.f);
        }
}

TEST(HeightFromNormal, EachRowIsMadeFromItsOwnMap)
{
    float depth = 0.f;
    EXPECT_FALSE(bakeMap(*findBakedMap("height-from-normal"), smooth(8, 8, Wrap::Repeat), Parameters()));
    EXPECT_FALSE(bakeMapFromNormals(*findBakedMap("cone"), noiseImage(4, 4, 3, PixelType::U8), Wrap::Repeat, depth));
    EXPECT_TRUE(bakeMapFromNormals(*findBakedMap("height-from-normal"), noiseImage(4, 4, 3, PixelType::U8), Wrap::Repeat, depth));
}
