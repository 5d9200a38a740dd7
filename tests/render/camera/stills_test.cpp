// The camera's part of a picture: tiles, 16 bits, depth of field, vignette, metering.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/srgb.h"
#include "tests/render/mesh_support.h"
#include <cmath>
#include <numbers>
#include <set>

using namespace relievo;
using namespace relievo::test;

namespace {

constexpr float kDistance = 0.5f; // m, of the eye from the plane

// A plane that fills the picture, seen from above.
State filling()
{
    State state = stateOn("plane", "flat");
    state.camera = {0.f, 90.f, 35.f, kDistance, glm::vec3(0.f)};
    state.parameters.toneCurve = ToneCurve::None;
    return state;
}

// Black on the left of the plane, white on the right.
void halve(Resources& resources)
{
    constexpr int kSide = 1024;
    Material material = *resources.material;
    Image image{kSide, kSide, 3, PixelType::U8, 8, false, std::vector<std::byte>(std::size_t(kSide) * kSide * 3)};
    for (std::size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = std::byte(i / 3 % kSide < kSide / 2 ? 0 : 255);
    material.maps[std::size_t(MapKind::Color)] = std::make_shared<const Image>(image);
    resources.material = std::make_shared<const Material>(std::move(material));
}

class Stills : public testing::Test {
protected:
    Image drawn(const State& state, Still still)
    {
        Resources resources = resourcesOf(state);
        return drawn(state, resources, still);
    }
    Image drawn(const State& state, Resources& resources, Still still)
    {
        auto image = drawStill(m_renderer, state, 0, resources, still);
        EXPECT_TRUE(image) << message(image.error());
        return image ? *image : Image{};
    }
    // The mean of the logarithms of what the screen shows, as light.
    double metered(const State& state)
    {
        const Image image = drawn(state, {.view = "shaded", .width = 48, .height = 48, .type = PixelType::U16});
        double sum = 0.;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const glm::vec3 light(linearOf(image.value(x, y, 0)), linearOf(image.value(x, y, 1)), linearOf(image.value(x, y, 2)));
                sum += std::log2(double(glm::dot(light, glm::vec3(0.2126f, 0.7152f, 0.0722f))));
            }
        return std::exp2(sum / double(image.texelCount()));
    }

private:
    Expected<WindowlessContext> m_context = WindowlessContext::create();
    Renderer m_renderer;
};

TEST_F(Stills, TilesMakeTheWholePicture)
{
    State state = stateOn("spheres");
    state.parameters.objectShadows = true;
    state.parameters.background = Backdrop::Environment;
    state.parameters.vignette = 1.f;
    Still still{.view = "shaded", .width = 150, .height = 101, .samples = 2};
    const Image whole = drawn(state, still);
    still.tile = 40;
    const Image tiled = drawn(state, still);
    std::size_t others = 0;
    for (int y = 0; y < whole.height; ++y)
        for (int x = 0; x < whole.width; ++x)
            for (int c = 0; c < 4; ++c)
                others += std::abs(whole.value(x, y, c) - tiled.value(x, y, c)) > 2.f / 255.f;
    EXPECT_LT(others, whole.texelCount() * 4 / 200); // at edges rounding decides
}

TEST_F(Stills, SixteenBitsHoldWhatEightRound)
{
    State state = stateOn("sphere");
    const Image eight = drawn(state, {.view = "shaded", .width = 96, .height = 64});
    const Image sixteen = drawn(state, {.view = "shaded", .width = 96, .height = 64, .type = PixelType::U16});
    ASSERT_EQ(sixteen.type, PixelType::U16);
    std::set<float> values;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 96; ++x) {
            EXPECT_NEAR(eight.value(x, y, 1), sixteen.value(x, y, 1), 0.51 / 255.);
            values.insert(sixteen.value(x, y, 1));
        }
    EXPECT_GT(values.size(), 300u);
}

TEST_F(Stills, TooLargeOnesAreRefused)
{
    State state = filling();
    Resources resources = resourcesOf(state);
    Renderer renderer;
    EXPECT_FALSE(drawStill(renderer, state, 0, resources, {.view = "shaded", .width = kMaxPictureSide + 1, .height = 1}));
    std::stop_source stop;
    stop.request_stop();
    const auto stopped = drawStill(renderer, state, 0, resources, {.view = "shaded", .width = 8, .height = 8}, {{}, stop.get_token()});
    ASSERT_FALSE(stopped);
    EXPECT_TRUE(isCancelled(stopped.error()));
}

// A straight edge, out of focus, is what the disc of confusion covers of it: its diameter on the plane is A |d - F| / F.
TEST_F(Stills, BlurIsTheDiscOfConfusion)
{
    constexpr int kSize = 200;
    State state = filling();
    Resources resources = resourcesOf(state);
    halve(resources);
    state.parameters.fStop = 1.f;
    const double half = std::tan(17.5 * std::numbers::pi / 180.), aperture = 0.012 / half / 1.;
    for (const double focus : {0.5, 1., 0.4}) {
        state.parameters.focusDistance = float(focus);
        const Image image
            = drawn(state, resources, {.view = "color", .width = kSize, .height = kSize, .samples = kMaxSamples, .type = PixelType::U16});
        const double radius = 0.5 * aperture * std::abs(double(kDistance) - focus) / focus / (2. * double(kDistance) * half) * kSize;
        for (int x = kSize / 2 - 20; x < kSize / 2 + 20; ++x) {
            const double off = (double(x) + 0.5 - 0.5 * kSize), share = std::clamp(off / std::max(radius, 1e-9), -1., 1.);
            const double covered = 0.5 + (share * std::sqrt(1. - share * share) + std::asin(share)) / std::numbers::pi;
            if (std::abs(off) > 1. || radius > 3.) {
                EXPECT_NEAR(double(image.value(x, kSize / 2, 0)), covered, 0.06) << focus << ' ' << x;
            }
        }
    }
    state.parameters.fStop = 0.f;
    const Image sharp = drawn(state, resources, {.view = "color", .width = kSize, .height = kSize, .samples = 16});
    EXPECT_EQ(sharp.value(kSize / 2 - 2, kSize / 2, 0), 0.f);
    EXPECT_EQ(sharp.value(kSize / 2 + 2, kSize / 2, 0), 1.f);
}

TEST_F(Stills, VignetteFallsByTheFourthPowerOfTheCosine)
{
    constexpr int kSize = 64;
    State state = filling();
    const Image plain = drawn(state, {.view = "shaded", .width = kSize, .height = kSize, .type = PixelType::U16});
    state.parameters.vignette = 1.f;
    const Image dark = drawn(state, {.view = "shaded", .width = kSize, .height = kSize, .type = PixelType::U16});
    const double half = std::tan(17.5 * std::numbers::pi / 180.);
    for (const int x : {0, 16, 32, 63})
        for (const int y : {0, 31, 63}) {
            const double right = ((x + 0.5) / 32. - 1.) * half, up = ((y + 0.5) / 32. - 1.) * half;
            const double cosine2 = 1. / (1. + right * right + up * up);
            EXPECT_NEAR(double(linearOf(dark.value(x, y, 1)) / linearOf(plain.value(x, y, 1))), cosine2 * cosine2, 0.01) << x << ' ' << y;
        }
}

TEST_F(Stills, MeteringMakesTheMeanMiddleGrey)
{
    State state = filling();
    state.parameters.autoExposure = true;
    state.parameters.environmentIntensity = 0.f;
    for (const float intensity : {0.05f, 1.f, 20.f}) {
        state.parameters.lightIntensity = intensity;
        EXPECT_NEAR(metered(state), 0.18, 0.006) << intensity;
    }
    state.parameters.exposure = -1.f; // on top of it
    EXPECT_NEAR(metered(state), 0.09, 0.003);
    state.parameters.lightIntensity = 0.f; // nothing to meter: black, and finite
    EXPECT_TRUE(drawn(state, {.view = "shaded", .width = 8, .height = 8}).value(4, 4, 0) == 0.f);
}

} // namespace
