// The same search text on the GPU and on the CPU.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/techniques.h"
#include "tests/core/image/source_support.h"
#include "tests/render/agreement.h"
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

using namespace relievo;

namespace {

void expectAgreement(const HeightField& field, const std::string& name)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context) << message(context.error());
    const auto rays = test::raysOf(10000, 21);
    for (const TechniqueRow& row : kTechniques) {
        if (row.file.empty())
            continue;
        const auto cpu = traceRays(row.key, Parameters(), &field, rays);
        ASSERT_TRUE(cpu) << row.key;
        for (const Dialect dialect : {Dialect::Desktop, Dialect::Es}) {
            const auto found = test::agreement(*cpu, row.key, field, rays, dialect);
            ASSERT_TRUE(found) << row.key << ' ' << int(dialect) << ' ' << message(found.error());
            EXPECT_LE(found->apart, 10) << name << ' ' << row.key << ' ' << int(dialect); // 99.9 % agree
            EXPECT_LE(found->otherFetches, 100) << name << ' ' << row.key << ' ' << int(dialect);
        }
    }
}

// The middle of the field, at most 128 x 128 texels, so that its maps are soon baked.
HeightField middleOf(const HeightField& field)
{
    const int width = std::min(field.width(), 128), height = std::min(field.height(), 128);
    std::vector<float> heights;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            heights.push_back(field.texel((field.width() - width) / 2 + x, (field.height() - height) / 2 + y));
    return {width, height, std::move(heights), field.wrap(), field.storedBits()};
}

} // namespace

TEST(TraceGl, AgreesWithTheCpu)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    std::vector<float> noise(61 * 37), smooth(64 * 64), stored16(64 * 64);
    for (float& h : noise)
        h = unit(random);
    for (std::size_t i = 0; i < smooth.size(); ++i) {
        smooth[i] = 0.5f + 0.5f * std::sin(float(i % 64) * 0.2f) * std::cos(float(i / 64) * 0.3f);
        stored16[i] = std::round(smooth[i] * 65535.f) / 65535.f;
    }
    expectAgreement(HeightField(61, 37, noise, Wrap::Repeat, 32), "noise");
    expectAgreement(HeightField(61, 37, noise, Wrap::Clamp, 32), "noise clamped");
    expectAgreement(HeightField(64, 64, smooth, Wrap::Repeat, 32), "smooth");
    expectAgreement(HeightField(64, 64, stored16, Wrap::Repeat, 16), "16 bit");
    expectAgreement(HeightField(1, 37, std::vector<float>(37, 127.f / 255.f), Wrap::Repeat, 8), "1 x N");
}

TEST(TraceGl, AgreesWithTheCpuOnRealSets)
{
    const std::filesystem::path materials = std::filesystem::path(RELIEVO_TEST_DATA) / "materials";
    std::error_code none;
    int measured = 0;
    for (const auto& entry : std::filesystem::directory_iterator(materials, none)) {
        const auto heights = test::heightsOf(entry.path().string());
        if (!heights)
            continue; // of a kind that is not read, or without heights
        expectAgreement(middleOf(*heights), entry.path().filename().string());
        ++measured;
    }
    if (measured == 0)
        GTEST_SKIP() << "no texture sets at " << materials;
}

TEST(TraceGl, RaysThatAreNotFiniteAreAnsweredAlike)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    const HeightField field(1, 1, {0.5f});
    const SearchRay rays[] = {{{NAN, 0.}, {0., 0.}, 1.}, {{0.5, 0.5}, {0., 0.}, 1.}};
    const auto hits = traceRaysOnGpu("relief", Parameters(), &field, rays);
    ASSERT_TRUE(hits);
    EXPECT_FALSE((*hits)[0].found);
    EXPECT_EQ((*hits)[0].uv, glm::dvec2(0.));
    EXPECT_TRUE((*hits)[1].found);
}

// So far out that floats no longer tell texels apart: the answer is one all the same.
TEST(TraceGl, RaysFarOutAreAnswered)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    std::vector<float> heights(1024 * 4);
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = float(i % 251) / 255.f;
    const HeightField field(1024, 4, heights, Wrap::Repeat, 32);
    const std::vector<SearchRay> rays{{{1e36, 0.5}, {0.1, 0.1}, 1.}, {{0.5, -1e36}, {0.1, 0.1}, 1.}};
    for (const TechniqueRow& row : kTechniques) {
        if (row.file.empty())
            continue;
        const auto hits = traceRaysOnGpu(row.key, Parameters(), &field, rays);
        ASSERT_TRUE(hits);
        for (const SearchHit& hit : *hits)
            EXPECT_TRUE(hit.t >= 0. && hit.t <= 1.) << row.key << hit.t;
    }
}

// Given up on both, and next to nothing is nothing on both.
TEST(TraceGl, LimitsAreTheSameOnBoth)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    std::vector<float> heights(64 * 64);
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = float(i * 7919 % 251) / 251.f;
    heights[0] = 1.f;
    const HeightField rough(64, 64, heights, Wrap::Clamp, 32);
    std::ranges::fill(heights, 0.f);
    heights[0] = 1.f;
    const HeightField needle(64, 64, heights, Wrap::Repeat, 32);
    const std::vector<SearchRay> rays{{{0.5, 0.5}, {2e5, 0.}, 0.01}, {{0.5, 0.5}, {1e20, 0.}, 0.01},
        {{0.38, 12.5 / 64.}, {0.84, -1e-38}, 0.5}, {{0.38, 12.5 / 64.}, {0.84, 1e-40}, 0.5}, {{0.5 / 64., 0.5 / 64.}, {-1., 0.}, 0.5},
        {{0.5 / 64., 1e-42}, {0., -1e-42}, 0.5}};
    for (const char* key : {"pyramid", "cell-cone"})
        for (const HeightField& field : {rough, needle}) {
            const auto cpu = traceRays(key, Parameters(), &field, rays), gpu = traceRaysOnGpu(key, Parameters(), &field, rays);
            ASSERT_TRUE(cpu && gpu);
            EXPECT_EQ((*cpu)[0].isUnfinished, field.wrap() == Wrap::Repeat) << key;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                EXPECT_EQ((*cpu)[i].isUnfinished, (*gpu)[i].isUnfinished) << key << i;
                EXPECT_EQ((*cpu)[i].found, (*gpu)[i].found) << key << i;
                EXPECT_EQ((*cpu)[i].fetches, (*gpu)[i].fetches) << key << i;
                EXPECT_NEAR((*cpu)[i].t, (*gpu)[i].t, 1e-5) << key << i;
            }
        }
}

TEST(TraceGl, ReferenceIsCpuOnly)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    const HeightField field(1, 1, {0.5f});
    const auto hits = traceRaysOnGpu("reference", Parameters(), &field, {});
    ASSERT_FALSE(hits);
    EXPECT_NE(hits.error().hint.find("cpu"), std::string::npos);
}
