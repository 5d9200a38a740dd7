// Normals that differ within a pixel: how far off the brightness of a far view is, against the same view supersampled.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/render/mesh_support.h"
#include <cmath>
#include <cstdio>
#include <numbers>

using namespace relievo;
using namespace relievo::test;

namespace {
constexpr int kTexels = 64, kTiles = 16, kPixels = 64, kFiner = 16; // then a pixel of the finer picture is a texel

// Metal with round bumps: waves along both axes, up to `steep`.
std::shared_ptr<const Material> wavyMetal(const Material& plain, float steep)
{
    Material material = plain;
    Image normals{kTexels, kTexels, 3, PixelType::U8, 8, false, std::vector<std::byte>(std::size_t(kTexels) * kTexels * 3)};
    for (int y = 0; y < kTexels; ++y)
        for (int x = 0; x < kTexels; ++x) {
            const float turn = 2.f * std::numbers::pi_v<float> / 16.f;
            const glm::vec3 n = glm::normalize(glm::vec3(steep * std::sin(float(x) * turn), steep * std::cos(float(y) * turn), 1.f));
            for (int c = 0; c < 3; ++c)
                normals.data[(std::size_t(y) * kTexels + std::size_t(x)) * 3 + std::size_t(c)]
                    = std::byte(std::lround((n[c] * 0.5f + 0.5f) * 255.f));
        }
    material.maps[std::size_t(MapKind::Normal)] = std::make_shared<const Image>(std::move(normals));
    material.maps[std::size_t(MapKind::Metallic)]
        = std::make_shared<const Image>(Image{1, 1, 1, PixelType::U8, 8, false, {std::byte(255)}});
    return std::make_shared<const Material>(std::move(material));
}

double mean(const Image& image)
{
    double sum = 0.;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            sum += double(image.value(x, y, 1));
    return sum / double(image.texelCount());
}
} // namespace

// Parts without relief have no normal map to filter.
TEST(FarNormals, PlainPartsAreDrawnToo)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("spheres", "bump");
    Resources resources = resourcesOf(state);
    resources.material = wavyMetal(*resources.material, 0.5f);
    for (const NormalFiltering how : {NormalFiltering::Toksvig, NormalFiltering::Variance}) {
        state.parameters.normalFiltering = how;
        const auto drawn = drawPicture(renderer, state, 0, resources, "shaded", 32, 24, 1, false);
        EXPECT_TRUE(drawn) << message(drawn.error());
    }
}

TEST(FarNormals, FilteredOnesKeepTheBrightness)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("plane", "bump");
    state.camera = {0.f, 90.f, 35.f, 1.5f, glm::vec3(0.f)};
    Parameters& p = state.parameters;
    p.tiling = kTiles, p.environmentIntensity = 0.f, p.roughness = 0.25f, p.background = Backdrop::Transparent;
    Resources resources = resourcesOf(state);
    const auto brightness
        = [&](int pixels) { return mean(*drawPicture(renderer, state, 0, resources, "shaded", pixels, pixels, 1, true)); };
    const Material plain = *resources.material;
    double worst[3] = {};
    for (const float steep : {0.2f, 0.5f}) {
        resources.material = wavyMetal(plain, steep);
        for (const float pitch : {85.f, 70.f, 50.f}) {
            p.lightPitch = pitch;
            p.normalFiltering = NormalFiltering::Off;
            const double right = brightness(kPixels * kFiner);
            for (const NormalFiltering how : {NormalFiltering::Off, NormalFiltering::Toksvig, NormalFiltering::Variance}) {
                p.normalFiltering = how;
                const double off = std::abs(std::log2(brightness(kPixels) / right)); // stops
                worst[std::size_t(how)] = std::max(worst[std::size_t(how)], off);
                std::printf("steep %.1f, light at %.0f deg, %s: %.2f stops off\n", double(steep), double(pitch),
                    std::string(wordOf(how)).c_str(), off);
            }
        }
    }
    EXPECT_LT(worst[1], 0.5 * worst[0]);
    EXPECT_LT(worst[2], 0.5 * worst[0]);
}
