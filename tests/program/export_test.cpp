// relievo export: several targets, many sources in processes of their own, resumed and in parts.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/ground/file.h"
#include "tests/core/image/image_support.h"
#include "tests/program/run.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

using namespace relievo;
using namespace relievo::test;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {
struct Sets {
    TestFolder folder{"export"};
    std::string in = folder / "in", out = folder / "out";
    void add(const std::string& name, int seed = 16)
    {
        fs::create_directories(fs::path(in) / name);
        EXPECT_TRUE(writeImage(fs::path(in) / name / "rock_height.png", noiseImage(seed, 16, 1, PixelType::U16)));
    }
};

json exportsOf(const ProgramRun& run)
{
    const json printed = json::parse(run.out, nullptr, false);
    EXPECT_TRUE(printed.is_object()) << run.out << run.err;
    return printed.is_object() ? printed["exports"] : json::array();
}

// source's last part and target of each entry, and whether it failed or was left as it is
std::set<std::string> told(const json& exports)
{
    std::set<std::string> all;
    for (const json& one : exports)
        all.insert(fs::path(one["source"].get<std::string>()).filename().string() + ' ' + one["target"].get<std::string>()
            + (one["error"].is_null() ? "" : " failed") + (one.value("unchanged", false) ? " unchanged" : ""));
    return all;
}
} // namespace

TEST(ExportCommand, SeveralTargetsMakeAFolderEach)
{
    const TestFolder folder("targets");
    const ProgramRun run = runRelievo("export sample:bricks@32 --json --target godot4,gltf,preset -o " + (folder / "out"));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json exports = exportsOf(run);
    EXPECT_EQ(told(exports), (std::set<std::string>{"sample:bricks@32 godot4", "sample:bricks@32 gltf", "sample:bricks@32 preset"}));
    for (const json& one : exports) {
        EXPECT_FALSE(one["files"].empty());
        for (const json& file : one["files"])
            EXPECT_TRUE(fs::exists(file.get<std::string>())) << file;
        EXPECT_TRUE(one["warnings"].is_array());
    }
    EXPECT_TRUE(fs::exists(folder.path / "out/godot4/Bricks.tres"));
    EXPECT_TRUE(fs::exists(folder.path / "out/gltf/Bricks.glb"));
    EXPECT_TRUE(fs::exists(folder.path / "out/preset/Bricks.json"));
}

TEST(ExportCommand, CuresAreChosenByName)
{
    const TestFolder folder("cures");
    const auto text = [&](const std::string& options) {
        const ProgramRun run = runRelievo("export sample:bricks@16 --target gltf -o " + (folder / "a.gltf ") + options);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return readText(folder / "a.gltf").value_or("");
    };
    EXPECT_EQ(text("").find("EXT_materials_bump"), std::string::npos);
    EXPECT_NE(text("--with bump").find("EXT_materials_bump"), std::string::npos);
    for (const char* option : {"--with", "--without"}) {
        const ProgramRun run = runRelievo("export sample:bricks@16 --target gltf -o " + (folder / "a.gltf ") + option + " bumps");
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_NE(run.err.find(std::string(option) + " bumps"), std::string::npos) << run.err;
        EXPECT_NE(run.err.find("full-range, normals, dither, bump"), std::string::npos) << run.err;
    }
}

// What another target encoded is not encoded again, also where it stands within a file.
TEST(ExportCommand, PicturesInsideFilesAreThoseOfOtherTargets)
{
    const TestFolder folder("embedded");
    const ProgramRun run = runRelievo("export sample:bricks@32 --target packed,gltf -o " + (folder / "out"));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const std::string glb = readText(folder.path / "out/gltf/Bricks.glb").value_or("");
    int within = 0;
    for (const fs::path& file : fs::directory_iterator(folder.path / "out/packed"))
        if (const std::string picture = readText(file).value_or(""); file.extension() == ".png")
            within += glb.find(picture) != std::string::npos;
    EXPECT_GE(within, 2) << "base color, and occlusion, roughness and metallic";
}

TEST(ExportCommand, NoMapIsBakedThatNoTargetHolds)
{
    const TestFolder folder("unbaked");
    ASSERT_EQ(setenv("RELIEVO_CACHE", (folder / "cache").c_str(), 1), 0);
    const auto baked = [&](const std::string& target) {
        fs::remove_all(folder.path / "cache");
        const ProgramRun run = runRelievo("export sample:bricks@16 --technique cell-cone --target " + target + " -o " + (folder / "out"));
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return fs::exists(folder.path / "cache") ? std::distance(fs::directory_iterator(folder.path / "cache"), {}) : 0;
    };
    EXPECT_EQ(baked("packed"), 0);
    EXPECT_EQ(baked("glsl"), 1) << "of the heights that are written";
    setenv("RELIEVO_CACHE", "off", 1);
}

TEST(ExportCommand, ManySourcesAreExportedEachAndFailuresToldAtTheEnd)
{
    Sets sets;
    sets.add("a");
    sets.add("deep/b");
    sets.add("deep/a"); // a name that is taken
    sets.add("broken");
    ASSERT_TRUE(writeAtomically(sets.in + "/broken/rock_height.png", std::string_view("\x89PNG\r\n\x1a\nno more")));
    fs::create_directory_symlink(sets.in, fs::path(sets.in) / "deep/loop");
    const ProgramRun run = runRelievo("export " + sets.in + " --target bevy --jobs 2 -o " + sets.out);
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.err.find("broken"), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 4) << run.out; // a line each
    EXPECT_NE(run.out.find("failed"), std::string::npos);
    for (const char* file : {"a/rock.rs", "a_2/rock.rs", "b/rock.rs"})
        EXPECT_TRUE(fs::exists(fs::path(sets.out) / file)) << file;
    EXPECT_FALSE(fs::exists(fs::path(sets.out) / "broken"));

    const json exports
        = exportsOf(runRelievo("export " + sets.in + "/a " + sets.in + "/broken --json --target bevy,godot3 -o " + sets.out + "2"));
    EXPECT_EQ(told(exports), (std::set<std::string>{"a bevy", "a godot3", "broken bevy failed", "broken godot3 failed"}));
    EXPECT_TRUE(fs::exists(fs::path(sets.out + "2") / "a/godot3/rock.tres"));
}

TEST(ExportCommand, ResumingWritesOnlyWhatIsMissingOrChanged)
{
    Sets sets;
    for (const char* name : {"a", "b", "c"})
        sets.add(name);
    const std::string command = "export " + sets.in + " --json --resume --target packed -o " + sets.out;
    EXPECT_EQ(told(exportsOf(runRelievo(command))), (std::set<std::string>{"a packed", "b packed", "c packed"}));
    EXPECT_EQ(
        told(exportsOf(runRelievo(command))), (std::set<std::string>{"a packed unchanged", "b packed unchanged", "c packed unchanged"}));
    sets.add("b", 20); // other pixels
    fs::remove(fs::path(sets.out) / "c/rock_Height.png");
    EXPECT_EQ(told(exportsOf(runRelievo(command))), (std::set<std::string>{"a packed unchanged", "b packed", "c packed"}));
    EXPECT_TRUE(fs::exists(fs::path(sets.out) / "c/rock_Height.png"));
    const json other = exportsOf(runRelievo(command + " --size 8"));
    EXPECT_EQ(told(other), (std::set<std::string>{"a packed", "b packed", "c packed"}));
}

TEST(ExportCommand, ShardsAreAllOfIt)
{
    Sets sets;
    for (const char* name : {"a", "b", "c", "d", "e"})
        sets.add(name);
    std::set<std::string> all;
    for (const char* part : {"1/2", "2/2"}) {
        const std::set<std::string> some
            = told(exportsOf(runRelievo("export " + sets.in + " --json --target bevy --shard " + part + " -o " + sets.out)));
        EXPECT_GE(some.size(), 2u);
        all.insert(some.begin(), some.end());
    }
    EXPECT_EQ(all.size(), 5u);
    for (const char* part : {"0/2", "3/2", "x", "1/2x"})
        EXPECT_EQ(runRelievo("export " + sets.in + " --target bevy --shard " + std::string(part) + " -o " + sets.out).exitCode, 2) << part;
}

TEST(ExportCommand, TakesTargetsAndPackingsOfTheUsers)
{
    const TestFolder folder("own");
    ASSERT_TRUE(writeAtomically(folder / "mine.tpl",
        std::string_view("{\"textures\": [{\"key\": \"h\", \"file\": \"{{name}}.tga\", \"channels\": [\"height\"]}]}\n=== "
                         "{{name}}.txt\n{{depthMetres}}\n")));
    ASSERT_TRUE(writeAtomically(folder / "pack.json",
        std::string_view("{\"textures\": [{\"key\": \"h\", \"file\": \"{{name}}_d.png\", \"channels\": [\"depth\", \"1.0\"]}]}")));
    const std::string source = "export sample:bricks@32 --set depth=0.25 ", out = folder / "out";
    ASSERT_EQ(runRelievo(source + "--target " + (folder / "mine.tpl") + " -o " + out).exitCode, 0);
    EXPECT_EQ(readText(out + "/Bricks.txt").value_or(""), "0.25\n");
    EXPECT_TRUE(fs::exists(out + "/Bricks.tga"));
    ASSERT_EQ(runRelievo(source + "--target packed --packing " + (folder / "pack.json") + " -o " + out + '2').exitCode, 0);
    EXPECT_TRUE(fs::exists(out + "2/Bricks_d.png"));
    EXPECT_FALSE(fs::exists(out + "2/Bricks_Height.png"));
    ASSERT_TRUE(writeAtomically(folder / "bad.tpl",
        std::string_view(
            "{\"textures\": [{\"key\": \"h\", \"file\": \"{{name}}.tga\", \"channels\": [\"height\"]}]}\n=== x.txt\n{{furlongs}}\n")));
    const ProgramRun bad = runRelievo(source + "--target " + (folder / "bad.tpl") + " -o " + out + '3');
    EXPECT_EQ(bad.exitCode, 1);
    EXPECT_NE(bad.err.find("bad.tpl:3: {{furlongs}}"), std::string::npos) << bad.err;
    EXPECT_FALSE(fs::exists(out + '3'));
    EXPECT_EQ(runRelievo(source + "--target " + (folder / "none.tpl") + " -o " + out + '3').exitCode, 1);
    EXPECT_EQ(runRelievo(source + "--target nosuch -o " + out + '3').exitCode, 2);
    EXPECT_EQ(runRelievo(source + "--target bevy --without nosuch -o " + out + '3').exitCode, 2);
}

TEST(ExportCommand, DescribeTellsEveryTargetsFiles)
{
    const json rows = exportsOf(runRelievo("describe exports --json"));
    ASSERT_EQ(rows.size(), kExports.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i]["key"], kExports[i].key);
        if (rows[i]["suffix"] != "folder") {
            EXPECT_TRUE(rows[i]["files"].empty());
            continue;
        }
        const TestFolder folder("described");
        const std::string key = rows[i]["key"];
        ASSERT_EQ(runRelievo("export sample:bricks@16 --quiet --target " + key + " -o " + (folder / "out")).exitCode, 0) << key;
        std::set<std::string> names;
        for (const json& name : rows[i]["files"]) {
            std::string file = name;
            if (const auto at = file.find("NAME"); at != std::string::npos)
                file.replace(at, 4, "Bricks");
            names.insert(file);
        }
        for (const auto& entry : fs::directory_iterator(folder.path / "out"))
            EXPECT_TRUE(names.contains(entry.path().filename().string())) << key << ": " << entry.path();
    }
}
