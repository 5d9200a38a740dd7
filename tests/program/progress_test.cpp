// Progress on the command line: one for a command, which never runs backwards and ends once.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "tests/program/run.h"
#include <charconv>
#include <gtest/gtest.h>
#include <vector>

namespace {
// The numbers before " %" in what a command wrote to stderr.
std::vector<int> percents(const std::string& text)
{
    std::vector<int> found;
    for (std::size_t end = text.find(" %"); end != text.npos; end = text.find(" %", end + 1)) {
        std::size_t begin = end;
        while (begin > 0 && text[begin - 1] >= '0' && text[begin - 1] <= '9')
            --begin;
        int percent = -1;
        std::from_chars(text.data() + begin, text.data() + end, percent);
        found.push_back(percent);
    }
    return found;
}
} // namespace

TEST(Progress, GoesFromNothingToAllOnceInEveryCommand)
{
    TestFolder folder("progress");
    ASSERT_TRUE(relievo::writeAtomically(folder / "rays.csv", std::string_view("u,v,du,dv\n0.1,0.2,0.3,0.1\n0.5,0.5,0,0\n")));
    const std::string set = "sample:bricks@64 ";
    for (const std::string& command : {"render " + set + "--size 32x24 -o " + folder / "a.png",
             "render " + set + "--mesh sphere --views shaded,error,depth --size 32x24 -o " + folder / "a.exr",
             "trace " + set + "--technique cone --rays " + folder / "rays.csv" + " -o " + folder / "hits.csv",
             "bake " + set + "--map cone -o " + folder / "cone.png", "export " + set + "--target textures -o " + folder / "out",
             "export " + set + "--target gltf -o " + folder / "x.glb",
             "compare " + set + "--techniques relief,bump -o " + folder / "sheet.png",
             "report " + set + "--techniques relief --no-pictures --rays 50 -o " + folder / "r.json",
             "tune " + set + "--max-error 0.1 --techniques relief --rays 50", "impostor sphere --size 32 -o " + folder / "sphere"}) {
        const ProgramRun run = runRelievo(command + " --progress");
        ASSERT_EQ(run.exitCode, 0) << command << run.err;
        const std::vector<int> told = percents(run.err);
        ASSERT_FALSE(told.empty()) << command;
        for (std::size_t i = 1; i < told.size(); ++i)
            EXPECT_GT(told[i], told[i - 1]) << command;
        EXPECT_EQ(told.back(), 100) << command;
    }
}
