// What surrounds the mesh in pictures: environments, backgrounds, and the floor that takes its shadow.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/srgb.h"
#include "core/state/environments.h"
#include "render/frame.h"
#include "render/gl/framebuffer.h"
#include "tests/render/mesh_support.h"

using namespace relievo;
using namespace relievo::test;

namespace {
class Surroundings : public testing::Test {
protected:
    void SetUp() override
    {
        ASSERT_TRUE(m_context);
        m_state = stateOn("sphere", "flat");
        m_state.slots = {};
        m_state.camera = {.yaw = 0.f, .pitch = 20.f, .fov = 35.f, .distance = 4.f, .target = {}, .fill = 0.f};
        p.lightIntensity = 0.f, p.environmentIntensity = 1.f;
    }
    Image drawn(std::string_view view = "shaded", bool linear = true, int width = 120, int height = 120)
    {
        Resources resources = resourcesOf(m_state);
        const auto image = drawPicture(m_renderer, m_state, 0, resources, view, width, height, 1, linear);
        EXPECT_TRUE(image) << (image ? "" : message(image.error()));
        return image.value_or(Image());
    }
    static float mean(const Image& image, int left, int top, int right, int bottom, int channel)
    {
        float sum = 0.f;
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x)
                sum += image.value(x, y, channel) / float((right - left) * (bottom - top));
        return sum;
    }
    // How unlike neighbours are, in the strip above the mesh.
    static float detail(const Image& image)
    {
        float sum = 0.f;
        for (int y = 0; y < 30; ++y)
            for (int x = 1; x < image.width; ++x)
                sum += std::abs(image.value(x, y, 1) - image.value(x - 1, y, 1));
        return sum;
    }

    Expected<WindowlessContext> m_context = WindowlessContext::create();
    Renderer m_renderer;
    State m_state;
    Parameters& p = m_state.parameters;
};

TEST_F(Surroundings, EachEnvironmentLightsInItsWayAndTurns)
{
    std::vector<Image> pictures;
    for (const EnvironmentRow& row : kEnvironments) {
        m_state.environment = row.key;
        p.background = Backdrop::Transparent, p.environmentYaw = 0.f;
        pictures.push_back(drawn());
        p.environmentYaw = 90.f;
        EXPECT_EQ(differing(pictures.back(), drawn(), 0.002f) > 0.2, row.key != "grey") << row.key;
    }
    for (std::size_t i = 0; i < pictures.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GT(differing(pictures[i], pictures[j], 0.01f), 0.2) << kEnvironments[i].key << ' ' << kEnvironments[j].key;
}

TEST_F(Surroundings, TheBackgroundIsAsSharpAsAsked)
{
    p.background = Backdrop::Environment;
    m_state.camera.pitch = 0.f, m_state.camera.fov = 80.f; // lamps of the studio are seen
    float last = std::numeric_limits<float>::infinity();
    for (const float blur : {0.f, 0.4f, 1.f}) {
        p.backgroundBlur = blur;
        const float now = detail(drawn());
        EXPECT_LT(now, 0.9f * last) << blur;
        last = now;
    }
}

TEST_F(Surroundings, AColorIsShownAsItIsWhateverTheExposure)
{
    p.background = Backdrop::Color, p.backgroundColor = {0.8f, 0.1f, 0.3f}, p.exposure = 3.f;
    for (const bool linear : {false, true})
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(drawn("shaded", linear).value(2, 2, c), linear ? p.backgroundColor[c] : srgbOf(p.backgroundColor[c]), 0.003f);
    EXPECT_EQ(drawn().value(2, 2, 3), 1.f);
    EXPECT_LT(drawn("fetches", false).value(2, 2, 0), 0.3f) << "heat maps lie on a plain ground";
}

TEST_F(Surroundings, TheFloorTakesTheShadowOfTheMesh)
{
    p.background = Backdrop::Color, p.backgroundColor = glm::vec3(0.5f);
    p.lightIntensity = 2.f, p.lightYaw = -60.f, p.lightPitch = 45.f;
    const Image without = drawn();
    p.ground = true;
    const Image with = drawn();
    EXPECT_NEAR(mean(with, 2, 2, 20, 20, 1), 0.5f, 1e-3f) << "none above the floor";
    EXPECT_NEAR(mean(with, 2, 116, 6, 119, 1), 0.5f, 0.05f) << "it fades into the background";
    EXPECT_LT(mean(with, 88, 74, 98, 82, 1), 0.3f) << "right of the mesh, away from the light";
    EXPECT_GT(mean(with, 22, 74, 32, 82, 1), 0.4f) << "left of it";
    for (int y = 45; y < 60; ++y)
        EXPECT_EQ(with.value(60, y, 1), without.value(60, y, 1)) << "the mesh itself stays";
    p.shadowStrength = 0.f, p.environmentIntensity = 0.f;
    EXPECT_NEAR(mean(drawn(), 88, 74, 98, 82, 1), 0.5f, 0.01f);
}

TEST_F(Surroundings, WhereItTouchesTheFloorIsDarkInEvenLightToo)
{
    m_state.environment = "grey";
    p.background = Backdrop::Color, p.backgroundColor = glm::vec3(0.5f), p.ground = true;
    const Image image = drawn();
    int lowest = 0;
    p.background = Backdrop::Transparent, p.ground = false;
    const Image alone = drawn();
    for (int y = 0; y < alone.height; ++y)
        lowest = alone.value(60, y, 3) > 0.f ? y : lowest;
    EXPECT_LT(image.value(60, lowest + 1, 1), 0.25f);
    EXPECT_LT(image.value(60, lowest + 1, 1), image.value(60, lowest + 12, 1) - 0.05f);
}

TEST_F(Surroundings, OnATransparentBackgroundTheFloorIsItsShadow)
{
    p.background = Backdrop::Transparent, p.lightIntensity = 2.f, p.lightYaw = -60.f, p.lightPitch = 45.f;
    p.ground = true, p.groundReflection = 1.f;
    const Image image = drawn("shaded", false);
    EXPECT_EQ(image.value(2, 2, 3), 0.f);
    EXPECT_GT(mean(image, 88, 74, 98, 82, 3), 0.2f);
    EXPECT_LT(mean(image, 88, 74, 98, 82, 1), 0.02f) << "black";
    EXPECT_EQ(image.value(60, 50, 3), 1.f);
}

TEST_F(Surroundings, TheFloorMirrorsTheMesh)
{
    m_state.environment = "grey";
    p.background = Backdrop::Color, p.backgroundColor = glm::vec3(0.f), p.ground = true;
    m_state.camera.pitch = 4.f;
    const Image dull = drawn();
    p.groundReflection = 0.5f;
    const Image glossy = drawn();
    EXPECT_LT(mean(dull, 55, 92, 65, 100, 1), 0.01f);
    EXPECT_NEAR(mean(glossy, 55, 92, 65, 100, 1), 0.3f, 0.2f) << "white, half of it, shaded";
    EXPECT_EQ(glossy.value(60, 50, 1), dull.value(60, 50, 1));
    EXPECT_NEAR(glossy.value(2, 118, 1), 0.f, 0.01f);
}

TEST_F(Surroundings, DataViewsAndTheEyeBelowHaveNoFloor)
{
    p.background = Backdrop::Transparent, p.ground = true;
    for (const char* view : {"normal", "depth", "fetches", "color", "shadow", "position"})
        EXPECT_EQ(drawn(view).value(92, 78, 3), 0.f) << view;
    EXPECT_GT(drawn().value(64, 88, 3), 0.f);
    m_state.camera.pitch = -20.f;
    const Image below = drawn();
    for (int y = 0; y < 120; y += 119)
        EXPECT_EQ(below.value(60, y, 3), 0.f);
    EXPECT_FALSE(ofFirstPane(m_state).parameters.ground) << "what is measured has none";
}

} // namespace
