// What helps to decide: rays of a view, the front of what nothing beats, the least error, and shifts over the distance.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/decide/distance.h"
#include "core/analysis/decide/front.h"
#include "core/analysis/decide/view_rays.h"
#include "core/analysis/tune.h"
#include "core/image/samples/hard_cases.h"
#include "core/scene/picked_ray.h"
#include "core/scene/source.h"
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numbers>

using namespace relievo;

namespace {
struct Scene {
    State state;
    Resources resources;
};

Scene sceneOn(const char* mesh, float midlevel = 1.f)
{
    auto opened = *openSource("sample:bricks@64", State{});
    Scene scene{opened.state, {}};
    scene.state.mesh = mesh;
    scene.state.parameters.midlevel = midlevel;
    scene.resources = *loadResources(scene.state, opened.images, {});
    return scene;
}

// From straight above, the middle of the picture at `distance`.
Scene planeFrom(float distance, float pitch)
{
    Scene scene = sceneOn("plane");
    scene.state.camera.yaw = 0.f, scene.state.camera.pitch = pitch;
    scene.state.camera.distance = distance, scene.state.camera.target = glm::vec3(0.f);
    return scene;
}
} // namespace

TEST(PickedRays, AreThoseOfEachPixel)
{
    for (const char* mesh : {"sphere", "torus", "box"}) {
        Scene scene = sceneOn(mesh, 0.5f);
        scene.state.camera.distance = 0.8f; // some triangles are beside or behind the eye
        const glm::ivec2 grid(9, 7);
        const auto rays = pickedRays(scene.state, 0, scene.resources, grid, 1.3f);
        ASSERT_EQ(rays.size(), 63u);
        for (int y = 0; y < grid.y; ++y)
            for (int x = 0; x < grid.x; ++x) {
                const auto one = pickedRay(scene.state, 0, scene.resources, (glm::vec2(x, y) + 0.5f) / glm::vec2(grid), 1.3f);
                const auto& many = rays[std::size_t(y * grid.x + x)];
                ASSERT_EQ(one.has_value(), many.has_value()) << mesh << ' ' << x << ' ' << y;
                if (one) {
                    EXPECT_EQ(one->ray.uv, many->ray.uv) << mesh << ' ' << x << ' ' << y;
                    EXPECT_EQ(one->ray.duv, many->ray.duv);
                    EXPECT_EQ(one->distance, many->distance);
                }
            }
    }
}

TEST(ViewRays, KnowByHowManyPixelsAnErrorShifts)
{
    const Scene scene = planeFrom(2.f, 30.f);
    const ViewGrid grid{{1, 1}, 600, 1.f};
    const auto picked = pickedRay(scene.state, 0, scene.resources, {0.5f, 0.5f}, 1.f);
    ASSERT_TRUE(picked);
    EXPECT_NEAR(picked->distance, 2., 1e-4);
    EXPECT_NEAR(picked->ray.cosView, 0.5, 1e-4); // 60 degrees from the normal
    const RaySet set = viewRays(scene.state, 0, scene.resources, grid);
    ASSERT_EQ(set.rays.size(), 1u);
    const double depth = double(scene.state.parameters.depth); // of a tile of 1 m
    const double pixelsAMetre = 600. / (2. * 2. * std::tan(0.5 * double(scene.state.camera.fov) * std::numbers::pi / 180.));
    EXPECT_NEAR(set.pixels[0], depth * std::sqrt(0.75) * pixelsAMetre, 1e-3 * pixelsAMetre);
    EXPECT_NEAR(glm::length(set.rays[0].duv), depth * std::tan(std::numbers::pi / 3.), 1e-4);
}

TEST(ViewRays, BeginWhereWhiteLiesWhateverTheTechnique)
{
    Scene scene = sceneOn("sphere", 0.25f);
    const ViewGrid grid{{8, 8}, 200, 1.f};
    const RaySet relief = viewRays(scene.state, 0, scene.resources, grid);
    scene.state.panes.front().technique = "flat";
    const RaySet flat = viewRays(scene.state, 0, scene.resources, grid);
    ASSERT_GT(relief.rays.size(), 10u);
    ASSERT_EQ(relief.rays.size(), flat.rays.size());
    EXPECT_EQ(relief.rays.front().uv, flat.rays.front().uv);
    scene.state.camera.target = glm::vec3(0.f, 50.f, 0.f); // looks away
    scene.state.camera.distance = 1.f;
    EXPECT_TRUE(viewRays(scene.state, 0, scene.resources, grid).rays.empty());
}

TEST(ViewRays, FieldsAreReducedToASide)
{
    const HeightField field = findHardCase("waves")->make(48, 1);
    EXPECT_EQ(reducedTo(field, 48).identity(), field.identity());
    EXPECT_EQ(reducedTo(field, 20).width(), 12);
}

TEST(Front, HoldsWhatNothingBeats)
{
    const double nan = std::nan("");
    const std::vector<CostAndError> points = {{5., 1.}, {1., 9.}, {3., 2.}, {3., 2.}, {4., 2.}, {0.5, nan}, {9., 0.}, {3., 8.}};
    EXPECT_EQ(paretoFront(points), (std::vector<std::size_t>{1, 2, 0, 6}));
    EXPECT_TRUE(paretoFront({}).empty());
}

TEST(RaySweep, IsWhatASweepMakesOfBands)
{
    const HardCaseRow& row = *findHardCase("waves");
    SweepPlan plan;
    plan.settings = settingsOf(*findTechnique("relief"), Parameters(), std::array{8, 64});
    plan.fields = {{"waves", "Waves", row.make(48, 1), 0.08}};
    plan.rays = 200;
    const auto rows = *sweep(plan);
    std::vector<RaySet> sets;
    for (const AngleBand band : plan.bands)
        sets.push_back({bandRays(band, 0.08, 200, 1), std::vector<double>(200, 3.)});
    auto one = *RaySweep::create(plan.fields.front().heights, sets);
    const auto again = *one.measure(plan.settings[1], 1);
    ASSERT_EQ(again.size(), plan.bands.size());
    for (std::size_t band = 0; band < again.size(); ++band) {
        const SweepRow& same = rows[plan.bands.size() + band];
        EXPECT_EQ(again[band].errors.rmse, same.errors.rmse);
        EXPECT_EQ(again[band].errors.meanFetches, same.errors.meanFetches);
        EXPECT_NEAR(again[band].errors.rmsePixels, 3. * same.errors.rmse, 1e-12) << "all rays weigh the same here";
        EXPECT_EQ(same.errors.rmsePixels, 0.) << "nothing was told of pixels";
    }
}

TEST(Tune, TheLeastErrorWithinACost)
{
    const std::vector<Candidate> all = {{0, 1., 1, 0.5, 0.}, {1, 5., 9, 0.02, 0.3}, {2, 9., 12, 0.04, 0.}, {3, 20., 22, 0.001, 0.}};
    const auto chosen = [&](TuneBudget budget, ErrorOf errorOf = {}) {
        std::vector<Candidate> candidates = all;
        const auto best = chooseLeast(candidates, budget, errorOf);
        return *best ? int((*best)->setting) : -1;
    };
    EXPECT_EQ(chosen({}), 3);
    EXPECT_EQ(chosen({.maxFetches = 10.}), 1);
    EXPECT_EQ(chosen({.maxMissed = 0.1, .maxFetches = 10.}), 2);
    EXPECT_EQ(chosen({.maxFetches = 0.5}), -1);
    EXPECT_EQ(chosen({.maxFetches = 10.}, [](std::size_t setting) -> Expected<double> { return setting == 0 ? 0.1 : 0.2; }), 0);
}

TEST(Distance, ShiftsFallWithIt)
{
    const Lens lens{90., 1000.}; // at 1 m the picture is 2 m high
    EXPECT_NEAR(lens.pixels(0.01, 1.), 5., 1e-9);
    EXPECT_NEAR(lens.pixels(0.01, 10.), 0.5, 1e-9);
    EXPECT_NEAR(shiftInPixels(0.5, 0.02, 30., lens, 1.), 2.5, 1e-9);
    // Half way down everywhere.
    const HeightField ground(8, 8, std::vector<float>(64, 0.5f));
    const SearchSetting flat = plainSetting(*findTechnique("flat"), Parameters());
    const auto figures = *figuresByAngle(flat, ground, 1.);
    ASSERT_EQ(figures.size(), kDistanceAngles.size());
    for (const AngleFigures& at : figures) {
        EXPECT_NEAR(at.parallax, 0.5, 1e-6);
        EXPECT_NEAR(at.errors.rmse, 0.5, 1e-6) << "flat is off by all of it";
    }
    const double fade = distanceOfParallax(figures, 0.02, lens);
    EXPECT_NEAR(shiftInPixels(0.5, 0.02, 85., lens, fade), 1., 1e-6);
    EXPECT_NEAR(distanceOfErrors(figures, 0.02, lens), fade, 1e-6);
    EXPECT_NEAR(distanceOfParallax(*figuresByAngle(flat, ground, 0.5), 0.02, lens), 0., 1e-6) << "all of it lies on the mesh";
    const auto exact = *figuresByAngle(mostExactSetting(Parameters()), findHardCase("waves")->make(48, 1), 1.);
    EXPECT_LT(distanceOfErrors(exact, 0.02, lens), 0.01 * distanceOfParallax(exact, 0.02, lens));
}
