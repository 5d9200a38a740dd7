// What in a State can hardly be meant is told.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/inputs.h"
#include "tests/core/image/image_support.h"
#include <gtest/gtest.h>

using namespace relievo;
using test::tells;

TEST(Doubts, MissingFilesAreNamed)
{
    const test::TemporaryFolder folder;
    State state;
    EXPECT_TRUE(doubtsOf(state).empty());
    state.mesh = (folder / "none.obj").string();
    state.environment = (folder / "none.hdr").string();
    const Warnings doubts = doubtsOf(state);
    ASSERT_EQ(doubts.size(), 2u);
    EXPECT_TRUE(tells(doubts, "mesh-missing") && tells(doubts, "environment-missing"));
    EXPECT_NE(doubts[0].text.find("none.obj"), std::string::npos);
    test::writeAll(state.mesh, "v 0 0 0\n");
    test::writeAll(state.environment, "x");
    EXPECT_TRUE(doubtsOf(state).empty());
}

TEST(Doubts, StepsTheWrongWayRoundInAnyPane)
{
    State state;
    state.parameters.minSteps = state.parameters.maxSteps = 16;
    EXPECT_TRUE(doubtsOf(state).empty());
    state.panes.resize(2, state.panes.front());
    state.panes[1].overrides["maxSteps"] = 8;
    EXPECT_TRUE(tells(doubtsOf(state), "steps-reversed"));
    state.panes[0].overrides["maxSteps"] = 8;
    EXPECT_EQ(doubtsOf(state).size(), 1u); // once for both
}
