// The glow around what is bright: no light is lost or made, and what does not glow stays as it is, bit for bit.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/framebuffer.h"
#include "render/glow.h"
#include "tests/render/mesh_support.h"
#include <functional>

using namespace relievo;
using namespace relievo::test;

namespace {
Image blank(int width, int height)
{
    return {width, height, 4, PixelType::F32, 32, true, std::vector<std::byte>(std::size_t(width) * std::size_t(height) * 16)};
}

float& at(Image& image, int x, int y, int channel)
{
    return reinterpret_cast<float*>(
        image.data.data())[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * 4 + std::size_t(channel)];
}

Image lamp(int width, int height, int x, int y, float light)
{
    Image image = blank(width, height);
    for (int channel = 0; channel < 4; ++channel)
        at(image, x, y, channel) = channel < 3 ? light : 1.f;
    return image;
}

double sum(const Image& image, int channel = 1)
{
    double all = 0.;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            all += double(image.value(x, y, channel));
    return all;
}

void upload(unsigned texture, const Image& image)
{
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGBA, GL_FLOAT, image.data.data());
    glBindTexture(GL_TEXTURE_2D, 0);
}

class GlowTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(m_context) << message(m_context.error()); }

    // Of a picture of linear values, rows from below.
    Image glowing(const Image& light, float bloom, float threshold = 0.f, float size = 0.1f)
    {
        LightPicture picture;
        Framebuffer framebuffer;
        EXPECT_TRUE(picture.resize(light.width, light.height, true));
        EXPECT_TRUE(framebuffer.resize(light.width, light.height, true));
        upload(picture.shown(), light), upload(picture.light(), light);
        Parameters parameters;
        parameters.bloom = bloom, parameters.bloomThreshold = threshold, parameters.bloomSize = size;
        ProgramFeatures features;
        features.linear = true;
        Glow glow;
        ProgramCache programs;
        const auto drawn = glow.draw(picture, picture,
            {.framebuffer = framebuffer.handle(), .width = light.width, .height = light.height, .linear = true}, features, parameters,
            SceneUniforms(), programs);
        EXPECT_TRUE(drawn) << (drawn ? "" : message(drawn.error()));
        Image result = blank(light.width, light.height);
        glReadPixels(0, 0, light.width, light.height, GL_RGBA, GL_FLOAT, result.data.data());
        return result;
    }

    // A plane that fills the picture but for its edges, black, with a lamp in the middle of it.
    static State room()
    {
        State state = stateOn("plane", "flat");
        state.camera = {0.f, 90.f, 35.f, 2.4f, glm::vec3(0.f)};
        state.parameters.environmentIntensity = 0.1f, state.parameters.emission = 40.f;
        return state;
    }
    static Resources lit(const State& state)
    {
        constexpr int kSide = 32;
        Resources resources = resourcesOf(state);
        Material material = *resources.material;
        Image image{kSide, kSide, 3, PixelType::U8, 8, false, std::vector<std::byte>(std::size_t(kSide) * kSide * 3)};
        for (int y = 14; y < 18; ++y)
            for (int x = 14; x < 18; ++x)
                for (int c = 0; c < 3; ++c)
                    image.data[std::size_t((y * kSide + x) * 3 + c)] = std::byte(c == 0 ? 255 : 200);
        material.maps[std::size_t(MapKind::Emission)] = std::make_shared<const Image>(std::move(image));
        resources.material = std::make_shared<const Material>(std::move(material));
        return resources;
    }
    Image still(const State& state, Resources& resources, PixelType type = PixelType::U8, int samples = 1, int tile = 4096)
    {
        const auto image = drawStill(m_renderer, state, 0, resources,
            {.view = "shaded", .width = 160, .height = 120, .samples = samples, .type = type, .tile = tile});
        EXPECT_TRUE(image) << (image ? "" : message(image.error()));
        return image.value_or(Image());
    }

    Expected<WindowlessContext> m_context = WindowlessContext::create();
    Renderer m_renderer;
};

TEST_F(GlowTest, ALampKeepsItsLight)
{
    for (const auto& [width, height] : {std::pair{128, 128}, {129, 97}, {200, 60}, {190, 109}, {37, 23}, {5, 3}, {1, 1}})
        for (const auto& [x, y] : {std::pair{width / 2, height / 2}, {0, 0}, {width - 1, height / 3}})
            for (const float bloom : {0.4f, 1.f})
                for (const float threshold : {0.f, 2.f}) {
                    const Image spread = glowing(lamp(width, height, x, y, 1000.f), bloom, threshold);
                    EXPECT_NEAR(sum(spread), 1000., 10.) << width << 'x' << height << ' ' << x << ' ' << y << ' ' << bloom;
                    EXPECT_NEAR(sum(spread, 3), 1., 1e-6); // the alpha stays where it was
                }
}

TEST_F(GlowTest, ItIsAlikeToAllSidesAndFadesOutwards)
{
    constexpr int kSide = 129, kMiddle = kSide / 2;
    const Image spread = glowing(lamp(kSide, kSide, kMiddle, kMiddle, 1000.f), 0.9f);
    float last = spread.value(kMiddle, kMiddle, 0);
    for (int away = 1; away <= kMiddle; ++away) {
        const float right = spread.value(kMiddle + away, kMiddle, 0);
        for (const float other :
            {spread.value(kMiddle - away, kMiddle, 0), spread.value(kMiddle, kMiddle + away, 0), spread.value(kMiddle, kMiddle - away, 0)})
            EXPECT_NEAR(other, right, 0.01f * right) << away;
        EXPECT_LE(right, last * 1.001f) << away;
        last = right;
    }
    EXPECT_GT(spread.value(kMiddle + 20, kMiddle, 0), 0.f);
}

TEST_F(GlowTest, AnEvenPictureStaysAsItIs)
{
    Image even = blank(90, 47);
    for (int y = 0; y < even.height; ++y)
        for (int x = 0; x < even.width; ++x)
            for (int channel = 0; channel < 4; ++channel)
                at(even, x, y, channel) = channel < 3 ? 3.f : 1.f;
    const Image spread = glowing(even, 1.f, 0.5f);
    for (int y = 0; y < even.height; ++y)
        for (int x = 0; x < even.width; ++x)
            EXPECT_NEAR(spread.value(x, y, 0), 3.f, 0.01f);
}

TEST_F(GlowTest, ItReachesAsFarAtAnyResolution)
{
    // How much of a lamp's light lies within a tenth of the height.
    const auto near = [&](int side) {
        Image light = blank(side, side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                if (std::max(std::abs(2 * x + 1 - side), std::abs(2 * y + 1 - side)) < side / 16)
                    for (int channel = 0; channel < 4; ++channel)
                        at(light, x, y, channel) = 100.f;
        const Image spread = glowing(light, 1.f);
        double inner = 0.;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                inner += std::hypot(x - side / 2, y - side / 2) < 0.1 * side ? double(spread.value(x, y, 0)) : 0.;
        return inner / sum(spread, 0);
    };
    const double small = near(128), large = near(512);
    EXPECT_GT(small, 0.1);
    EXPECT_LT(small, 0.95);
    EXPECT_NEAR(large, small, 0.1 * small);
}

// Exposed as the screen, but no light above the threshold: nothing may move by a bit, whatever else is drawn.
TEST_F(GlowTest, WhatDoesNotGlowStaysBitForBit)
{
    const std::pair<const char*, std::function<void(State&)>> scenes[] = {
        {"plain", [](State&) {}},
        {"environment", [](State& s) { s.parameters.background = Backdrop::Environment; }},
        {"gradient", [](State& s) { s.parameters.background = Backdrop::Gradient; }},
        {"color", [](State& s) { s.parameters.background = Backdrop::Color, s.parameters.exposure = 2.f; }},
        {"transparent, floor", [](State& s) { s.parameters.background = Backdrop::Transparent, s.parameters.ground = true; }},
        {"floor that mirrors", [](State& s) { s.parameters.ground = true, s.parameters.groundReflection = 0.7f; }},
        {"wireframe, curves", [](State& s) { s.parameters.wireframe = true, s.parameters.toneCurve = ToneCurve::Agx; }},
        {"vignette, object shadows", [](State& s) { s.parameters.vignette = 1.f, s.parameters.objectShadows = true; }},
    };
    const State ball = stateOn("sphere", "relief");
    Resources resources = resourcesOf(ball);
    for (const auto& [name, change] : scenes)
        for (const PixelType type : {PixelType::U8, PixelType::U16, PixelType::F32}) {
            State state = ball;
            change(state);
            state.parameters.bloomThreshold = 100.f, state.parameters.bloomSize = 0.4f;
            state.parameters.bloom = 1.f;
            State plain = state;
            plain.parameters.bloom = 0.f;
            EXPECT_TRUE(still(state, resources, type, 2).data == still(plain, resources, type, 2).data) << name << ' ' << int(type);
        }
}

TEST_F(GlowTest, TheSceneKeepsItsLightAndItsAlpha)
{
    for (const Backdrop behind : {Backdrop::Transparent, Backdrop::Environment, Backdrop::Plain}) {
        State state = room();
        state.parameters.background = behind;
        Resources resources = lit(state);
        const Image off = still(state, resources, PixelType::F32);
        state.parameters.bloom = 0.5f;
        const Image on = still(state, resources, PixelType::F32);
        EXPECT_NEAR(sum(on, 0), sum(off, 0), 0.01 * sum(off, 0));
        EXPECT_EQ(sum(on, 3), sum(off, 3));
        EXPECT_GT(on.value(80, 80, 0), 1.1f * off.value(80, 80, 0)); // beside the lamp
        EXPECT_LT(on.value(80, 60, 0), off.value(80, 60, 0)); // its middle
        const Image shownOff = [&] {
            State without = state;
            without.parameters.bloom = 0.f;
            return still(without, resources, PixelType::U8, 4);
        }();
        const Image shown = still(state, resources, PixelType::U8, 4);
        for (int y = 0; y < shown.height; ++y)
            for (int x = 0; x < shown.width; ++x)
                ASSERT_EQ(shown.value(x, y, 3), shownOff.value(x, y, 3));
        EXPECT_GT(shown.value(80, 80, 0), shownOff.value(80, 80, 0));
    }
}

// Over what is shown as it is, whatever the exposure, light is added after the tone curve.
TEST_F(GlowTest, ItIsSeenOverAPlainBackground)
{
    State state = room();
    state.camera.distance = 6.f;
    state.parameters.background = Backdrop::Color, state.parameters.backgroundColor = glm::vec3(0.1f);
    state.parameters.emission = 100.f;
    Resources resources = lit(state);
    const float before = still(state, resources).value(80, 82, 0);
    state.parameters.bloom = 1.f, state.parameters.bloomSize = 0.5f;
    EXPECT_GT(still(state, resources).value(80, 82, 0), before);
}

TEST_F(GlowTest, RowsInTurnMakeTheSamePicture)
{
    State state = room();
    state.parameters.bloom = 0.5f;
    const Resources resources = lit(state);
    Framebuffer framebuffer;
    constexpr int kWidth = 96, kHeight = 70;
    ASSERT_TRUE(framebuffer.resize(kWidth, kHeight));
    const auto drawn = [&](int rows) {
        for (int row = 0; row < kHeight; row += rows)
            EXPECT_TRUE(m_renderer.draw({state, 0, resources,
                {.framebuffer = framebuffer.handle(),
                    .width = kWidth,
                    .height = kHeight,
                    .firstRow = rows < kHeight ? row : 0,
                    .rows = rows < kHeight ? rows : 0}}));
        std::vector<std::byte> pixels(std::size_t(kWidth) * kHeight * 4);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.handle());
        glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    };
    EXPECT_EQ(drawn(23), drawn(kHeight));
}

TEST_F(GlowTest, TilesHaveNoSeams)
{
    State state = room();
    state.parameters.bloom = 0.5f;
    Resources resources = lit(state);
    const Image whole = still(state, resources, PixelType::F32, 4), tiled = still(state, resources, PixelType::F32, 4, 48);
    for (int y = 0; y < whole.height; ++y)
        for (int x = 0; x < whole.width; ++x)
            ASSERT_NEAR(tiled.value(x, y, 0), whole.value(x, y, 0), 0.01f + 0.02f * whole.value(x, y, 0)) << x << ' ' << y;
}

} // namespace
