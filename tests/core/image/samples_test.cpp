// The built-in samples tile without a seam at any size, use the whole range of heights and are smooth from texel to texel.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/samples/samples.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace relievo;

class Samples : public testing::TestWithParam<SampleRow> { };

TEST_P(Samples, AnySizeEvenOneTexel)
{
    for (const int size : {1, 2, 7, 100, 129}) {
        const Sample sample = GetParam().make(size);
        for (const Image* image : {&sample.height, &sample.color, &sample.roughness}) {
            EXPECT_EQ(image->width, size);
            EXPECT_EQ(image->height, size);
            EXPECT_EQ(image->data.size(), image->texelCount() * std::size_t(image->channels) * bytesOf(image->type));
        }
        EXPECT_EQ(sample.height.type, PixelType::U16);
        EXPECT_EQ(sample.color.channels, 3);
    }
}

TEST_P(Samples, UsesTheWholeRangeAtSixteenBits)
{
    const Sample sample = GetParam().make(256);
    float low = 1.f, high = 0.f;
    std::vector<float> values;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            values.push_back(sample.height.value(x, y, 0));
    for (const float h : values) {
        low = std::min(low, h);
        high = std::max(high, h);
    }
    EXPECT_LT(low, 0.01f);
    EXPECT_GT(high, 0.99f);
    std::ranges::sort(values);
    const auto distinct = std::unique(values.begin(), values.end()) - values.begin();
    EXPECT_GT(distinct, 5000); // 8 bits would give 256
}

// The step over the border is no larger than the steps inside.
TEST_P(Samples, TilesWithoutASeam)
{
    constexpr int kSize = 300;
    const Sample sample = GetParam().make(kSize);
    for (const Image* image : {&sample.height, &sample.color, &sample.roughness}) {
        double inside = 0, across = 0;
        for (int i = 0; i < kSize; ++i) {
            across += double(std::abs(image->value(0, i, 0) - image->value(kSize - 1, i, 0)));
            across += double(std::abs(image->value(i, 0, 0) - image->value(i, kSize - 1, 0)));
            for (int k = 1; k < kSize; k += 13) {
                inside += double(std::abs(image->value(k, i, 0) - image->value(k - 1, i, 0)));
                inside += double(std::abs(image->value(i, k, 0) - image->value(i, k - 1, 0)));
            }
        }
        inside /= std::ceil((kSize - 1) / 13.0);
        EXPECT_LT(across, 3.0 * inside + 1.0) << image->channels;
    }
}

TEST_P(Samples, IsTheSameEveryTimeAndAtEverySize)
{
    const Sample a = GetParam().make(64), b = GetParam().make(64), fine = GetParam().make(192);
    EXPECT_EQ(a.height.data, b.height.data);
    EXPECT_EQ(a.color.data, b.color.data);
    double difference = 0; // texel centres of 64 are those of every third of 192
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            difference += double(std::abs(a.height.value(x, y, 0) - fine.height.value(3 * x + 1, 3 * y + 1, 0)));
    EXPECT_LT(difference / (64 * 64), 0.06);
}

TEST_P(Samples, SlotsNameItsMaps)
{
    const std::string key(GetParam().key);
    EXPECT_EQ(findSample(key)->key, GetParam().key);
    const MapSlots slots = sampleSlots(key), small = sampleSlots(key, 256);
    EXPECT_EQ(slots[std::size_t(MapKind::Height)].file, "sample:" + key);
    EXPECT_EQ(small[std::size_t(MapKind::Color)].file, "sample:" + key + "@256");
    EXPECT_TRUE(slots[std::size_t(MapKind::Normal)].empty());
    EXPECT_EQ(slots[std::size_t(MapKind::Metallic)].empty(), GetParam().make(4).metallic.data.empty());
    EXPECT_GT(GetParam().depth, 0.f);
}

INSTANTIATE_TEST_SUITE_P(All, Samples, testing::ValuesIn(kSamples), [](const auto& row) { return std::string(row.param.key); });

TEST(SamplesTable, UnknownKeyFindsNothing)
{
    EXPECT_EQ(findSample("gold"), nullptr);
    EXPECT_TRUE(sampleSlots("gold")[0].empty());
}
