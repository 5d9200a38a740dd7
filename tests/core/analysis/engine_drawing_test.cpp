// How much of the depth an engine draws, against cases that are known by hand.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/engine_drawing.h"
#include "core/analysis/sweep.h"
#include "core/image/samples/hard_cases.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace relievo;

namespace {

HeightField flatAt(float height)
{
    return {4, 4, std::vector<float>(16, height), Wrap::Repeat, 32};
}

EngineDrawing drawn(std::string_view key, const HeightField& field, const Parameters& parameters = {}, double angle = kEngineAngle)
{
    const auto drawing = drawnBy(*findTechnique(key), parameters, field, angle);
    EXPECT_TRUE(drawing) << key;
    return *drawing;
}

} // namespace

// Of one height h Godot draws the depth 1 - h times the cosine.
TEST(EngineDrawing, GodotDrawsTheCosineOfTheDepth)
{
    for (const char* key : {"as-godot4", "as-godot4-simple", "as-godot3"})
        for (const double angle : {30., 60., 70., 80.}) {
            const double cosine = std::cos(angle * std::numbers::pi / 180.);
            const EngineDrawing drawing = drawn(key, flatAt(0.75f), {}, angle);
            EXPECT_NEAR(drawing.share, cosine, 1e-5) << key << angle;
            EXPECT_NEAR(drawing.meanError, 0.25 * (1. - cosine), 1e-5) << key << angle;
            EXPECT_EQ(drawing.raised, 0.);
        }
    EXPECT_EQ(sentence(*findTechnique("as-godot4"), drawn("as-godot4", flatAt(0.75f))),
        "Godot 4 will draw 66 % less depth at 70 degrees; mean error 0.16 of the depth");
}

TEST(EngineDrawing, OthersDrawAllOfOneHeight)
{
    for (const char* key : {"as-unreal", "as-o3de", "as-bevy", "as-unity-hdrp", "cell-cone"}) {
        const EngineDrawing drawing = drawn(key, flatAt(0.4f));
        EXPECT_NEAR(drawing.share, 1., 1e-5) << key;
        EXPECT_NEAR(drawing.meanError, 0., 1e-5) << key;
    }
    EXPECT_EQ(sentence(*findTechnique("as-bevy"), drawn("as-bevy", flatAt(0.4f))),
        "Bevy will draw the full depth at 70 degrees; mean error 0 of the depth");
    EXPECT_EQ(drawn("as-godot4", flatAt(1.f)).share, 1.) << "there is no depth to draw";
}

// Mid-grey lies on Unity's mesh: what is drawn is counted from there, and lies where the midlevel does not have it.
TEST(EngineDrawing, UnityDrawsFromMidGrey)
{
    const double cosine = std::cos(70. * std::numbers::pi / 180.), share = cosine / (cosine + 0.42);
    Parameters parameters;
    EngineDrawing drawing = drawn("as-unity-urp", flatAt(0.9f), parameters);
    EXPECT_NEAR(drawing.share, share, 1e-5);
    EXPECT_NEAR(drawing.meanError, 0.4 * (1. - share), 1e-5);
    EXPECT_EQ(drawing.raised, 0.5);
    EXPECT_EQ(sentence(*findTechnique("as-unity-urp"), drawing),
        "Unity URP will draw 55 % less depth at 70 degrees; mean error 0.22 of the depth; all of it 0.50 of the depth too high");
    parameters.midlevel = 0.5f;
    EXPECT_EQ(drawn("as-unity-urp", flatAt(0.9f), parameters).raised, 0.);
    EXPECT_EQ(drawn("as-godot4", flatAt(0.9f), parameters).raised, -0.5) << "sunk";
    EXPECT_EQ(drawn("as-unreal", flatAt(0.9f), parameters).raised, 0.) << "its Reference Plane is the midlevel";
    parameters.depth = 0.16f; // twice what Unity can hold
    EXPECT_NEAR(drawn("as-unity-urp", flatAt(0.9f), parameters).share, 0.5 * share, 1e-5);
}

TEST(EngineDrawing, GrowsWorseWithTheAngleAndIsTheSameAgain)
{
    const HeightField field = findHardCase("bricks")->make(128, 1);
    for (const TechniqueRow& row : kTechniques)
        if (row.isEngine()) {
            const EngineDrawing low = drawn(row.key, field, {}, 30.), high = drawn(row.key, field, {}, 80.);
            EXPECT_GT(low.meanError, 0.) << row.key;
            EXPECT_TRUE(high.share > 0.1 && high.share < 1.5) << row.key << high.share; // more than all: rays that pass through a wall
            EXPECT_EQ(drawn(row.key, field, {}, 80.).meanError, high.meanError) << row.key;
        }
    EXPECT_GT(drawn("as-godot4", field, {}, 80.).meanError, drawn("as-godot4", field, {}, 30.).meanError);
    EXPECT_NEAR(drawn("cell-cone", field, {}, 80.).meanError, 0., 1e-4);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(drawnBy(*findTechnique("as-godot4"), {}, field, 70., Progress{{}, stop.get_token()}));
}

// A sweep compares with relief whose mid-grey lies on the mesh, too: on one height nothing but the share is missing.
TEST(EngineDrawing, SweepsCountFromTheEnginesZero)
{
    SweepPlan plan;
    plan.settings = {plainSetting(*findTechnique("as-unity-urp"), Parameters())};
    plan.fields = {{"flat", "Flat", flatAt(0.5f), 0.05}};
    plan.rays = 50;
    const auto rows = sweep(plan);
    ASSERT_TRUE(rows);
    for (const SweepRow& row : *rows) {
        EXPECT_NEAR(row.errors.largest, 0., 1e-5);
        EXPECT_NEAR(row.errors.largestTexels, 0., 1e-2);
    }
}
