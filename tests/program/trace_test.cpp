// relievo trace: what it cannot answer, or has to change, is told.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "tests/core/image/image_support.h"
#include "tests/program/run.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace relievo;
using namespace relievo::test;

TEST(Trace, CountsTheRaysThatWereGivenUp)
{
    TestFolder folder("unfinished");
    const auto needle = makeImage(64, 64, 1, PixelType::U8, [](int x, int y, int) { return x == 0 && y == 0 ? 1.f : 0.f; });
    ASSERT_TRUE(writeImage(folder / "needle_height.png", needle));
    ASSERT_TRUE(writeAtomically(folder / "rays.csv", std::string_view("u,v,du,dv\n0.5,0.5,200000,0\n0.5,0.5,0.1,0\n0.5,0.5,0,200000\n")));
    for (const std::string technique : {"reference", "pyramid", "cell-cone"}) {
        const ProgramRun run = runRelievo("trace " + (folder / "needle_height.png") + " --json --technique " + technique + " --rays "
            + (folder / "rays.csv") + " -o " + (folder / "hits.csv"));
        ASSERT_EQ(run.exitCode, 0) << run.err;
        const auto told = nlohmann::json::parse(run.out);
        EXPECT_EQ(told["unfinished"], 2);
        EXPECT_EQ(told["found"], 1);
        ASSERT_EQ(told["warnings"].size(), 1u) << run.out;
        EXPECT_EQ(told["warnings"][0]["code"], "rays-unfinished");
        EXPECT_NE(run.err.find("2 of 3 rays were not finished"), std::string::npos) << run.err;
        const std::string hits = *readText(folder / "hits.csv");
        EXPECT_NE(hits.find("\n-1,1,200000.5,0.5,"), std::string::npos) << hits;
        EXPECT_NE(hits.find("\n-1,1,0.5,200000.5,"), std::string::npos) << hits;
    }
}
