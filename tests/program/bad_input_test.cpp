// Bad input and bad places for output, given to the command line: one sentence each, nothing lost, no litter.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "tests/core/image/image_support.h"
#include "tests/program/run.h"
#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

using namespace relievo;
using namespace relievo::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string kSource = "sample:bricks@64 ";
const std::string kSmall = " --size 32x24 --samples 1 ";

void write(const std::string& file, const Image& image)
{
    const auto written = writeImage(file, image);
    ASSERT_TRUE(written) << message(written.error());
}

// Exit code 1 and one sentence that names `named`.
void expectRefused(const ProgramRun& run, const std::string& named)
{
    EXPECT_EQ(run.exitCode, 1) << run.err;
    const std::size_t start = run.err.rfind("relievo: error: ");
    ASSERT_NE(start, std::string::npos) << run.err;
    EXPECT_NE(run.err.find(named, start), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin() + std::ptrdiff_t(start), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.err.find("internal fault"), std::string::npos) << run.err;
}

bool tellsCode(const std::string& infoJson, const std::string& code)
{
    const json found = json::parse(infoJson, nullptr, false);
    return found.is_object() && std::ranges::any_of(found["warnings"], [&](const json& warning) { return warning["code"] == code; });
}

std::vector<std::string> namesIn(const fs::path& folder)
{
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

} // namespace

TEST(BadInput, OneTexelAndOneRow)
{
    TestFolder folder("tiny");
    ASSERT_TRUE(writeAtomically(folder / "rays.csv", std::string_view("u,v,du,dv\n0.5,0.5,0.1,0\n0,0,3,-2\n")));
    for (const auto& [width, height] : {std::pair(1, 1), {1, 5}, {7, 1}}) {
        const std::string file = folder / (std::to_string(width) + "x" + std::to_string(height) + ".png");
        write(file, noiseImage(width, height, 1, PixelType::U16));
        for (const std::string technique : {"flat", "bump", "parallax", "relief"})
            EXPECT_EQ(runRelievo("render " + file + kSmall + "--technique " + technique + " -o " + (folder / "x.png")).exitCode, 0) << file;
        for (const std::string technique : {"relief", "reference"})
            EXPECT_EQ(runRelievo("trace " + file + " --technique " + technique + " --rays " + (folder / "rays.csv") + " -o "
                          + (folder / "hits.csv"))
                          .exitCode,
                0)
                << file;
        EXPECT_EQ(runRelievo("bake " + file + " --map normal -o " + (folder / "n.png")).exitCode, 0) << file;
        EXPECT_EQ(runRelievo("export " + file + " --target gltf -o " + (folder / "x.glb")).exitCode, 0) << file;
        const auto normals = readImage(folder / "n.png");
        ASSERT_TRUE(normals);
        EXPECT_EQ(normals->image.width, width);
        EXPECT_EQ(normals->image.height, height);
    }
}

TEST(BadInput, SixteenThousandTexelsWideIsReducedInBoundedMemory)
{
    TestFolder folder("wide");
    const std::string file = folder / "wide.tga"; // uncompressed grey; all but the header is a hole in the file
    const unsigned char header[18] = {0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0x88, 0x13, 8, 0x20};
    writeAll(file, std::string(reinterpret_cast<const char*>(header), sizeof header) + std::string(40000, '\xff'));
    fs::resize_file(file, sizeof header + std::uintmax_t(16384) * 5000);
    const ProgramRun info = runRelievo("info --json " + file);
    ASSERT_EQ(info.exitCode, 0) << info.err;
    EXPECT_EQ(json::parse(info.out)["maps"][0]["width"], 16384);
    EXPECT_TRUE(tellsCode(info.out, "reduced")) << info.out;
    const ProgramRun run = runRelievo("render " + file + kSmall + "-o " + (folder / "x.png"));
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_LT(peakMemoryMiB(), 3 * 1024);
}

TEST(BadInput, NamesFromFilesDoNotReachTheTerminalRaw)
{
    TestFolder folder("names");
    const std::string wild = "a\\u001b[2J\\u009b2J\\u007f\\n\\u0000" + std::string(1 << 20, 'x');
    writeAll(folder / "p.relievo",
        "{\"relievo\":1,\"name\":\"" + wild + "\",\"" + wild + "\":1,\"view\":\"" + wild + "\",\"mesh\":\"" + wild + "\",\"part\":\"" + wild
            + "\",\"maps\":{\"height\":{\"file\":\"" + wild + "\"}}}");
    const auto isRaw = [](const std::string& text) {
        return text.find_first_of(std::string_view("\x1b\x7f\0", 3)) != text.npos || text.find("\u009b") != text.npos;
    };
    for (const std::string command : {"info ", "info --json ", "render -o x.png --size 16x16 ", "export --target textures -o x "}) {
        const ProgramRun run = runRelievo(command + (folder / "p.relievo"));
        EXPECT_LT(run.exitCode, 2) << command;
        EXPECT_FALSE(isRaw(run.out) || isRaw(run.err)) << command;
        EXPECT_LT(run.err.size(), 20'000u) << command;
        EXPECT_LT(command == "info --json " ? 0u : run.out.size(), 20'000u) << command;
    }
    write(folder / "rock_height.png", noiseImage(16, 16, 1, PixelType::U16));
    writeAll(folder / "q.relievo", "{\"relievo\":1,\"name\":\"" + wild + "\",\"maps\":{\"height\":{\"file\":\"rock_height.png\"}}}");
    for (const std::string suffix : {"html", "csv", "json"}) {
        const std::string report = folder / ("r." + suffix);
        const ProgramRun run
            = runRelievo("report " + (folder / "q.relievo") + " --fast --no-pictures --techniques relief --rays 20 -o " + report);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_FALSE(isRaw(readAll(report))) << suffix;
        EXPECT_LT(readAll(report).size(), 400'000u) << suffix;
    }
}

TEST(BadInput, TruncatedImagesAreNamedAndTheRestIsKept)
{
    TestFolder folder("truncated");
    write(folder / "rock_height.png", noiseImage(64, 64, 1, PixelType::U16));
    write(folder / "rock_color.png", noiseImage(64, 64, 3, PixelType::U8));
    const std::string whole = readAll(folder / "rock_color.png");
    writeAll(folder / "rock_color.png", whole.substr(0, whole.size() / 2));
    const ProgramRun kept = runRelievo("render " + folder.path.string() + kSmall + "-o " + (folder / "x.png"));
    EXPECT_EQ(kept.exitCode, 0) << kept.err;
    EXPECT_NE(kept.err.find("rock_color.png"), std::string::npos) << kept.err;
    fs::remove(folder / "rock_height.png");
    fs::remove(folder / "x.png");
    expectRefused(runRelievo("render " + (folder / "rock_color.png") + kSmall + "-o " + (folder / "x.png")), "rock_color.png");
    EXPECT_FALSE(fs::exists(folder / "x.png"));
}

TEST(BadInput, WithoutHeightMapTheMissingMapIsNamed)
{
    TestFolder folder("no_height");
    write(folder / "rock_color.png", noiseImage(16, 16, 3, PixelType::U8));
    write(folder / "rock_normal.png", hillNormals(16, false));
    const std::string start = "render " + folder.path.string() + kSmall + "-o " + (folder / "x.png") + " --technique ";
    for (const std::string technique : {"parallax", "relief"})
        expectRefused(runRelievo(start + technique), "height map");
    EXPECT_FALSE(fs::exists(folder / "x.png"));
    for (const std::string technique : {"flat", "bump"})
        EXPECT_EQ(runRelievo(start + technique).exitCode, 0);
    expectRefused(runRelievo("trace " + folder.path.string() + " --technique relief --rays nothing.csv -o " + (folder / "h.csv")), "");
}

TEST(BadInput, NotANumberIsRepairedAndTold)
{
    TestFolder folder("nan");
    const std::string file = folder / "height.exr";
    write(file, makeImage(16, 16, 1, PixelType::F32, [](int x, int y, int) {
        return x == 3 ? NAN : y == 5 ? INFINITY : y == 6 ? -INFINITY : hill(x, y, 16);
    }));
    EXPECT_TRUE(tellsCode(runRelievo("info --json " + file).out, "nan-repaired"));
    const ProgramRun run = runRelievo("render " + file + kSmall + "-o " + (folder / "x.exr"));
    EXPECT_EQ(run.exitCode, 0) << run.err;
    const auto picture = readImage(folder / "x.exr");
    ASSERT_TRUE(picture);
    for (int i = 0; i < 32 * 24; ++i)
        ASSERT_TRUE(std::isfinite(picture->image.value(i % 32, i / 32, 0))) << i;
}

TEST(BadInput, MeshesWithoutNormalsUVsOrBuffers)
{
    TestFolder folder("meshes");
    writeAll(folder / "bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const ProgramRun bare = runRelievo("info --json " + (folder / "bare.obj"));
    EXPECT_TRUE(tellsCode(bare.out, "normals-made") && tellsCode(bare.out, "uvs-made")) << bare.out;
    const std::string start = "render " + kSource + kSmall + "-o " + (folder / "x.png") + " --mesh ";
    const ProgramRun shown = runRelievo(start + (folder / "bare.obj"));
    EXPECT_EQ(shown.exitCode, 0) << shown.err;
    EXPECT_NE(shown.err.find("UVs"), std::string::npos) << shown.err;
    fs::remove(folder / "x.png");
    writeAll(folder / "lost.gltf",
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"uri":"gone.bin","byteLength":36}],
            "bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}]})");
    for (const std::string& arguments : {"info " + (folder / "lost.gltf"), start + (folder / "lost.gltf")}) {
        const ProgramRun run = runRelievo(arguments);
        expectRefused(run, "lost.gltf");
        EXPECT_NE(run.err.find("gone.bin"), std::string::npos) << run.err;
    }
    EXPECT_FALSE(fs::exists(folder / "x.png"));
}

TEST(BadInput, PipesAndDevicesAreRefusedAtOnce)
{
    TestFolder folder("pipes");
    for (const char* name : {"p.obj", "p.gltf", "p.png", "p.relievo", "p.csv"})
        ASSERT_EQ(::mkfifo((folder / name).c_str(), 0600), 0);
    for (const std::string& arguments :
        {"info " + (folder / "p.obj"), "info " + (folder / "p.gltf"), "info " + (folder / "p.png"), "info " + (folder / "p.relievo"),
            "trace " + kSource + "--technique relief -o " + (folder / "h.csv") + " --rays " + (folder / "p.csv")}) {
        const ProgramRun run = runRelievo(arguments, 20);
        expectRefused(run, "p.");
    }
    expectRefused(runRelievo("info /dev/zero", 20), "/dev/zero");
}

TEST(BadInput, DevicesAreWrittenToNotReplaced)
{
    TestFolder folder("devices");
    writeAll(folder / "rays.csv", "u,v,du,dv\n0.5,0.5,0,0\n");
    const std::string trace = "trace " + kSource + "--technique relief --rays " + (folder / "rays.csv") + " -o ";
    fs::create_symlink("/dev/null", folder / "null.csv");
    EXPECT_EQ(runRelievo(trace + (folder / "null.csv")).exitCode, 0);
    EXPECT_TRUE(fs::is_symlink(folder / "null.csv"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    const ProgramRun out = runRelievo(trace + "/dev/stdout | cat");
    EXPECT_EQ(out.out.rfind("hit,t,u,v,fetches\n", 0), 0u) << out.out;
    fs::create_symlink("/dev/full", folder / "full.csv");
    expectRefused(runRelievo(trace + (folder / "full.csv")), "full.csv");
    // A link to a file stays a link; its target is replaced.
    writeAll(folder / "target.csv", "old");
    fs::create_symlink("target.csv", folder / "link.csv");
    EXPECT_EQ(runRelievo(trace + (folder / "link.csv")).exitCode, 0);
    EXPECT_TRUE(fs::is_symlink(folder / "link.csv"));
    EXPECT_NE(readAll(folder / "target.csv"), "old");
}

TEST(BadInput, OutputThatCannotBeWrittenIsNoSuccess)
{
    for (const char* command : {"describe --json", "info sample:bricks@64 --json", "render --help", "--version"}) {
        const ProgramRun run = runRelievo(std::string(command) + " > /dev/full");
        EXPECT_EQ(run.exitCode, 1) << command;
        EXPECT_TRUE(run.err.starts_with("relievo: error: stdout: the output could not be written")) << run.err;
    }
    const ProgramRun lost = runRelievo("describe parameters --json > /dev/full"); // more than a buffer of it
    EXPECT_EQ(lost.exitCode, 1);
    EXPECT_EQ(lost.err.find("Success"), std::string::npos) << lost.err;
    // Who closes the pipe has what was wanted, also where its signal is ignored, as in services.
    EXPECT_EQ(runRelievo("--version > /dev/null; trap '' PIPE; " RELIEVO_BIN "/relievo describe --json | true").err, "");
}

// A map of a set that cannot be read is left out with a warning; one that was asked for by name is not.
TEST(BadInput, MapsByHandThatCannotBeReadEndTheCommand)
{
    TestFolder folder("by_hand");
    write(folder / "rock_height.png", noiseImage(32, 32, 1, PixelType::U8));
    write(folder / "whole.png", noiseImage(32, 32, 3, PixelType::U8));
    writeAll(folder / "broken.png", readAll(folder / "whole.png").substr(0, 200));
    for (const char* map : {"color", "normal", "height", "roughness"})
        expectRefused(runRelievo("render " + (folder / "rock_height.png") + " --" + map + ' ' + (folder / "broken.png")
                          + " --quiet --size 16x16 --samples 1 -o " + (folder / "x.png")),
            "broken.png");
    EXPECT_FALSE(fs::exists(folder / "x.png"));
}

TEST(BadInput, WrongEnvironmentIsTold)
{
    TestFolder folder("environment");
    for (const auto& [variable, value] : {std::pair{"RELIEVO_THREADS", "abc"}, {"RELIEVO_THREADS", "0"}, {"RELIEVO_THREADS", "2x"},
             {"RELIEVO_SHADERS", "/nonexistent"}, {"RELIEVO_CACHE", "/proc/nope"}}) {
        const char* old = std::getenv(variable);
        const std::string before = old ? old : "";
        setenv(variable, value, 1);
        const ProgramRun run = runRelievo("bake sample:bricks@16 --map normal -o " + (folder / "n.png"));
        old ? setenv(variable, before.c_str(), 1) : unsetenv(variable);
        EXPECT_EQ(run.exitCode, 0) << variable;
        EXPECT_EQ(run.err.rfind("relievo: warning: " + std::string(variable) + '=' + value + ' ', 0), 0u) << run.err;
    }
}

TEST(BadInput, AFullDiskLosesNothing)
{
    TestFolder folder("full");
    write(folder / "rock_height.png", noiseImage(256, 256, 1, PixelType::U16));
    write(folder / "rock_color.png", noiseImage(256, 256, 3, PixelType::U8));
    const std::string set = folder.path.string(), disk = folder / "disk";
    fs::create_directories(disk);
    // Everything happens inside one namespace of its own, so that nothing stays mounted; the last line lists what is on the disk.
    const auto onFullDisk = [&](const std::string& command) {
        return runRelievo("--version > /dev/null; unshare -rm sh -c 'mount -t tmpfs -o size=200k tmpfs " + disk + " || exit 77; echo old > "
            + disk + "/x.png; cp " + disk + "/x.png " + disk + "/x.glb; " RELIEVO_BIN "/relievo " + command + "; code=$?; cat " + disk
            + "/x.png " + disk + "/x.glb; ls -A " + disk + "; exit $code'");
    };
    if (onFullDisk("--version").exitCode != 0)
        GTEST_SKIP() << "no small disk can be mounted here";
    for (const std::string& command : {"render " + set + " --size 900x900 --samples 1 --quiet -o " + disk + "/x.png",
             "export " + set + " --quiet --target gltf -o " + disk + "/x.glb",
             "export " + set + " --quiet --target textures -o " + disk + "/folder",
             "bake " + set + " --quiet --map normal -o " + disk + "/n.png"}) {
        const ProgramRun run = onFullDisk(command);
        expectRefused(run, disk);
        EXPECT_NE(run.err.find("space"), std::string::npos) << run.err;
        EXPECT_EQ(run.out, "old\nold\nx.glb\nx.png\n") << command;
    }
}

TEST(BadInput, FoldersAndEndlessNamesAsOutput)
{
    TestFolder folder("output");
    fs::create_directories(folder / "d.png");
    const std::string longName = std::string(300, 'a') + ".png";
    const std::string start = "render " + kSource + kSmall + "-o ";
    expectRefused(runRelievo(start + (folder / "d.png")), "d.png");
    expectRefused(runRelievo(start + (folder / longName)), longName);
    expectRefused(runRelievo("render " + kSource + kSmall + "-o " + (folder / "x.png") + " --height " + (folder / longName)), longName);
    expectRefused(runRelievo("export " + kSource + "--target textures -o " + (folder / "d.png/" + longName)), longName);
    expectRefused(runRelievo("info ''"), "SOURCE");
    EXPECT_EQ(namesIn(folder.path), std::vector<std::string>{"d.png"});
    EXPECT_TRUE(namesIn(folder.path / "d.png").empty());
}

TEST(BadInput, NamesThatAreNoText)
{
    TestFolder folder("names");
    const std::string file = folder / "x\xff_height.png";
    write(file, noiseImage(16, 16, 1, PixelType::U8));
    for (const std::string& arguments : {"info --json " + file, "render --json " + file + kSmall + "-o " + (folder / "y\xff.png"),
             "bake --json " + file + " --map normal -o " + (folder / "n\xff.png"),
             "export --json " + file + " --target textures -o " + (folder / "t\xff")}) {
        const ProgramRun run = runRelievo(arguments);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_TRUE(json::accept(run.out)) << run.out;
    }
}

TEST(BadInput, ProjectsWithWrongContent)
{
    TestFolder folder("projects");
    int n = 0;
    for (const char* text : {"", "[]", "null", "{\"relievo\":99}", "{\"relievo\":\"x\"}", "\x89PNG\r\n\x1a\n", "{\"relievo\":1,"}) {
        const std::string name = "p" + std::to_string(n++) + ".relievo";
        writeAll(folder / name, text);
        expectRefused(runRelievo("render " + (folder / name) + kSmall + "-o " + (folder / "x.png")), name);
        expectRefused(runRelievo("info " + (folder / name)), name);
    }
    EXPECT_FALSE(fs::exists(folder / "x.png"));
    // Wrong values inside are told by name, the rest is kept.
    writeAll(folder / "q.relievo",
        R"({"relievo":1,"mesh":7,"parameters":{"depth":"deep","zebra":1,"maxSteps":1e99},"maps":{"height":3},"panes":[]})");
    const ProgramRun run = runRelievo("render " + (folder / "q.relievo") + kSmall + "--technique flat -o " + (folder / "x.png"));
    EXPECT_EQ(run.exitCode, 0) << run.err;
    for (const char* key : {"mesh", "depth", "zebra", "maxSteps", "height"})
        EXPECT_NE(run.err.find(key), std::string::npos) << key << '\n' << run.err;
}
