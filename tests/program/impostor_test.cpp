// relievo impostor as users run it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "core/object/object_file.h"
#include "tests/program/run.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace relievo;
namespace fs = std::filesystem;

TEST(Impostor, WritesWhatItTells)
{
    const TestFolder folder("impostor");
    const ProgramRun run = runRelievo("impostor teapot -o " + (folder / "new/teapot") + " --size 32 --layers 2 --supersample 1 --json");
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const auto told = nlohmann::json::parse(run.out);
    EXPECT_EQ(told["files"].size(), 6u * 5u + 2u);
    for (const auto& file : told["files"])
        EXPECT_TRUE(fs::is_regular_file(file.get<std::string>())) << file;
    const auto read = readObject(told["object"].get<std::string>());
    ASSERT_TRUE(read);
    for (const AxisMap& map : read->object.axes) {
        EXPECT_EQ(map.width, 32);
        EXPECT_EQ(map.layers, 2);
    }
    const ProgramRun front = runRelievo("impostor box -o " + (folder / "front") + " --sides 1 --size 4");
    EXPECT_EQ(front.exitCode, 0) << front.err;
    EXPECT_EQ(front.out + front.err, "");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "front"), fs::directory_iterator()), 6);
}

// What it writes is drawn as it is, by the object's own techniques alone, and where the mesh is.
TEST(Impostor, WhatItWritesIsDrawn)
{
    const TestFolder folder("impostor_drawn");
    ASSERT_EQ(runRelievo("impostor torus -o " + (folder / "out") + " --size 48").exitCode, 0);
    const std::string object = folder / "out/Torus.object.json", size = " --size 64x48 -o " + (folder / "a.png");
    for (const std::string& source : {object, folder / "out/Torus.relievo", "sample:bricks --mesh " + object})
        for (const char* technique : {"", " --technique object-steps", " --technique object-sides --set crossDiscard=false"}) {
            const ProgramRun run = runRelievo("render " + source + technique + size);
            EXPECT_EQ(run.exitCode, 0) << source << technique << run.err;
        }
    EXPECT_EQ(runRelievo("render " + object + " --view error-mesh" + size).exitCode, 0);
    for (const std::string& odd : {object + " --technique relief", std::string("sample:bricks --technique object")}) {
        const ProgramRun run = runRelievo("render " + odd + size);
        EXPECT_EQ(run.exitCode, 2) << odd;
        EXPECT_NE(run.err.find("relief object"), std::string::npos) << run.err;
    }
    const ProgramRun view = runRelievo("render " + object + " --view overshoot" + size);
    EXPECT_EQ(view.exitCode, 1);
    EXPECT_NE(view.err.find("relief objects"), std::string::npos) << view.err;
    fs::rename(folder / "out", folder / "other"); // its paths go with it
    EXPECT_EQ(runRelievo("render " + (folder / "other/Torus.relievo") + size).exitCode, 0);
}

TEST(Impostor, WrongOptionsAreWrongUsage)
{
    const TestFolder folder("impostor_usage");
    for (const char* odd :
        {"--sides 3", "--layers 3", "--size 0", "--size 9000", "--size x", "--supersample 0", "--supersample 9", "--onto x"}) {
        const ProgramRun run = runRelievo("impostor box -o " + (folder / "out") + ' ' + odd);
        EXPECT_EQ(run.exitCode, 2) << odd << run.err;
        EXPECT_FALSE(fs::exists(folder / "out"));
    }
    EXPECT_EQ(runRelievo("impostor box").exitCode, 2);
    EXPECT_EQ(runRelievo("impostor -o " + (folder / "out")).exitCode, 2);
}

TEST(Impostor, BadMeshesAndFoldersAreToldInOneSentence)
{
    const TestFolder folder("impostor_bad");
    ASSERT_TRUE(writeAtomically(folder / "point.off", std::string_view("OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n")));
    ASSERT_TRUE(writeAtomically(folder / "text.obj", std::string_view("hello\n")));
    ASSERT_TRUE(writeAtomically(folder / "file", std::string_view("x")));
    for (const std::string& odd : {folder / "point.off", folder / "text.obj", folder / "none.obj"}) {
        const ProgramRun run = runRelievo("impostor " + odd + " -o " + (folder / "out"));
        EXPECT_EQ(run.exitCode, 1) << odd << run.err;
        EXPECT_EQ(run.err.find("relievo: error: "), run.err.rfind("relievo: ")) << run.err;
        EXPECT_FALSE(fs::exists(folder / "out")) << odd;
    }
    EXPECT_EQ(runRelievo("impostor box -o " + (folder / "file")).exitCode, 1);
    ASSERT_TRUE(writeAtomically(folder / "open.off", std::string_view("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")));
    const ProgramRun open = runRelievo("impostor " + (folder / "open.off") + " -o " + (folder / "open") + " --size 8 --json");
    ASSERT_EQ(open.exitCode, 0) << open.err;
    int told = 0;
    const auto document = nlohmann::json::parse(open.out);
    for (const auto& warning : document["warnings"])
        told += warning["code"] == "open-mesh";
    EXPECT_EQ(told, 1);
}

// The pictures that a mesh's materials read are not replaced, whatever they are called.
TEST(Impostor, NothingThatItReadsIsReplaced)
{
    const TestFolder folder("impostor_reads");
    ASSERT_EQ(runRelievo("impostor box -o " + (folder / "out") + " --size 4").exitCode, 0);
    const std::string painted = folder / "out/Box_PosX_Color.png";
    ASSERT_TRUE(fs::exists(painted));
    ASSERT_TRUE(writeAtomically(folder / "Box.mtl", std::string_view("newmtl paint\nmap_Kd out/Box_PosX_Color.png\n")));
    ASSERT_TRUE(writeAtomically(folder / "Box.obj",
        std::string_view("mtllib Box.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl paint\nf 1/1 3/3 2/2\n"
                         "f 1/1 2/2 4/3\nf 2/1 3/2 4/3\nf 3/1 1/2 4/3\n")));
    const auto before = readBytes(painted);
    const ProgramRun run = runRelievo("impostor " + (folder / "Box.obj") + " -o " + (folder / "out") + " --size 4");
    EXPECT_EQ(run.exitCode, 1) << run.err;
    EXPECT_NE(run.err.find("is one of those that are read here"), std::string::npos) << run.err;
    EXPECT_EQ(*before, *readBytes(painted));
}
