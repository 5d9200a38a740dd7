// The command line as resources/help/command-line.md promises it: exit codes, messages and files.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "core/image/files/image_file.h"
#include "core/maps/maps.h"
#include "core/state/parameters.h"
#include "core/state/presets.h"
#include "tests/program/run.h"
#include <array>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string kSource = "sample:bricks@64 ";

bool isPng(const std::string& file)
{
    const auto text = relievo::readText(file);
    return text && text->starts_with("\x89PNG");
}

// Of the colours of two pictures of one size, shares of white.
double meanDifference(const relievo::Image& a, const relievo::Image& b)
{
    EXPECT_TRUE(a.width == b.width && a.height == b.height);
    double sum = 0.;
    for (int y = 0; y < std::min(a.height, b.height); ++y)
        for (int x = 0; x < std::min(a.width, b.width); ++x)
            for (int c = 0; c < 3; ++c)
                sum += std::abs(double(a.value(x, y, c)) - double(b.value(x, y, c)));
    return sum / double(a.texelCount() * 3);
}

struct HitLine {
    int hit;
    double t, u, v;
    int fetches;
};
std::vector<HitLine> hitsOf(const std::string& file)
{
    std::istringstream in(*relievo::readText(file));
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line, "hit,t,u,v,fetches");
    std::vector<HitLine> hits;
    while (std::getline(in, line)) {
        HitLine h{};
        EXPECT_EQ(std::sscanf(line.c_str(), "%d,%lf,%lf,%lf,%d", &h.hit, &h.t, &h.u, &h.v, &h.fetches), 5) << line;
        hits.push_back(h);
    }
    return hits;
}

} // namespace

TEST(Cli, TellsWhatDepthFitsAMesh)
{
    TestFolder folder("fits");
    std::ofstream(folder / "plate.obj") << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 -0.01\nv 1 0 -0.01\nv 1 1 -0.01\nv 0 1 -0.01\n"
                                           "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";
    EXPECT_NE(runRelievo("info --json " + (folder / "plate.obj")).out.find("relief-too-deep"), std::string::npos);
    EXPECT_EQ(runRelievo("info sphere --json").out.find("relief-too-deep"), std::string::npos);
    const std::string torus = "render sample:bricks@16 --mesh torus --size 32x24 -o " + (folder / "x.png") + " --set depth=";
    EXPECT_NE(runRelievo(torus + "1.4").err.find("deeper than the mesh"), std::string::npos);
    EXPECT_EQ(runRelievo(torus + "0.1").err.find("deeper than the mesh"), std::string::npos);
}

TEST(Cli, VersionAndHelp)
{
    EXPECT_EQ(runRelievo("--version").out.rfind("relievo ", 0), 0u);
    for (const char* command : {"", "render", "trace", "bake", "export", "describe", "info", "report", "tune", "compare"}) {
        const ProgramRun run = runRelievo(std::string(command) + " --help");
        EXPECT_EQ(run.exitCode, 0) << command;
        EXPECT_NE(run.out.find("Usage"), std::string::npos) << command;
    }
}

TEST(Cli, WrongUsageIsTwo)
{
    TestFolder folder("usage");
    const std::string out = "-o " + (folder / "x.png");
    for (const std::string& arguments :
        std::vector<std::string>{std::string("render ") + kSource, "render " + out, "render " + kSource + out + " --size 10",
            "render " + kSource + out + " --view sideways", "render " + kSource + out + " --technique magic",
            "render " + kSource + out + " --set depth=9", "render " + kSource + out + " --set deep=1",
            "render " + kSource + out + " --camera pitch=100", "render " + kSource + out + " --nonsense", "render " + kSource + "-o x.gif",
            "bake " + kSource + out + " --map none", "export " + kSource + out + " --target none",
            "export " + kSource + "--target gltf -o " + (folder / "x.obj"), "render " + kSource + out + " --view nosuch --views normal",
            "render " + kSource + "-o x.exr --views normal,normal", "render " + kSource + out + " --height a.png --depth-map b.png",
            "bake " + kSource + out + " --map cone --bits 32", "bake " + kSource + "--map normal -o x.jpg",
            "bake " + kSource + out + " --map cell-cone --bits 8", "describe nothing", std::string("no-such-command"), "--nonsense",
            "sample:bricks --nonsense", "trace", "info", "render " + kSource + out + " --samples many"}) {
        const ProgramRun run = runRelievo(arguments);
        EXPECT_EQ(run.exitCode, 2) << arguments << run.err;
        EXPECT_EQ(run.err.rfind("relievo: error: ", 0), 0u) << arguments << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << arguments << run.err;
    }
}

TEST(Cli, AnUnknownCommandIsNamed)
{
    for (const char* arguments : {"audit", "audit sample:bricks", "audit sample:bricks --budget 3"}) {
        const ProgramRun run = runRelievo(arguments);
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_NE(run.err.find("audit"), std::string::npos) << run.err;
    }
}

TEST(Cli, FailuresAreOneWithOneSentenceThatNamesTheFile)
{
    TestFolder folder("failures");
    ASSERT_TRUE(relievo::writeAtomically(folder / "empty.png", std::string_view("")));
    ASSERT_TRUE(relievo::writeAtomically(folder / "bad.relievo", std::string_view("{")));
    fs::create_directories(folder / "nothing");
    const std::string out = " -o " + (folder / "x.png");
    for (const auto& [arguments, named] : {std::pair{"render " + (folder / "none.png") + out, std::string("none.png")},
             {"render " + (folder / "empty.png") + out, "empty.png"}, {"render " + (folder / "bad.relievo") + out, "bad.relievo"},
             {"render " + (folder / "nothing") + out, "nothing"}, {"render " + kSource + "-o " + (folder / "no/such/x.png"), "x.png"},
             {"render " + kSource + out + " --mesh " + (folder / "none.obj"), "none.obj"},
             {"render " + kSource + out + " --height " + (folder / "none.tif"), "none.tif"},
             {"render " + kSource + out + " --environment " + (folder / "none.hdr"), "none.hdr"},
             {"render sample:nothing" + out, "sample:nothing"}, {"render " + kSource + out + " --preset nothing", "nothing"},
             {"trace " + kSource + "--rays " + (folder / "none.csv") + out, "none.csv"}, {"info " + (folder / "none.png"), "none.png"}}) {
        const ProgramRun run = runRelievo(arguments);
        EXPECT_EQ(run.exitCode, 1) << arguments;
        EXPECT_EQ(run.err.rfind("relievo: error: ", 0), 0u) << run.err;
        EXPECT_NE(run.err.find(named), std::string::npos) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }
    EXPECT_FALSE(fs::exists(folder / "x.png"));
}

TEST(Cli, RenderWritesPngAndExr)
{
    TestFolder folder("render");
    ProgramRun run = runRelievo("render " + kSource + "-o " + (folder / "a.png") + " --size 64x48 --json");
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(isPng(folder / "a.png"));
    EXPECT_EQ(json::parse(run.out)["width"], 64);
    run = runRelievo("render " + kSource + "-o " + (folder / "a.exr") + " --size 64x48 --views shaded,depth,fetches");
    EXPECT_EQ(run.exitCode, 0) << run.err;
    for (const char* channel : {"shaded.R", "depth.R", "fetches.R"}) // the first too
        EXPECT_NE(relievo::readText(folder / "a.exr")->find(channel), std::string::npos) << channel;
    const ProgramRun info = runRelievo("info " + (folder / "a.exr") + " --json");
    EXPECT_EQ(info.exitCode, 0) << info.err;
}

TEST(Cli, RenderFollowsItsOptions)
{
    TestFolder folder("options");
    const auto rendered = [&](const std::string& options) {
        const ProgramRun run = runRelievo("render " + kSource + "-o " + (folder / "x.png") + " --size 48x48 " + options);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return *relievo::readText(folder / "x.png");
    };
    const std::string plain = rendered("");
    EXPECT_EQ(rendered(""), plain);
    for (const char* option :
        {"--technique flat", "--set depth=0.3", "--mesh sphere", "--camera yaw=80", "--preset preview --set depth=0.2", "--view normal"})
        EXPECT_NE(rendered(option), plain) << option;
}

TEST(Cli, SequencesTurnOnceAndLoop)
{
    TestFolder folder("frames");
    const std::string size = " --size 48x48 --samples 1 ";
    const auto sequence = [&](const std::string& options, const std::string& name) {
        const ProgramRun run = runRelievo("render " + kSource + "--json --frames 4 " + options + size + "-o " + (folder / name));
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return run.exitCode == 0 ? json::parse(run.out)["files"].get<std::vector<std::string>>() : std::vector<std::string>();
    };
    for (const std::string turn : {"", "--turntable", "--light-turn"}) {
        const auto files = sequence("--camera yaw=10 " + turn, "a" + turn + ".###.png");
        ASSERT_EQ(files.size(), 4u);
        EXPECT_EQ(std::filesystem::path(files[3]).filename(), "a" + turn + ".004.png");
        std::set<std::string> pictures;
        for (const std::string& file : files)
            pictures.insert(*relievo::readText(file));
        EXPECT_EQ(pictures.size(), 4u) << turn;
    }
    // A quarter further round is where the next picture of the first begins; two quarters on, the light is opposite.
    EXPECT_EQ(*relievo::readText(sequence("--camera yaw=100,distance=2", "b.#.png")[0]),
        *relievo::readText(sequence("--camera yaw=10,distance=2", "c.#.png")[1]));
    EXPECT_EQ(*relievo::readText(sequence("--light-turn --set lightYaw=150", "d.#.png")[2]),
        *relievo::readText(sequence("--light-turn --set lightYaw=-30", "e.#.png")[0]));
    for (const auto& [options, told] : {std::pair("--frames 3 -o " + (folder / "x.png"), "as in turn.####.png"),
             std::pair("--turntable -o " + (folder / "x.png"), "Add --frames N"),
             std::pair("--frames 0 -o " + (folder / "x.#.png"), "--frames")}) {
        const ProgramRun run = runRelievo("render " + kSource + options + size);
        EXPECT_EQ(run.exitCode, 2) << options;
        EXPECT_NE(run.err.find(told), std::string::npos) << run.err;
    }
}

TEST(Cli, SixteenBitStillsHoldSixteenBits)
{
    TestFolder folder("bits");
    const std::string out = folder / "x.png";
    ASSERT_EQ(runRelievo("render " + kSource + "--size 40x30 --bits 16 -o " + out).exitCode, 0);
    const auto info = relievo::readImageInfo(out);
    ASSERT_TRUE(info);
    EXPECT_EQ(info->storedBits, 16);
    EXPECT_EQ(runRelievo("render " + kSource + "--size 40x30 --bits 12 -o " + out).exitCode, 2);
    EXPECT_EQ(runRelievo("render " + kSource + "--size 40x30 --bits 16 -o " + (folder / "x.exr")).exitCode, 2);
    EXPECT_NE(runRelievo("render " + kSource + "--size 16385x30 -o " + out).exitCode, 0);
}

TEST(Cli, AllScenesMakeAGallery)
{
    TestFolder folder("gallery");
    const std::string out = folder / "new/gallery";
    const ProgramRun run = runRelievo("render --all-scenes --json --size 96x72 -o " + out);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json told = json::parse(run.out);
    std::size_t scenes = 0;
    for (const relievo::PresetRow& row : relievo::kPresets)
        if (!row.sample.empty()) {
            ++scenes;
            const std::string name = std::string(row.key) + ".png";
            const auto drawn = relievo::readImage(out + '/' + name),
                       thumbnail = relievo::readImage(RELIEVO_SOURCE "/resources/scenes/" + name);
            ASSERT_TRUE(drawn && thumbnail) << row.key;
            EXPECT_LT(meanDifference(drawn->image, thumbnail->image), 0.02) << row.key << ": the thumbnail in resources/scenes is stale";
        }
    EXPECT_EQ(told["files"].size(), scenes);
    EXPECT_GT(scenes, 0u);
    const std::string first = out + "/teapot-cobbles.png", before = *relievo::readText(first);
    EXPECT_EQ(runRelievo("render --all-scenes --size 24x18 --environment " + first + " -o " + out).exitCode, 1)
        << "it would replace what it reads";
    EXPECT_EQ(*relievo::readText(first), before);
    EXPECT_EQ(runRelievo("render sample:bricks --all-scenes -o " + out).exitCode, 2);
    EXPECT_EQ(runRelievo("render --all-scenes --frames 3 -o " + out).exitCode, 2);
}

TEST(Cli, AnimationsThatTheMeshLacksAreTold)
{
    TestFolder folder("clip");
    const auto told = [&](const std::string& options) {
        const ProgramRun run
            = runRelievo("render sample:bricks@64 --technique flat --size 32x24 --samples 1 -o " + (folder / "x.png") + ' ' + options);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return run.err;
    };
    EXPECT_EQ(told("--mesh character --set clip=0 --set time=0.5"), "");
    EXPECT_NE(told("--mesh character --set clip=5").find("has one animation, 0; it is shown at rest"), std::string::npos);
    EXPECT_NE(told("--mesh sphere --set time=1").find("has no animation; it is shown at rest"), std::string::npos);
    EXPECT_EQ(told("--mesh sphere"), "");
}

TEST(Cli, OptionsApplyInTheirOrder)
{
    TestFolder folder("order");
    // --set wins over --preset, whatever the order on the line.
    const std::string a = folder / "a.json";
    const ProgramRun run = runRelievo("export " + kSource + "--set maxSteps=77 --preset fine --target preset -o " + a);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(json::parse(*relievo::readText(a))["parameters"]["maxSteps"], 77);
    EXPECT_EQ(json::parse(*relievo::readText(a))["parameters"]["minSteps"], 64);
}

TEST(Cli, TraceAnswersEveryRay)
{
    TestFolder folder("trace");
    ASSERT_TRUE(relievo::writeAtomically(
        folder / "rays.csv", std::string_view("u,v,du,dv\n0.5,0.5,0,0\n0.1,0.2,0.3,-0.1\r\nnan,0,0,0\n0,0,inf,0\n0.25,0.75,1e-3,0\n")));
    for (const char* technique : {"flat", "bump", "parallax", "relief", "reference"}) {
        const ProgramRun run = runRelievo(
            "trace " + kSource + "--technique " + technique + " --rays " + (folder / "rays.csv") + " -o " + (folder / "hits.csv"));
        ASSERT_EQ(run.exitCode, 0) << run.err;
        const auto hits = hitsOf(folder / "hits.csv");
        ASSERT_EQ(hits.size(), 5u);
        for (const int i : {2, 3}) {
            EXPECT_EQ(hits[std::size_t(i)].hit, 0);
            EXPECT_EQ(hits[std::size_t(i)].t, 1.);
            EXPECT_EQ(hits[std::size_t(i)].u, 0.);
            EXPECT_EQ(hits[std::size_t(i)].fetches, 0);
        }
        EXPECT_EQ(hits[0].hit, 1);
        EXPECT_EQ(hits[0].u, 0.5);
        if (std::string(technique) == "flat") {
            EXPECT_EQ(hits[1].t, 0.);
        }
        if (std::string(technique) == "parallax") {
            EXPECT_EQ(hits[1].fetches, 1);
        }
    }
}

TEST(Cli, TraceToldByTheHeader)
{
    TestFolder folder("header");
    const auto traced = [&](const std::string& rays) {
        EXPECT_TRUE(relievo::writeAtomically(folder / "rays.csv", rays));
        return runRelievo("trace " + kSource + "--technique relief --rays " + (folder / "rays.csv") + " -o " + (folder / "hits.csv"));
    };
    EXPECT_EQ(traced("u,v,du,dv,cosView\n0,0,1,0,1\n").exitCode, 0);
    const int frontal = hitsOf(folder / "hits.csv").front().fetches;
    EXPECT_EQ(traced("u,v,du,dv,cosView\n0,0,1,0,0.01\n").exitCode, 0);
    EXPECT_GT(hitsOf(folder / "hits.csv").front().fetches, frontal); // more steps at grazing views
    for (const char* wrong : {"", "x,y\n1,2\n", "u,v,du,dv\n1,2,3\n", "u,v,du,dv\n1,2,3,four\n"}) {
        const ProgramRun run = traced(wrong);
        EXPECT_EQ(run.exitCode, 1) << wrong;
        EXPECT_NE(run.err.find("rays.csv"), std::string::npos);
    }
    EXPECT_NE(traced("u,v,du,dv\n1,2,3,4\n1,2\n").err.find("rays.csv:3"), std::string::npos);
}

TEST(Cli, BakeWritesNormals)
{
    TestFolder folder("bake");
    for (const char* bits : {"8", "16", "32"}) {
        const std::string file = folder / (std::string("n") + bits + (bits == std::string("32") ? ".exr" : ".png"));
        const ProgramRun run = runRelievo("bake " + kSource + "--map normal --bits " + bits + " -o " + file);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_TRUE(fs::exists(file));
    }
}

TEST(Cli, BakeWritesEveryMapWithItsScale)
{
    TestFolder folder("bake_all");
    ASSERT_EQ(runRelievo("bake sample:bricks@48 --map normal -o " + (folder / "a_normal.png")).exitCode, 0);
    for (std::size_t i = 0; i < relievo::kBakedMaps.size(); ++i) {
        const relievo::BakedMapRow& row = relievo::kBakedMaps[i];
        const std::string bits = row.form == relievo::MapForm::Codes ? "16" : std::array{"8", "16", "32"}[i % 3];
        const std::string file = folder / (std::string(row.key) + (bits == "32" ? ".exr" : ".png"));
        const ProgramRun run = runRelievo("bake sample:bricks@48 --json --normal " + (folder / "a_normal.png") + " --map "
            + std::string(row.key) + " --bits " + bits + " -o " + file);
        ASSERT_EQ(run.exitCode, 0) << row.key << run.err;
        const json told = json::parse(run.out);
        EXPECT_EQ(told["scale"].size(), std::size_t(row.channels));
        EXPECT_GE(told["seconds"], 0.);
        int height = 0;
        for (const json& level : told["levels"])
            height += level[1].get<int>() * told["slices"].get<int>();
        EXPECT_EQ(told["height"], height) << row.key;
        const auto read = relievo::readImageInfo(file);
        ASSERT_TRUE(read) << file;
        EXPECT_EQ(read->width, told["width"]);
        EXPECT_EQ(read->height, height);
        EXPECT_EQ(read->channels, row.channels == 2 ? 3 : row.channels) << row.key;
    }
}

// A normal map given by hand may be of DirectX style, as its name or its pixels say: green is flipped, and nothing else.
TEST(Cli, NormalMapsByHandAreFlippedWhenTheyAreDirectX)
{
    TestFolder folder("by_hand");
    ASSERT_EQ(runRelievo("bake sample:bricks@48 --map normal --bits 8 -o " + (folder / "gl.png")).exitCode, 0);
    relievo::Image image = relievo::readImage(folder / "gl.png")->image;
    ASSERT_EQ(image.type, relievo::PixelType::U8);
    const std::size_t channels = std::size_t(image.channels);
    for (std::size_t i = 1; i < image.data.size(); i += channels)
        image.data[i] = std::byte(255) ^ image.data[i];
    for (const char* name : {"dx.png", "plain.png", "bricks_normal_dx.png"})
        ASSERT_TRUE(relievo::writeImage(folder / name, image));
    const auto heights = [&](const std::string& normal) {
        const ProgramRun run = runRelievo(
            "bake sample:bricks@48 --normal " + (folder / normal) + " --map height-from-normal --bits 8 -o " + (folder / "h.png"));
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return relievo::readImage(folder / "h.png")->image.data;
    };
    const auto right = heights("gl.png");
    for (const char* name : {"dx.png", "plain.png", "bricks_normal_dx.png"}) {
        const auto made = heights(name);
        ASSERT_EQ(made.size(), right.size());
        int worst = 0;
        for (std::size_t i = 0; i < made.size(); ++i)
            worst = std::max(worst, std::abs(std::to_integer<int>(made[i]) - std::to_integer<int>(right[i])));
        EXPECT_LE(worst, 2) << name;
    }
}

TEST(Cli, BakeTellsHowToReadRatiosAndWhatIsMissing)
{
    TestFolder folder("bake_words");
    const std::string file = folder / "x.png";
    EXPECT_NE(runRelievo("bake sample:bricks@32 --map cone -o " + file).out.find("channel 2: value = "), std::string::npos);
    EXPECT_NE(runRelievo("bake sample:bricks@32 --map height-from-normal -o " + file).err.find("no normal map"), std::string::npos);
    ASSERT_EQ(runRelievo("bake sample:bricks@32 --map normal -o " + (folder / "a_normal.png")).exitCode, 0);
    const ProgramRun heights = runRelievo("bake " + (folder / "a_normal.png") + " --map height-from-normal -o " + file);
    EXPECT_EQ(heights.exitCode, 0) << heights.err;
    EXPECT_NE(heights.out.find("depth: "), std::string::npos);
    EXPECT_NE(runRelievo("bake " + (folder / "a_normal.png") + " --map cone -o " + file).err.find("no height map"), std::string::npos);
}

TEST(Cli, DescribeListsEveryParameter)
{
    const ProgramRun run = runRelievo("describe parameters --json");
    ASSERT_EQ(run.exitCode, 0);
    const json tables = json::parse(run.out);
    ASSERT_EQ(tables["parameters"].size(), relievo::kParameters.size());
    for (std::size_t i = 0; i < relievo::kParameters.size(); ++i)
        EXPECT_EQ(tables["parameters"][i]["key"], std::string(relievo::kParameters[i].key));
    EXPECT_EQ(json::parse(runRelievo("describe --json").out).size(), 6u);
}

TEST(Cli, TheReferencePageIsFresh)
{
    const auto page = relievo::readText(RELIEVO_SOURCE "/resources/help/reference.md");
    ASSERT_TRUE(page);
    EXPECT_TRUE(page->ends_with(runRelievo("describe --markdown").out))
        << "run: relievo describe --markdown, and put it below the head of resources/help/reference.md";
}

TEST(Cli, UnwritableOutputKeepsTheOldFile)
{
    TestFolder folder("unwritable");
    const std::string file = folder / "x.png/below.png"; // its folder is a file
    ASSERT_TRUE(relievo::writeAtomically(folder / "x.png", std::string_view("old")));
    const ProgramRun run = runRelievo("render " + kSource + "--size 16x16 -o " + file);
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.err.find("below.png"), std::string::npos) << run.err;
    EXPECT_EQ(*relievo::readText(folder / "x.png"), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()), 1);
}

TEST(Cli, AProjectWhoseTexturesMovedKeepsTheRest)
{
    TestFolder folder("moved");
    const ProgramRun made = runRelievo("bake " + kSource + "--map normal -o " + (folder / "a_normal.png"));
    ASSERT_EQ(made.exitCode, 0);
    ASSERT_TRUE(relievo::writeAtomically(folder / "p.relievo",
        std::string_view(
            R"({"relievo":1,"maps":{"height":{"file":"gone.png"},"normal":{"file":"a_normal.png"}},"panes":[{"technique":"bump"}]})")));
    const ProgramRun run = runRelievo("render " + (folder / "p.relievo") + " --size 32x32 -o " + (folder / "x.png"));
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_NE(run.err.find("gone.png"), std::string::npos) << run.err;
    EXPECT_TRUE(isPng(folder / "x.png"));
}

TEST(Cli, ShadersOfTheFolderWarnOnTheCpu)
{
    TestFolder folder("shaders");
    fs::create_directories(folder / "techniques");
    const std::string text = *relievo::readText(RELIEVO_SOURCE "/shaders/techniques/relief.glsl");
    ASSERT_TRUE(relievo::writeAtomically(folder / "techniques/relief.glsl", text + "\n// changed\n"));
    ASSERT_TRUE(relievo::writeAtomically(folder / "rays.csv", std::string_view("u,v,du,dv\n0,0,0,0\n")));
    setenv("RELIEVO_SHADERS", folder.path.c_str(), 1);
    const ProgramRun run
        = runRelievo("trace " + kSource + "--technique relief --rays " + (folder / "rays.csv") + " -o " + (folder / "h.csv"));
    unsetenv("RELIEVO_SHADERS");
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_NE(run.err.find("relief.glsl"), std::string::npos) << run.err;
}
