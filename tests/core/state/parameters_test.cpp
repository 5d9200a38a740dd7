// Parameters: the table's promises, text and ranges.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/maps/maps.h"
#include "core/state/presets.h"
#include "core/state/state.h"
#include "core/state/techniques.h"
#include "core/state/views.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <set>
#include <sstream>

using namespace relievo;

namespace {
template <class Table, class Key> bool keysAreUnique(const Table& table, Key key)
{
    std::set<std::string_view> seen;
    for (const auto& row : table)
        if ((row.*key).empty() || !seen.insert(row.*key).second)
            return false;
    return true;
}
} // namespace

TEST(Tables, KeysAreUnique)
{
    EXPECT_TRUE(keysAreUnique(kParameters, &ParameterRow::key));
    EXPECT_TRUE(keysAreUnique(kTechniques, &TechniqueRow::key));
    EXPECT_TRUE(keysAreUnique(kViews, &ViewRow::key));
    EXPECT_TRUE(keysAreUnique(kMapKinds, &MapKindRow::key));
    EXPECT_TRUE(keysAreUnique(kBakedMaps, &BakedMapRow::key));
    EXPECT_TRUE(keysAreUnique(kExports, &ExportRow::key));
    EXPECT_TRUE(keysAreUnique(kPresets, &PresetRow::key));
}

TEST(Tables, MapKindsStandInOrder)
{
    for (std::size_t i = 0; i < kMapKindCount; ++i)
        EXPECT_EQ(std::size_t(kMapKinds[i].kind), i);
}

TEST(Tables, TechniquesListParametersThatAreShownByThem)
{
    for (const ParameterRow& row : kParameters) {
        bool listed = false;
        const auto list = [&](const TechniqueRow& technique) { listed = listed || technique.parameters.contains(row); };
        std::ranges::for_each(kTechniques, list);
        std::ranges::for_each(kObjectTechniques, list);
        EXPECT_EQ(listed, row.shown.byTechnique) << row.key;
        if (row.affects.contains(Affects::Search)) {
            EXPECT_TRUE(listed) << row.key;
        }
    }
}

TEST(Parameters, ConditionsOfShownNameSwitchesAndOptions)
{
    for (const ParameterRow& row : kParameters) {
        EXPECT_TRUE(row.shown.when || !row.shown.orWhen) << row.key;
        for (const auto& condition : {row.shown.when, row.shown.orWhen}) {
            if (!condition)
                continue;
            const auto other = std::ranges::find(kParameters, condition->member, &ParameterRow::member);
            ASSERT_NE(other, kParameters.end()) << row.key;
            const int options = kindOf(*other) == ValueKind::Switch ? 2 : optionCount(*other);
            EXPECT_GT(condition->values, 0u) << row.key;
            EXPECT_LT(condition->values, (1u << options) - 1u) << row.key << ": it always holds, or names what is no option";
        }
    }
}

TEST(Choices, WordsAreReadBackAndDiffer)
{
    for (const ParameterRow& row : kParameters) {
        EXPECT_EQ(optionCount(row) > 0, kindOf(row) == ValueKind::Choice) << row.key;
        for (int i = 0; i < optionCount(row); ++i)
            EXPECT_EQ(findOption(row, option(row, i)), i) << row.key;
        EXPECT_EQ(option(row, optionCount(row)), "") << row.key;
        EXPECT_EQ(option(row, -1), "") << row.key;
    }
    static_assert(kChoices<Silhouettes> == 4 && wordOf(Silhouettes::Prisms) == "prisms");
    static_assert(choiceOf<Wrap>("clamp") == Wrap::Clamp && !choiceOf<Wrap>("mirror"));
}

TEST(Parameters, OnlyAffectingKeepsThoseAlone)
{
    Parameters all;
    all.depth = 0.3f, all.time = 2.f, all.tint = glm::vec3(0.5f), all.wrap = Wrap::Clamp, all.exposure = 1.f;
    Parameters expected;
    expected.depth = 0.3f, expected.time = 2.f, expected.wrap = Wrap::Clamp;
    EXPECT_EQ(onlyAffecting(Affects::ExactAnswer, all), expected);
    Parameters moment;
    moment.time = 2.f;
    EXPECT_EQ(onlyAffecting(Affects::Pose, all), moment);
}

TEST(Parameters, EveryValueReadsBackFromItsText)
{
    std::mt19937 random(7);
    for (const ParameterRow& row : kParameters)
        for (int i = 0; i < 200; ++i) {
            std::uniform_real_distribution<float> spread(row.min, row.max);
            const Value samples[] = {spread(random), int(spread(random)), spread(random) > 0.5f,
                glm::vec3(spread(random), spread(random), spread(random)), int(spread(random))};
            const Value& value = samples[std::size_t(kindOf(row))];
            const auto back = parseValue(row, toText(row, value));
            ASSERT_TRUE(back) << row.key << ' ' << toText(row, value);
            EXPECT_EQ(*back, value) << row.key;
        }
}

TEST(Parameters, TextThatIsNoValueIsRefused)
{
    const ParameterRow& depth = *findParameter("depth");
    for (const char* text : {"", "x", "0.1x", "0,1", "1 2", "--1"})
        EXPECT_FALSE(parseValue(depth, text)) << text;
    EXPECT_FALSE(parseValue(*findParameter("wrap"), "mirror"));
    EXPECT_FALSE(parseValue(*findParameter("shadows"), "maybe"));
    EXPECT_FALSE(parseValue(*findParameter("tint"), "1,2"));
    EXPECT_EQ(*parseValue(*findParameter("tint"), "#ff0080"), Value(glm::vec3(1.f, 0.f, 128.f / 255.f)));
}

TEST(Parameters, ClampingBringsNaNIntoRange)
{
    const ParameterRow& depth = *findParameter("depth");
    EXPECT_EQ(clamped(depth, NAN), Value(0.f));
    EXPECT_EQ(clamped(depth, 7.f), Value(1.5f));
    EXPECT_FALSE(inRange(depth, NAN));
    EXPECT_TRUE(inRange(depth, 0.5f));
    EXPECT_EQ(clamped(*findParameter("minSteps"), 0), Value(1));
}

TEST(State, SetParameterTellsKeyAndRange)
{
    State state;
    EXPECT_TRUE(setParameter(state, "depth=0.25"));
    EXPECT_EQ(state.parameters.depth, 0.25f);
    const State before = state;
    for (const char* wrong : {"depth=2", "depth=nan", "depth", "deep=1", "shading=toon"}) {
        const auto done = setParameter(state, wrong);
        ASSERT_FALSE(done) << wrong;
        EXPECT_NE(done.error().where.find("--set"), std::string::npos);
        EXPECT_FALSE(done.error().hint.empty());
    }
    EXPECT_EQ(state, before);
}

TEST(State, CameraTextReadsBack)
{
    Camera camera;
    ASSERT_TRUE(setCamera(camera, "yaw=12.5,pitch=-89,distance=2.25,target=1:-2:0.1,fov=50,fill=0.87"));
    Camera other;
    ASSERT_TRUE(setCamera(other, toText(camera)));
    EXPECT_EQ(other, camera);
    for (const char* wrong : {"yaw", "yaw=x", "pitch=91", "fov=0", "distance=0", "target=1:2", "roll=3", "yaw=inf", "fill=1.2", "fill=-1"})
        EXPECT_FALSE(setCamera(camera, wrong)) << wrong;
    EXPECT_EQ(other, camera);
}

TEST(State, OverridesChangeOnePane)
{
    State state;
    state.panes = {Pane{"relief", {}}, Pane{"relief", {{"maxSteps", 128}}}};
    EXPECT_EQ(effectiveParameters(state, 0).maxSteps, 32);
    EXPECT_EQ(effectiveParameters(state, 1).maxSteps, 128);
}

TEST(State, WhatIsSetNowWinsOverAPanesOwnValue)
{
    State state;
    state.panes = {Pane{"relief", {{"depth", 0.05f}}}};
    ASSERT_TRUE(setParameter(state, "depth=0.3"));
    EXPECT_EQ(effectiveParameters(state, 0).depth, 0.3f);
}

TEST(State, PhysicalDepthIsOneNumber)
{
    Parameters p;
    p.depth = 0.1f, p.tiling = 4.f;
    EXPECT_FLOAT_EQ(physicalDepth(p, 2.f), 0.05f);
    p.metresPerUV = 3.f; // set by hand wins
    EXPECT_FLOAT_EQ(physicalDepth(p, 2.f), 0.075f);
    p.metresPerUV = 0.f;
    EXPECT_GT(physicalDepth(p, 0.f), 0.f); // a mesh without UV area
}
