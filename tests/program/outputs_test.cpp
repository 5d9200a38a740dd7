// No command writes over what it reads, under whatever name the file is given.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "tests/core/image/image_support.h"
#include "tests/program/run.h"
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;
namespace fs = std::filesystem;

namespace {
// Runs a command, which must be refused and leave `file` as it is.
void expectKept(const std::string& command, const std::string& file)
{
    const auto before = readBytes(file);
    ASSERT_TRUE(before);
    const ProgramRun run = runRelievo(command);
    EXPECT_EQ(run.exitCode, 1) << command << '\n' << run.err;
    EXPECT_NE(run.err.find("is one of those that are read here"), std::string::npos) << command << '\n' << run.err;
    EXPECT_EQ(*before, *readBytes(file)) << command;
}

struct Inputs {
    TestFolder folder{"outputs"};
    std::string height = folder / "rock_height.png", set = folder.path.string() + ' ';
    Inputs()
    {
        EXPECT_TRUE(writeImage(height, noiseImage(16, 16, 1, PixelType::U16)));
        EXPECT_TRUE(writeAtomically(folder / "rays.csv", std::string_view("u,v,du,dv\n0.5,0.5,0.1,0\n")));
        EXPECT_TRUE(writeAtomically(
            folder / "p.relievo", std::string_view(R"({"relievo":1,"mesh":"plane","maps":{"height":{"file":"rock_height.png"}}})")));
        EXPECT_TRUE(writeAtomically(folder / "fine.json", std::string_view(R"({"relievo":1})")));
    }
};
} // namespace

TEST(Outputs, NoCommandReplacesWhatItReads)
{
    const Inputs in;
    const auto& [folder, height, set] = in;
    fs::create_symlink(height, folder.path / "link.png");
    fs::create_hard_link(height, folder.path / "twin.png");
    const std::string around = "../" + folder.path.filename().string() + "/rock_height.png";
    for (const std::string& name : std::vector<std::string>{"rock_height.png", "link.png", "twin.png", around}) {
        expectKept("bake " + height + " --map normal -o " + (folder / name), height);
        expectKept("render " + height + " --size 8x8 -o " + (folder / name), height);
        expectKept("compare " + height + " --techniques flat -o " + (folder / name), height);
    }
    EXPECT_TRUE(fs::is_symlink(folder.path / "link.png"));
    expectKept("compare " + height + " --techniques flat -o " + (folder / "x.png") + " --csv " + height, height);
    const std::string project = folder / "p.relievo", rays = folder / "rays.csv", preset = folder / "fine.json";
    expectKept("trace " + height + " --technique relief --rays " + rays + " -o " + rays, rays);
    expectKept("trace " + height + " --technique relief --rays " + rays + " -o " + height, height);
    expectKept("trace " + project + " --technique relief --rays " + rays + " -o " + project, project);
    expectKept("tune " + project + " --max-error 1 --rays 10 -o " + project, project);
    expectKept("report " + project + " --fast --preset " + preset + " -o " + preset, preset);
    expectKept("export " + project + " --preset " + preset + " --target preset -o " + preset, preset);
}

TEST(Outputs, TheFileOfAPictureInsideItIsRead)
{
    const Inputs in;
    const std::string glb = in.folder / "rock.glb", project = in.folder / "embedded.relievo";
    ASSERT_EQ(runRelievo("export " + in.height + " --mesh box --target gltf -o " + glb).exitCode, 0);
    ASSERT_TRUE(writeAtomically(
        project, std::string_view(R"({"relievo":1,"maps":{"normal":{"file":"rock.glb#0"}},"panes":[{"technique":"bump"}]})")));
    expectKept("export " + project + " --target gltf -o " + glb, glb);
    fs::create_symlink(glb, in.folder.path / "link.glb");
    expectKept("export " + project + " --target gltf -o " + (in.folder / "link.glb"), glb);
    EXPECT_TRUE(fs::is_symlink(in.folder.path / "link.glb"));
    EXPECT_EQ(runRelievo("export " + project + " --target gltf -o " + (in.folder / "other.glb")).exitCode, 0);
}

TEST(Outputs, ThePicturesOfTheMeshAreRead)
{
    const Inputs in;
    const std::string picture = in.folder / "paint.png";
    ASSERT_TRUE(writeImage(picture, noiseImage(16, 16, 3, PixelType::U8)));
    ASSERT_TRUE(writeAtomically(in.folder / "m.mtl", std::string_view("newmtl a\nmap_Kd paint.png\n")));
    ASSERT_TRUE(writeAtomically(in.folder / "m.obj",
        std::string_view("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n")));
    expectKept("render sample:bricks@16 --mesh " + (in.folder / "m.obj") + " --size 8x8 -o " + picture, picture);
}

TEST(Outputs, NoOutputReplacesTheOther)
{
    const Inputs in;
    const std::string out = in.folder / "x.png";
    const ProgramRun run = runRelievo("compare " + in.height + " --techniques flat -o " + out + " --csv " + out);
    EXPECT_EQ(run.exitCode, 2) << run.err;
    EXPECT_FALSE(fs::exists(out));
}

TEST(Outputs, OtherFilesAreReplaced)
{
    const Inputs in;
    const std::string out = in.folder.path.parent_path() / ("relievo_out_" + std::to_string(getpid()) + ".png");
    for (int round = 0; round < 2; ++round)
        EXPECT_EQ(runRelievo("bake " + in.height + " --map normal -o " + out).exitCode, 0);
    fs::remove(out);
}
