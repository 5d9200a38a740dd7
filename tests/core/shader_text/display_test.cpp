// The display text, run on the CPU: the sRGB curve and the tone curve's promises.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace {
using namespace glm;
struct Neutral {
#include "shaders/output/tone_neutral.glsl"
};
struct Agx {
#include "shaders/output/tone_agx.glsl"
};
struct Aces {
#include "shaders/output/tone_aces.glsl"
};
struct Filmic {
#include "shaders/output/tone_filmic.glsl"
};
struct None {
#include "shaders/output/tone_none.glsl"
};
struct Display : Neutral {
    vec3 exposureFactor = vec3(1.f);
#include "shaders/output/display.glsl"
};

template <class Curve> class Curves : public testing::Test {
};
using AllCurves = testing::Types<Neutral, Agx, Aces, Filmic, None>;
TYPED_TEST_SUITE(Curves, AllCurves);
} // namespace

// Greys stay grey and keep their order; black is black, and no light, however bright, leaves the numbers.
TYPED_TEST(Curves, GreysStayGreyAndInOrder)
{
    TypeParam curve;
    EXPECT_LT(length(curve.toned(vec3(0.f))), 2e-3f);
    float before = -1.f;
    for (float grey = 1e-4f; grey < 1e30f; grey *= 1.1f) {
        const vec3 shown = curve.toned(vec3(grey));
        ASSERT_TRUE(std::isfinite(shown.x)) << grey;
        EXPECT_NEAR(shown.x, shown.y, 0.002f * max(shown.y, 1.f)) << grey;
        EXPECT_NEAR(shown.x, shown.z, 0.002f * max(shown.y, 1.f)) << grey;
        EXPECT_GE(shown.y, before - 1e-4f) << grey;
        before = shown.y;
    }
}

// What their authors publish of them.
TEST(Curves, ShowMiddleGreyAndWhiteAsPublished)
{
    EXPECT_NEAR(Filmic().toned(vec3(5.6f)).x, 1.f, 1e-5f); // white at 11.2, twice the exposure
    EXPECT_NEAR(std::pow(Agx().toned(vec3(0.18f)).y, 1.f / 2.2f), 0.5f, 0.01f); // middle grey is half of a screen's values
    EXPECT_NEAR(Agx().toned(vec3(16.29f)).y, 1.f, 0.03f); // 6.5 stops above it the curve ends
    EXPECT_NEAR(Aces().toned(vec3(16.f)).y, 1.f, 0.02f);
    EXPECT_NEAR(Aces().toned(vec3(0.18f)).y, 0.1f, 0.02f); // ACES shows middle grey at 10 nits of 100
    const vec3 middle(0.2f, 0.3f, 0.5f);
    EXPECT_EQ(None().toned(middle), middle);
}

TEST(Display, SrgbIsWithinAFifthOfAnEightBitStep)
{
    Display display;
    for (int i = 0; i <= 100000; ++i) {
        const float x = float(i) / 100000.f;
        const double exact = x <= 0.0031308f ? 12.92 * double(x) : 1.055 * std::pow(double(x), 1. / 2.4) - 0.055;
        ASSERT_NEAR(double(display.encodeSrgb(vec3(x)).x), exact, 0.2 / 255.) << x;
    }
}

TEST(Display, MiddleColoursPassTheToneCurve)
{
    Display display;
    const vec3 middle(0.2f, 0.3f, 0.5f);
    EXPECT_LT(length(display.toned(middle) - (middle - 0.04f)), 1e-6f);
    for (float bright = 1.f; bright < 1e6f; bright *= 2.f) {
        const vec3 shown = display.toned(vec3(bright, 0.5f * bright, 0.1f * bright));
        EXPECT_LE(shown.x, 1.f);
        EXPECT_GE(shown.x, shown.y);
        EXPECT_GE(shown.y, shown.z);
    }
}
