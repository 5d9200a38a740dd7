// Pictures made for measuring: they are filled, and what is measured on them is right.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/settings.h"
#include "core/scene/source.h"
#include "render/measure/frame_time.h"
#include "render/measure/picture_errors.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace relievo;

namespace {

struct Bench {
    Expected<WindowlessContext> context = WindowlessContext::create();
    Renderer renderer;
    State state;
    Resources resources;
    explicit Bench(const char* source)
    {
        state = openSource(source, State())->state;
        resources = *loadResources(state, {}, {});
    }
    State with(const char* technique, double angle)
    {
        State view = fillingView(state, angle);
        view.panes = {Pane{technique, {}}};
        return view;
    }
};

} // namespace

TEST(FillingView, FillsThePictureAtEveryAngle)
{
    Bench bench("hard:bricks@64");
    for (const double angle : kPictureAngles) {
        const State view = bench.with("flat", angle);
        const auto errors = pictureErrors(bench.renderer, view, bench.resources, 80, 60);
        ASSERT_TRUE(errors) << message(errors.error());
        EXPECT_EQ(errors->covered, 1.) << angle;
    }
}

// Straight from above a tile spans what is promised: the picture of a ramp over the tile shows that share of its heights.
TEST(FillingView, ShowsAboutOneTile)
{
    Bench bench("hard:seam@64");
    State view = bench.with("flat", 0.);
    view.parameters.offsetU = 0.5f; // the seam out of the middle
    const auto depth = drawPicture(bench.renderer, view, 0, bench.resources, "error", 320, 240, 1, true);
    ASSERT_TRUE(depth);
    const double across = std::abs(double(depth->value(319, 120, 0)) - double(depth->value(0, 120, 0)));
    EXPECT_NEAR(across, kTilesAcross, 0.02);
}

TEST(PictureErrors, OfAConstantFieldAreKnown)
{
    Bench bench("hard:low@8"); // the exact depth is 1 everywhere
    const auto flat = pictureErrors(bench.renderer, bench.with("flat", 30.), bench.resources, 40, 30);
    ASSERT_TRUE(flat);
    EXPECT_NEAR(flat->rmse, 1., 1e-3);
    EXPECT_EQ(flat->missed, 0.); // too short is not missed
    EXPECT_EQ(flat->meanFetches, 0.);
    for (const char* technique : {"parallax", "relief"}) {
        const auto errors = pictureErrors(bench.renderer, bench.with(technique, 60.), bench.resources, 40, 30);
        ASSERT_TRUE(errors);
        EXPECT_NEAR(errors->rmse, 0., 1e-3) << technique;
        EXPECT_GE(errors->meanFetches, 1.);
    }
}

TEST(PictureErrors, FewerStepsMissMore)
{
    Bench bench("hard:needles@64");
    const auto errorsOf = [&](int steps) {
        State view = bench.with("relief", 75.);
        view.parameters.minSteps = view.parameters.maxSteps = steps;
        view.parameters.refineSteps = 8;
        return *pictureErrors(bench.renderer, view, bench.resources, 120, 90);
    };
    const PictureErrors few = errorsOf(4), many = errorsOf(512);
    EXPECT_GT(few.missed, many.missed + 0.005);
    EXPECT_GT(few.rmse, many.rmse);
    EXPECT_LT(many.missed, 0.02);
    EXPECT_GT(many.meanFetches, few.meanFetches);
}

TEST(PictureErrors, ExactTechniquesHaveNone)
{
    Bench bench("hard:bricks@64");
    for (const TechniqueRow& row : kTechniques) {
        if (!row.isExact || row.file.empty())
            continue;
        const State view = bench.with(std::string(row.key).c_str(), 60.);
        EXPECT_LT(pictureErrors(bench.renderer, view, bench.resources, 120, 90)->missed, 1e-3) << row.key;
    }
}

// Whatever bends or walks the rays, and also where there is no depth to be wrong about.
TEST(PictureErrors, OfMeshesAreThoseOfTheSearch)
{
    Bench bench("sample:bricks@64");
    bench.state.mesh = "sphere";
    bench.resources = *loadResources(bench.state, {}, bench.resources);
    const auto errorsOf = [&](const char* technique, Silhouettes silhouettes, float depth) {
        State state = bench.state;
        state.panes = {Pane{technique, {}}};
        state.parameters.silhouettes = silhouettes;
        state.parameters.depth = depth;
        state.parameters.minSteps = state.parameters.maxSteps = 4;
        return *pictureErrors(bench.renderer, state, bench.resources, 120, 90);
    };
    for (const Silhouettes silhouettes : {Silhouettes::Off, Silhouettes::Axes, Silhouettes::Quadric, Silhouettes::Prisms}) {
        const PictureErrors exact = errorsOf("cell-cone", silhouettes, 0.08f), coarse = errorsOf("relief", silhouettes, 0.08f);
        EXPECT_LT(exact.largest, 1e-4) << wordOf(silhouettes);
        EXPECT_EQ(exact.missed, 0.) << wordOf(silhouettes);
        EXPECT_GT(coarse.rmse, 0.01) << wordOf(silhouettes);
        EXPECT_GT(coarse.missed, 0.005) << wordOf(silhouettes);
        EXPECT_LT(coarse.missed, 0.5) << wordOf(silhouettes);
    }
    EXPECT_EQ(errorsOf("relief", Silhouettes::Off, 0.f).largest, 0.);
    EXPECT_EQ(errorsOf("cell-cone", Silhouettes::Off, 0.f).largest, 0.);
}

// A fine map seen at a grazing angle: the exact answer lies thousands of cells away.
TEST(PictureErrors, OfRaysOverThousandsOfCellsAreRight)
{
    Bench bench("hard:low@8");
    auto material = std::make_shared<Material>(*bench.resources.material);
    material->height = HeightField(1024, 1024, std::vector<float>(1 << 20, 0.05f));
    bench.resources.material = material;
    State view = bench.with("pyramid", 85.);
    view.parameters.depth = 0.5f; // down to 0.95 of it a ray crosses 5,560 cells
    EXPECT_LT(pictureErrors(bench.renderer, view, bench.resources, 24, 18)->largest, 1e-3);
}

// A shadow ray ends just above the point it is sent to; a search that looks on finds that point and darkens everything.
TEST(Shadows, OfExactTechniquesAreThoseOfManySteps)
{
    Bench bench("sample:cobblestones@128");
    const auto lit = [&](std::string technique) {
        State view = bench.with(technique.c_str(), 60.);
        view.parameters.shadows = true;
        view.parameters.shadowBias = 0.002f;
        view.parameters.minSteps = view.parameters.maxSteps = 512;
        view.parameters.refineSteps = 16;
        const auto shadow = drawPicture(bench.renderer, view, 0, bench.resources, "shadow", 80, 60, 1, true);
        double sum = 0.;
        for (int i = 0; i < 80 * 60; ++i)
            sum += double(shadow->value(i % 80, i / 80, 0)) / (80. * 60.);
        return sum;
    };
    const double wanted = lit("relief");
    EXPECT_GT(wanted, 0.3);
    EXPECT_LT(wanted, 0.97);
    for (const TechniqueRow& row : kTechniques)
        if (row.isExact && !row.file.empty()) {
            EXPECT_NEAR(lit(std::string(row.key)), wanted, 0.03) << row.key;
        }
}

// On level ground nothing stands in the light's way, however few halvings tell a ray that got through from one that did not.
TEST(Shadows, LevelGroundIsLit)
{
    Bench bench("hard:low@8");
    for (const TechniqueRow& row : kTechniques)
        for (const int halvings : {0, 4, 8}) {
            if (!row.searches || row.file.empty())
                continue;
            State view = bench.with(std::string(row.key).c_str(), 30.);
            view.parameters.shadows = true;
            view.parameters.refineSteps = halvings;
            const auto shadow = drawPicture(bench.renderer, view, 0, bench.resources, "shadow", 40, 30, 1, true);
            ASSERT_TRUE(shadow);
            EXPECT_GT(shadow->value(20, 15, 0), 0.5f) << row.key << ' ' << halvings;
        }
}

TEST(PictureErrors, NeedsAHeightMap)
{
    Bench bench("hard:low@8");
    Resources empty = bench.resources;
    empty.material = std::make_shared<const Material>();
    EXPECT_FALSE(pictureErrors(bench.renderer, bench.with("flat", 30.), empty, 8, 8));
}

TEST(FrameTimes, OnePositiveTimeAFrame)
{
    Bench bench("hard:bricks@64");
    const State view = bench.with("relief", 60.);
    const TimedFrame frames[] = {plainQuad(view), {view, "color"}};
    const auto times = frameTimes(bench.renderer, bench.resources, frames, 64, 48, {3});
    ASSERT_TRUE(times);
    ASSERT_EQ(times->size(), 2u);
    EXPECT_GT(times->front(), 0.);
    EXPECT_GT(times->back(), 0.);
    EXPECT_EQ(frames[0].state.panes.front().technique, "flat");
    EXPECT_EQ(timedView(bench.resources), "color");
    auto bare = std::make_shared<Material>(*bench.resources.material);
    bare->maps[std::size_t(MapKind::Color)] = nullptr;
    Resources withoutColor = bench.resources;
    withoutColor.material = bare;
    EXPECT_EQ(timedView(withoutColor), "depth") << "a driver leaves out a search that nothing shows";
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(frameTimes(bench.renderer, bench.resources, frames, 64, 48, {3}, {{}, stop.get_token()}));
}

TEST(FrameTimes, DrawNoMoreOftenThanTheyNeed)
{
    Bench bench("hard:bricks@64");
    const State relief = bench.with("relief", 60.);
    State finer = relief;
    finer.parameters.maxSteps = 64;
    const TimedFrame frames[] = {{relief, "color"}, {finer, "color"}, {bench.with("cone", 60.), "color"}};
    int drawn = 0;
    const Progress count{[&](float) { ++drawn; }, {}};
    ASSERT_TRUE(frameTimes(bench.renderer, bench.resources, frames, 64, 48, {50, 0.}, count));
    EXPECT_EQ(drawn, 2 + 3) << "each program is warmed up once, each frame timed once";
    drawn = 0;
    ASSERT_TRUE(frameTimes(bench.renderer, bench.resources, frames, 64, 48, {4}, count));
    EXPECT_EQ(drawn, 2 + 4 * 3);
}
