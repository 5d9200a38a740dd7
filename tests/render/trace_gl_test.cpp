// The same search text on the GPU and on the CPU.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/techniques.h"
#include "core/trace/shader_on_cpu.h"
#include "render/windowless.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace relievo;

namespace {

std::vector<SearchRay> raysOf(int count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(-1.f, 1.f);
    std::vector<SearchRay> rays;
    for (int i = 0; i < count; ++i)
        rays.push_back({{unit(random), unit(random)}, {0.6f * unit(random), 0.6f * unit(random)}, std::abs(unit(random)) + 1e-3f});
    return rays;
}

void expectAgreement(const HeightField& field, const char* name)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context) << message(context.error());
    const auto rays = raysOf(10000, 21);
    for (const TechniqueRow& row : kTechniques) {
        if (row.file.empty())
            continue;
        const auto cpu = traceRays(row.key, Parameters(), &field, rays);
        ASSERT_TRUE(cpu) << row.key;
        for (const Dialect dialect : {Dialect::Desktop, Dialect::Es}) {
            const auto gpu = traceRaysOnGpu(row.key, Parameters(), &field, rays, dialect);
            ASSERT_TRUE(gpu) << row.key << ' ' << int(dialect) << ' ' << message(gpu.error());
            int apart = 0, otherFetches = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                apart += !(std::abs((*cpu)[i].t - (*gpu)[i].t) < 1e-4) || (*cpu)[i].found != (*gpu)[i].found;
                otherFetches += (*cpu)[i].fetches != (*gpu)[i].fetches;
            }
            EXPECT_LE(apart, 10) << name << ' ' << row.key << ' ' << int(dialect); // 99.9 % agree
            EXPECT_LE(otherFetches, 100) << name << ' ' << row.key << ' ' << int(dialect);
        }
    }
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

TEST(TraceGl, ReferenceIsCpuOnly)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    const HeightField field(1, 1, {0.5f});
    const auto hits = traceRaysOnGpu("reference", Parameters(), &field, {});
    ASSERT_FALSE(hits);
    EXPECT_NE(hits.error().hint.find("cpu"), std::string::npos);
}
