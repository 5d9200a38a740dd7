// The ray behind a point of a picture is the one that the picture searched along.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/picked_ray.h"
#include "core/scene/source.h"
#include "core/trace/recorded_steps.h"
#include "render/windowless.h"
#include <gtest/gtest.h>

using namespace relievo;

TEST(PickedRay, FindsWhatThePictureShows)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context) << message(context.error());
    Renderer renderer;
    constexpr int kWidth = 160, kHeight = 120;
    for (const char* mesh : {"plane", "sphere", "cylinder"})
        for (const float midlevel : {1.f, 0.5f}) {
            auto opened = openSource("sample:bricks@256", State());
            ASSERT_TRUE(opened);
            State& state = opened->state;
            state.mesh = mesh;
            state.panes.front().technique = "pyramid";
            state.parameters.tiling = 2.f;
            state.parameters.rotation = 30.f;
            state.parameters.offsetU = 0.3f;
            state.parameters.midlevel = midlevel;
            state.parameters.depth = 0.1f;
            state.parameters.heightMips = false;
            Resources resources = *loadResources(state, opened->images, {});
            const Image depth = *drawPicture(renderer, state, 0, resources, "depth", kWidth, kHeight, 1, true);
            const auto maps = searchMaps("pyramid", state.parameters, &*resources.material->height);
            ASSERT_TRUE(maps);
            int compared = 0, wrong = 0;
            for (int y = 2; y < kHeight; y += 5)
                for (int x = 2; x < kWidth; x += 5) {
                    const auto picked = pickedRay(
                        state, 0, resources, {(float(x) + 0.5f) / kWidth, (float(y) + 0.5f) / kHeight}, float(kWidth) / float(kHeight));
                    if (!picked || picked->ray.cosView < 0.1) // there a pixel is as wide as the relief
                        continue;
                    const auto recorded = recordSearch("pyramid", state.parameters, *maps, picked->ray);
                    ASSERT_TRUE(recorded);
                    ++compared;
                    wrong += int(std::abs(recorded->hit.t - double(depth.value(x, y, 0))) > 2e-3);
                }
            EXPECT_GT(compared, 100) << mesh;
            EXPECT_LE(wrong, compared / 50) << mesh << ", midlevel " << midlevel << ": of " << compared; // edges of bricks
            EXPECT_FALSE(pickedRay(state, 0, resources, {0.001f, 0.001f}, float(kWidth) / float(kHeight)) && mesh == std::string("sphere"));
        }
}

TEST(PickedRay, TellsPlainPartsAndBends)
{
    State state = openSource("sample:bricks@64", State())->state;
    state.mesh = "spheres"; // plain ones, sunk into a plane
    const Resources resources = *loadResources(state, {}, {});
    bool plain = false, relief = false;
    for (int i = 0; i < 400; ++i)
        if (const auto picked = pickedRay(state, 0, resources, {float(i % 20) / 20, float(i / 20) / 20}, 1.f)) {
            (picked->isPlain ? plain : relief) = true;
            EXPECT_FALSE(picked->bends);
        }
    EXPECT_TRUE(plain && relief);
    state.parameters.silhouettes = Silhouettes::Quadric;
    EXPECT_TRUE(pickedRay(state, 0, resources, {0.5f, 0.5f}, 1.f)->bends);
}
