// Mutated projects, presets and copies of unsaved work: a sound State or an error, told in short and plain sentences.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/inputs.h"
#include "core/state/presets.h"
#include "core/state/state_json.h"
#include "core/state/techniques.h"
#include "core/state/views.h"
#include "tests/core/fuzz/mutations.h"
#include "tests/core/fuzz_rounds.h"
#include <algorithm>
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;

namespace {
State fullState()
{
    State state;
    state.name = "Wall \u00fc";
    for (std::size_t i = 0; i < state.slots.size(); ++i)
        state.slots[i] = {"/a/b/map" + std::to_string(i) + ".png", Channel(i % 5), i % 2 == 0};
    state.mesh = "/a/mesh/pot.glb";
    state.part = "lid";
    state.environment = "/c/sky.hdr";
    state.camera = {.yaw = 10.f, .pitch = 20.f, .distance = 2.f, .target = glm::vec3(1.f, 2.f, 3.f)};
    state.panes = {Pane{"bump"}, Pane{"cone", {{"depth", 0.2f}, {"shadows", false}}}, Pane{.technique = "pyramid", .view = "error"}};
    state.panes.back().camera.emplace().yaw = 12.f;
    return state;
}

std::vector<std::string> seeds()
{
    std::vector<std::string> texts = {toJson(fullState(), "/a/b"), toPresetJson(fullState()), toJson(State(), "/")};
    for (const PresetRow& row : kPresets)
        texts.emplace_back(row.json);
    return texts;
}

void expectSound(const State& state)
{
    for (const ParameterRow& row : kParameters)
        EXPECT_TRUE(inRange(row, get(state.parameters, row))) << row.key;
    EXPECT_TRUE(!state.panes.empty() && state.panes.size() <= kMaxPanes);
    for (std::size_t i = 0; i < state.panes.size(); ++i) {
        EXPECT_TRUE(findTechnique(state.panes[i].technique) && findView(state.panes[i].view));
        const Parameters effective = effectiveParameters(state, i);
        for (const ParameterRow& row : kParameters)
            EXPECT_TRUE(inRange(row, get(effective, row))) << row.key;
    }
}
} // namespace

TEST(StateFuzz, MutatedFilesAreSoundOrRefused)
{
    const std::vector<std::string> texts = seeds();
    for (FuzzLoop loop(20000); loop.next();) {
        const std::string& text = texts[below(loop.random, texts.size())];
        const std::string bytes = mutated(text, texts[below(loop.random, texts.size())], loop.random);
        const auto read = fromJson(State(), bytes, "/a/b", "fuzz");
        if (read) {
            expectSound(read->state);
            const auto again = fromJson(State(), toJson(read->state, "/a/b"), "/a/b", "again");
            ASSERT_TRUE(again);
            EXPECT_EQ(again->state.parameters, read->state.parameters);
            EXPECT_EQ(again->state.panes, read->state.panes);
            EXPECT_EQ(again->state.camera, read->state.camera);
            for (const Warning& warning : read->warnings)
                EXPECT_TRUE(isPlain(warning.text) && warning.text.size() < 2000) << warning.text.substr(0, 2000);
            (void)doubtsOf(read->state);
        } else {
            EXPECT_TRUE(isPlain(message(read.error())));
        }
        ASSERT_FALSE(HasFailure()) << "round " << loop.round << ": " << bytes;
    }
}
