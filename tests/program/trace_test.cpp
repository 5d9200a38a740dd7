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

TEST(Trace, TellsOfRaysThatItCannotAnswerAsTheyAre)
{
    TestFolder folder("odd_rays");
    ASSERT_TRUE(writeAtomically(folder / "rays.csv",
        std::string_view(
            "u,v,du,dv,cosView\n0.5,0.5,0.1,0,1\nnan,0,0,0,1\n0,0,inf,0,1\n0,0,0,0,0\n0,0,0,0,-1\n0,0,0,0,1.5\n1e300,0,0,0,1\n")));
    const auto warningsOf = [&](const std::string& technique) {
        const ProgramRun run = runRelievo(
            "trace sample:bricks@16 --technique " + technique + " --rays " + (folder / "rays.csv") + " -o " + (folder / "hits.csv"));
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return run.err;
    };
    const std::string text = warningsOf("relief");
    EXPECT_NE(text.find("rays.csv:5: cosView lies outside (0, 1], and was brought into it (3 rays)"), std::string::npos) << text;
    EXPECT_NE(text.find("3 of 7 rays are not finite"), std::string::npos) << text; // 1e300 is no float
    EXPECT_NE(warningsOf("reference").find("2 of 7 rays are not finite"), std::string::npos);
    ASSERT_TRUE(writeAtomically(folder / "rays.csv", std::string_view("u,v,du,dv,cosView\n0.5,0.5,0.1,0,1\n0,0,0,0,1e-3\n")));
    EXPECT_EQ(warningsOf("relief"), "");
}

TEST(Inspect, TellsTheStepsOfTheRayThatTraceAnswers)
{
    TestFolder folder("inspect");
    ASSERT_TRUE(writeAtomically(folder / "rays.csv", std::string_view("u,v,du,dv\n0.31,0.42,0.21,-0.1\n")));
    for (const std::string technique : {"relief", "cone", "cell-cone", "parallax", "reference"}) {
        const std::string state = " sample:bricks@64 --set depth=0.1 --technique " + technique;
        const ProgramRun trace = runRelievo("trace" + state + " --rays " + (folder / "rays.csv") + " -o " + (folder / "hits.csv"));
        const ProgramRun run = runRelievo("inspect" + state + " --ray 0.31,0.42,0.21,-0.1 --light --json");
        ASSERT_EQ(trace.exitCode, 0) << trace.err;
        ASSERT_EQ(run.exitCode, 0) << run.err;
        const auto told = nlohmann::json::parse(run.out);
        int found = 0, fetches = 0;
        double t = 0, u = 0, v = 0;
        ASSERT_EQ(
            std::sscanf(readText(folder / "hits.csv")->c_str(), "hit,t,u,v,fetches\n%d,%lf,%lf,%lf,%d", &found, &t, &u, &v, &fetches), 5);
        EXPECT_EQ(told["hit"]["found"], found == 1) << technique;
        EXPECT_EQ(told["hit"]["t"], t) << technique;
        EXPECT_EQ(told["hit"]["fetches"], fetches) << technique;
        EXPECT_EQ(told["steps"].back()["to"], t) << technique;
        EXPECT_TRUE(told["light"].is_object()) << technique;
        const ProgramRun shown = runRelievo("inspect" + state + " --ray 0.31,0.42,0.21,-0.1");
        EXPECT_NE(shown.out.find(told["verdict"].get<std::string>()), std::string::npos) << shown.out;
    }
    for (const std::string ray : {"0.5,0.5,1", "0.5,0.5,1,a", "0,0,0,0,0", "nan,0,0,0"}) {
        const ProgramRun run = runRelievo("inspect sample:bricks@16 --ray " + ray);
        EXPECT_EQ(run.exitCode, 2) << ray;
        EXPECT_NE(run.err.find("Write four finite numbers"), std::string::npos) << run.err;
    }
}

TEST(Trace, FilesThatAreNotThereAreToldThoughTheyPlayNoPart)
{
    TestFolder folder("not_there");
    ASSERT_TRUE(writeAtomically(folder / "rays.csv", std::string_view("u,v,du,dv\n0.5,0.5,0.1,0\n")));
    ASSERT_TRUE(writeAtomically(folder / "p.relievo",
        std::string_view(R"({"relievo":1,"mesh":"none.obj","environment":"none.hdr","maps":{"height":{"file":"rock_height.png"}}})")));
    ASSERT_TRUE(writeImage(folder / "rock_height.png", noiseImage(16, 16, 1, PixelType::U16)));
    const std::string trace = "trace --technique relief --rays " + (folder / "rays.csv") + " -o " + (folder / "hits.csv ");
    const std::string bake = "bake --map normal -o " + (folder / "n.png ");
    for (const std::string& command : {trace, bake}) {
        for (const std::string option : {"--mesh ", "--environment "}) {
            const ProgramRun run = runRelievo(command + "sample:bricks@16 " + option + (folder / "none.obj"));
            EXPECT_EQ(run.exitCode, 1) << command << option;
            EXPECT_NE(run.err.find("none.obj"), std::string::npos) << run.err;
        }
        const ProgramRun run = runRelievo(command + (folder / "p.relievo"));
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_NE(run.err.find("none.obj"), std::string::npos) << run.err;
        EXPECT_NE(run.err.find("none.hdr"), std::string::npos) << run.err;
        const ProgramRun steps = runRelievo(command + "sample:bricks@16 --set minSteps=40 --set maxSteps=8");
        EXPECT_EQ(steps.exitCode, 0) << steps.err;
        EXPECT_NE(steps.err.find("Fewest steps (minSteps 40) are above most steps (maxSteps 8)"), std::string::npos) << steps.err;
    }
}
