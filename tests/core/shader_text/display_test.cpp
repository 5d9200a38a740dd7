// The display text, run on the CPU: the sRGB curve and the tone curve's promises.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace {
using namespace glm;
struct Display {
    float exposureFactor = 1.f;
#include "shaders/output/display.glsl"
};
} // namespace

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
    EXPECT_LT(length(display.toneCurve(middle) - (middle - 0.04f)), 1e-6f);
    for (float bright = 1.f; bright < 1e6f; bright *= 2.f) {
        const vec3 shown = display.toneCurve(vec3(bright, 0.5f * bright, 0.1f * bright));
        EXPECT_LE(shown.x, 1.f);
        EXPECT_GE(shown.x, shown.y);
        EXPECT_GE(shown.y, shown.z);
    }
}
