// Views of errors in other units than depth, and the numbers of what a heat view shows.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/source.h"
#include "core/state/views.h"
#include "render/measure/picture_errors.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

using namespace relievo;

namespace {
constexpr int kWidth = 120, kHeight = 90;

struct Scene {
    Expected<WindowlessContext> context = WindowlessContext::create();
    Renderer renderer;
    State state;
    Resources resources;
    Scene(const char* source, const char* technique, double angle)
    {
        state = fillingView(openSource(source, State())->state, angle);
        state.panes = {Pane{technique}};
        resources = fillingResources(*loadResources(state, {}, {}));
    }
    std::vector<float> shown(std::string_view view)
    {
        const auto drawn = drawPicture(renderer, state, 0, resources, view, kWidth, kHeight, 1, true);
        std::vector<float> values;
        for (int y = 0; drawn && y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                values.push_back(drawn->value(x, y, 0));
        return values;
    }
    Expected<ViewNumbers> numbers(const char* view)
    {
        state.panes[0].view = view;
        return renderer.measureView(DrawRequest(state, 0, resources, {.width = kWidth, .height = kHeight}));
    }
};
} // namespace

// Along a straight ray an error of the depth is one of the place: by depth, angle and texels a tile.
TEST(HeatViews, TexelsAreThoseOfTheDepthErrorAlongTheRay)
{
    for (const double angle : {30., 60., 75.}) {
        Scene scene("sample:bricks@64", "flat", angle);
        const std::vector<float> depth = scene.shown("error"), texels = scene.shown("error-texels");
        ASSERT_EQ(depth.size(), texels.size());
        const double factor = double(scene.state.parameters.depth) * std::tan(angle * 3.14159265358979 / 180.) * 64.;
        int compared = 0;
        for (std::size_t i = 40 * kWidth; i < 50 * kWidth; ++i) // the middle, where the angle is what was asked for
            if (depth[i] > 0.05f) {
                ++compared;
                EXPECT_NEAR(double(texels[i] / depth[i]), factor, 0.03 * factor) << angle;
            }
        EXPECT_GT(compared, 100);
    }
}

// From above a pixel is as large everywhere, so that pixels are texels times a constant: a tile's texels over the pixels that it spans.
TEST(HeatViews, PixelsAreTexelsOverThoseThatAPixelSpans)
{
    Scene scene("sample:bricks@64", "flat", 30.);
    scene.state.camera.pitch = 90.f;
    scene.state.parameters.depth = 0.5f;
    scene.state.camera.target.reset(), scene.state.camera.distance.reset();
    scene.state.camera.fov = 60.f; // rays that lean
    const std::vector<float> texels = scene.shown("error-texels"), pixels = scene.shown("error-pixels");
    std::vector<double> ratios;
    for (std::size_t i = 0; i < texels.size(); ++i)
        if (texels[i] > 0.5f)
            ratios.push_back(double(pixels[i] / texels[i]));
    ASSERT_GT(ratios.size(), 500u);
    const auto [least, most] = std::ranges::minmax(ratios);
    EXPECT_NEAR(least, most, 0.01 * most);
    // The plane of a metre is seen whole: as high as the picture but for the room around it.
    const double plane = most * 64. * double(scene.state.parameters.tiling); // pixels
    EXPECT_GT(plane, 0.3 * kHeight);
    EXPECT_LT(plane, 1.2 * kHeight);
}

TEST(HeatViews, MissedIsWhatWentThroughTheFirstSurface)
{
    Scene scene("hard:needles@64", "relief", 75.);
    scene.state.parameters.minSteps = scene.state.parameters.maxSteps = 8;
    const auto missed = scene.numbers("missed");
    ASSERT_TRUE(missed);
    const auto errors = pictureErrors(scene.renderer, scene.state, scene.resources, kWidth, kHeight);
    ASSERT_TRUE(errors);
    EXPECT_GT(errors->missed, 0.01);
    EXPECT_NEAR(missed->heat.mean, errors->missed, 0.002);
    EXPECT_NEAR(missed->error.wrong, errors->missed, 0.002);
}

TEST(HeatViews, NumbersAreThoseOfThePixels)
{
    Scene scene("sample:bricks@64", "relief", 60.);
    scene.state.parameters.minSteps = scene.state.parameters.maxSteps = 24;
    std::vector<float> values = scene.shown("fetches");
    const auto numbers = scene.numbers("fetches");
    ASSERT_TRUE(numbers);
    const HeatNumbers& heat = numbers->heat;
    EXPECT_NEAR(heat.mean, std::accumulate(values.begin(), values.end(), 0.) / double(values.size()), 0.01);
    std::ranges::sort(values);
    EXPECT_EQ(heat.most, double(values.back()));
    EXPECT_EQ(heat.p99, double(values[(values.size() - 1) * 99 / 100]));
    EXPECT_NEAR(std::accumulate(heat.histogram.begin(), heat.histogram.end(), 0.), 1., 1e-4);
    const double end = double(scene.state.parameters.fetchRange), half = end / 2.;
    const double below = double(std::ranges::count_if(values, [half](float v) { return double(v) < half; })) / double(values.size());
    EXPECT_NEAR(std::accumulate(heat.histogram.begin(), heat.histogram.begin() + 24, 0.), below, 1e-4);
}

// Exact techniques are so in every unit, on prisms as well.
TEST(HeatViews, ExactTechniquesShowNothing)
{
    for (const Silhouettes outline : {Silhouettes::Off, Silhouettes::Prisms}) {
        Scene scene("sample:bricks@64", "cell-cone", 60.);
        scene.state.mesh = "sphere";
        scene.state.parameters.silhouettes = outline;
        scene.state.parameters.heightMips = false;
        scene.state.camera = Camera{};
        scene.resources = *loadResources(scene.state, {}, {});
        for (const char* view : {"error-texels", "error-pixels", "missed"}) {
            (void)scene.shown(view); // makes the acceleration map
            const auto numbers = scene.numbers(view);
            ASSERT_TRUE(numbers);
            EXPECT_LT(numbers->error.wrong, 0.001) << view;
        }
    }
}
