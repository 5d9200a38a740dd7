// Storing maps in 8, 16 and 32 bits: what the GPU decodes stays on the safe side of the value, as near as the bits allow.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/float_image.h"
#include "core/maps/maps.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

using namespace relievo;

namespace {

constexpr std::array<ChannelRule, 6> kRules
    = {{{Rounding::Nearest, Encoding::Linear}, {Rounding::Down, Encoding::Linear}, {Rounding::Up, Encoding::Linear},
        {Rounding::Nearest, Encoding::SquareRoot}, {Rounding::Down, Encoding::SquareRoot}, {Rounding::Up, Encoding::SquareRoot}}};

float decode(float stored, const ChannelRule& rule, float scale)
{
    return (rule.encoding == Encoding::SquareRoot ? stored * stored : stored) * scale;
}

BakedMap mapOf(const std::vector<float>& values)
{
    BakedMap map{{floatImage(int(values.size()), 1, 1)}};
    std::ranges::copy(values, floats(map.levels[0]).begin());
    return map;
}

BakedMap stored(const BakedMap& map, const ChannelRule& rule, int bits)
{
    BakedMapRow row = *findBakedMap("pyramid");
    row.rules[0] = rule;
    return storedMap(row, map, bits);
}

// Every value against the neighbouring codes.
void expectSafe(const std::vector<float>& values, const ChannelRule& rule, int bits)
{
    const BakedMap map = stored(mapOf(values), rule, bits);
    const float most = bits == 8 ? 255.f : 65535.f, scale = map.scale[0];
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float code = std::round(map.levels[0].value(int(i), 0, 0) * most), value = values[i];
        const float here = decode(code / most, rule, scale), below = decode((code - 1.f) / most, rule, scale),
                    above = decode((code + 1.f) / most, rule, scale);
        if (rule.rounding == Rounding::Down) {
            ASSERT_LE(here, value) << bits;
            ASSERT_TRUE(code == most || above > value) << bits << ' ' << value;
        } else if (rule.rounding == Rounding::Up) {
            ASSERT_GE(here, value) << bits;
            ASSERT_TRUE(code == 0.f || below < value) << bits << ' ' << value;
        } else {
            ASSERT_LE(std::abs(here - value), (above - here) * (rule.encoding == Encoding::Linear ? 0.5001f : 1.f)) << bits << ' ' << value;
        }
    }
}
} // namespace

TEST(StoredMap, EveryCodeOfSixteenAndEightBitsComesBack)
{
    for (const ChannelRule& rule : kRules)
        for (const int bits : {8, 16})
            for (const float scale : {1.f, 0.37f, 63.9f, 3e-9f}) {
                const int most = bits == 8 ? 255 : 65535;
                std::vector<float> values;
                for (int code = 0; code <= most; ++code)
                    values.push_back(
                        decode(float(code) / float(most), rule, rule.encoding == Encoding::Linear && scale < 1.f ? 1.f : scale));
                const BakedMap map = stored(mapOf(values), rule, bits);
                for (int code = 0; code <= most; ++code)
                    ASSERT_EQ(decode(map.levels[0].value(code, 0, 0), rule, map.scale[0]), values[std::size_t(code)]) << code;
                expectSafe(values, rule, bits);
            }
}

TEST(StoredMap, RandomValuesStayOnTheSafeSide)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    for (const ChannelRule& rule : kRules)
        for (const float range : {1.f, 0.01f, 64.f, 1e-12f}) {
            std::vector<float> values{0.f, range};
            for (int i = 0; i < 20000; ++i)
                values.push_back(range * (i % 2 ? unit(random) : unit(random) * unit(random) * unit(random)));
            expectSafe(values, rule, 8);
            expectSafe(values, rule, 16);
        }
}

TEST(StoredMap, FloatsKeepTheirValueAndRootsTheirSide)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<float> unit(0.f, 80.f);
    std::vector<float> values;
    for (int i = 0; i < 20000; ++i)
        values.push_back(unit(random));
    for (const ChannelRule& rule : kRules) {
        const BakedMap map = stored(mapOf(values), rule, 32);
        EXPECT_EQ(map.scale[0], 1.f);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const float back = decode(map.levels[0].value(int(i), 0, 0), rule, 1.f);
            if (rule.encoding == Encoding::Linear)
                ASSERT_EQ(back, values[i]);
            else
                ASSERT_NEAR(back, values[i], values[i] * 3e-7f);
            ASSERT_TRUE(rule.rounding != Rounding::Down || back <= values[i]);
            ASSERT_TRUE(rule.rounding != Rounding::Up || back >= values[i]);
        }
    }
}

// The apex of a cone never sinks below its texel; heights of 8 and 16 bits stay what they are, or searches would drift from the surface.
TEST(StoredMap, ApexesOfConesStayOnTheirTexels)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    std::vector<float> codes, heights;
    for (int code = 0; code < 65536; ++code)
        codes.push_back(float(code) / 65535.f);
    for (int code = 0; code < 256; ++code)
        codes.push_back(float(code) / 255.f);
    for (int i = 0; i < 20000; ++i)
        heights.push_back(unit(random));
    const auto storedIn = [](const BakedMapRow& row, const std::vector<float>& apexes, int bits) {
        BakedMap map{{floatImage(int(apexes.size()), 1, 2)}};
        for (std::size_t i = 0; i < apexes.size(); ++i)
            floats(map.levels[0])[2 * i] = apexes[i];
        return storedMap(row, map, bits);
    };
    for (const char* key : {"cone", "cone-relaxed", "cone-robust"}) {
        const BakedMap exact = storedIn(*findBakedMap(key), codes, 16);
        ASSERT_EQ(exact.scale[0], 1.f);
        for (std::size_t i = 0; i < codes.size(); ++i)
            ASSERT_EQ(exact.levels[0].value(int(i), 0, 0), codes[i]) << key;
        for (const int bits : {8, 16}) {
            const BakedMap above = storedIn(*findBakedMap(key), heights, bits);
            for (std::size_t i = 0; i < heights.size(); ++i)
                ASSERT_GE(above.levels[0].value(int(i), 0, 0), heights[i]) << key << ' ' << bits;
        }
    }
}

TEST(StoredMap, CancelledItStops)
{
    const BakedMap map = mapOf({1.f, 0.5f});
    std::stop_source stop;
    const Progress progress{{}, stop.get_token()};
    EXPECT_EQ(storedMap(*findBakedMap("pyramid"), map, 16, progress).levels[0].value(0, 0, 0), 1.f);
    stop.request_stop();
    EXPECT_EQ(storedMap(*findBakedMap("pyramid"), map, 16, progress).levels[0].value(0, 0, 0), 0.f) << "nothing was written any more";
}

TEST(StoredMap, AConstantZeroAndNanStayFinite)
{
    for (const ChannelRule& rule : kRules)
        for (const int bits : {8, 16}) {
            const BakedMap map = stored(mapOf({0.f, 0.f, std::nanf("")}), rule, bits);
            EXPECT_GT(map.scale[0], 0.f);
            EXPECT_EQ(map.levels[0].value(0, 0, 0), 0.f);
            EXPECT_EQ(map.levels[0].value(2, 0, 0), 0.f);
        }
}
