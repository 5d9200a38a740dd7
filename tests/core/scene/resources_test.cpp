// The data behind a State: acceleration maps with one owner, and exact answers that know what they answer.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/exact_distances.h"
#include "core/scene/source.h"
#include <gtest/gtest.h>

using namespace relievo;

namespace {
State stateWith(const char* technique)
{
    State state = openSource("sample:bricks@32", State())->state;
    state.panes = {Pane{technique}};
    return state;
}
} // namespace

TEST(AccelerationMaps, OneQuestionAndWhyNotYet)
{
    const State state = stateWith("cell-cone");
    Resources resources = *loadResources(state, {}, {});
    AccelerationMaps& maps = resources.accelerationMaps;
    const Material& material = *resources.material;
    const Parameters parameters = state.parameters;
    const auto made = maps.of(knownTechnique("cell-cone"), parameters, material);
    ASSERT_TRUE(made);
    EXPECT_TRUE(*made);
    EXPECT_EQ(*maps.of(knownTechnique("relief"), parameters, material), nullptr) << "needs none";
    EXPECT_EQ(maps.of(knownTechnique("pyramid"), parameters, material).error().code, ErrorCode::NotReady);
    Parameters clamped = parameters;
    clamped.wrap = Wrap::Clamp;
    EXPECT_EQ(maps.of(knownTechnique("cell-cone"), clamped, material).error().code, ErrorCode::NotReady);
    Parameters finest = parameters;
    finest.heightMips = false;
    EXPECT_EQ(*maps.of(knownTechnique("cell-cone"), finest, material), *made) << "one with all levels serves";
    ASSERT_TRUE(maps.make(knownTechnique("pyramid"), finest, material));
    EXPECT_EQ(maps.of(knownTechnique("pyramid"), parameters, material).error().code, ErrorCode::NotReady) << "fewer levels than wanted";
    Material other = material;
    other.height = HeightField(2, 2, {0.f, 1.f, 1.f, 0.f});
    EXPECT_EQ(maps.of(knownTechnique("cell-cone"), parameters, other).error().code, ErrorCode::NotReady) << "of other heights";
    other.height.reset();
    EXPECT_EQ(maps.of(knownTechnique("cell-cone"), parameters, other).error().code, ErrorCode::Refused);
}

TEST(AccelerationMaps, HoldWhatPanesSearchWith)
{
    State state = stateWith("cell-cone");
    state.panes = {Pane{"cell-cone"}, Pane{"cell-cone", {{"wrap", 1}}}, Pane{"pyramid"}, Pane{"relief"}};
    Resources resources = *loadResources(state, {}, {});
    const Material& material = *resources.material;
    EXPECT_EQ(resources.accelerationMaps.count(), 3u);
    EXPECT_TRUE(resources.accelerationMaps.missingFor(state, material).empty());
    const AccelerationMap* first = resources.accelerationMaps.of(knownTechnique("cell-cone"), state.parameters, material)->get();
    state.panes = {Pane{"cone"}, Pane{"cell-cone"}};
    EXPECT_EQ(resources.accelerationMaps.missingFor(state, material), std::vector<std::string_view>{"cone"});
    resources = *loadResources(state, {}, resources);
    EXPECT_EQ(resources.accelerationMaps.count(), 2u);
    EXPECT_TRUE(resources.accelerationMaps.holds(first)) << "what is there is not made again";
}

TEST(AccelerationMaps, HorizonsAreMadeForTheLightThatReadsThem)
{
    State state = stateWith("relief");
    Parameters& parameters = state.parameters;
    const auto horizons = [&](const Resources& from) {
        return from.accelerationMaps.horizonsOf(*findTechnique(state.panes.front().technique), parameters, *from.material);
    };
    Resources resources = *loadResources(state, {}, {});
    EXPECT_EQ(*horizons(resources), nullptr) << "nothing reads them";
    EXPECT_EQ(resources.accelerationMaps.count(), 0u);
    parameters.shadowSearch = ShadowSearch::Horizon;
    EXPECT_EQ(horizons(resources).error().code, ErrorCode::NotReady);
    EXPECT_EQ(resources.accelerationMaps.missingFor(state, *resources.material), std::vector<std::string_view>{"horizon-slopes-16"});
    resources = *loadResources(state, {}, resources);
    ASSERT_TRUE(horizons(resources));
    EXPECT_EQ((*horizons(resources))->slices, 4);
    const auto made = *horizons(resources);
    parameters.depth *= 2.f, parameters.heightMips = false;
    EXPECT_EQ(*horizons(resources), made) << "it holds for any depth";
    parameters.shadows = false;
    EXPECT_EQ(*horizons(resources), nullptr) << "no light asks for shadows";
    parameters.ambientRelief = AmbientRelief::Occlusion, parameters.horizonAzimuths = HorizonAzimuths::Eight;
    state.panes = {Pane{"cell-cone"}};
    resources = *loadResources(state, {}, resources);
    ASSERT_TRUE(horizons(resources));
    EXPECT_EQ((*horizons(resources))->slices, 2);
    EXPECT_EQ(resources.accelerationMaps.count(), 2u) << "and the technique's own";
    EXPECT_TRUE(resources.accelerationMaps.of(knownTechnique("cell-cone"), parameters, *resources.material));
    for (const char* key : {"flat", "as-bevy"}) {
        state.panes = {Pane{key}};
        EXPECT_EQ(*horizons(resources), nullptr) << key;
    }
}

// The exact answer depends on the parameters whose rows say so, and on no other.
TEST(ExactQuestion, ChangesWithWhatMovesTheSurface)
{
    const State state = stateWith("relief");
    const Resources resources = *loadResources(state, {}, {});
    const ExactQuestion question = exactQuestion(state, 0, resources, 40, 30);
    for (const ParameterRow& row : kParameters) {
        State changed = state;
        const Value value = get(state.parameters, row);
        if (const float* number = std::get_if<float>(&value))
            set(changed.parameters, row, *number == row.max ? row.min : row.max);
        else if (const int* whole = std::get_if<int>(&value))
            set(changed.parameters, row, *whole == int(row.max) ? int(row.min) : int(row.max));
        else if (const bool* on = std::get_if<bool>(&value))
            set(changed.parameters, row, !*on);
        else
            set(changed.parameters, row, Value(glm::vec3(row.min)));
        EXPECT_EQ(exactQuestion(changed, 0, resources, 40, 30) != question, row.affects.contains(Affects::ExactAnswer)) << row.key;
    }
    State moved = state;
    moved.camera.yaw += 1.f;
    EXPECT_NE(exactQuestion(moved, 0, resources, 40, 30), question);
    EXPECT_NE(exactQuestion(state, 0, resources, 30, 40), question);
    State other = state;
    setView(other, "error");
    other.panes[0].technique = "bump";
    EXPECT_EQ(exactQuestion(other, 0, resources, 40, 30), question);
}
