// Projects and presets as JSON: what goes out comes back, what is wrong is told by name and place.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "core/state/presets.h"
#include "core/state/state_json.h"
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace relievo;
namespace fs = std::filesystem;

namespace {
State unusualState()
{
    State state;
    state.name = "Rust \"quoted\" \u00fc";
    state.parameters.depth = 0.1f;
    state.parameters.shading = Shading::BlinnPhong;
    state.parameters.tint = {0.1f, 0.2f, 0.3f};
    state.slots[0] = {"/a/b/height.png", Channel::A, true};
    state.slots[1] = {"sample:bricks", Channel::Rgb, false};
    state.mesh = "/a/mesh/pot.glb";
    state.environment = "/c/sky.hdr";
    state.camera.distance = 1.7f;
    state.camera.target = glm::vec3(0.1f, -2.f, 3.f);
    state.panes = {Pane{"bump"}, Pane{"relief", {{"depth", 0.2f}, {"shadows", false}}}};
    setView(state, "fetches");
    state.panes.push_back(Pane{.technique = "cell-cone", .overrides = {{"lightYaw", 10.f}}, .view = "error"});
    state.panes.back().camera.emplace().yaw = 12.f;
    return state;
}
bool warnsOf(const Warnings& warnings, std::string_view code, std::string_view place)
{
    for (const Warning& warning : warnings)
        if (warning.code == code && warning.text.find(place) != std::string::npos)
            return true;
    return false;
}
} // namespace

TEST(StateJson, RoundTrip)
{
    const State state = unusualState();
    const auto read = fromJson(State(), toJson(state, "/a/b"), "/a/b", "test");
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->warnings.empty());
    EXPECT_EQ(read->state, state);
}

TEST(StateJson, DeepValuesAreRefused)
{
    // Copying a list copies the lists in it by recursion; a member after the deep one made the library copy.
    for (const int depth : {300, 60'000, 1'000'000}) {
        const std::string nested = std::string(std::size_t(depth), '[') + std::string(std::size_t(depth), ']');
        const auto read = fromJson(State(), R"({"relievo":1,"a":)" + nested + R"(,"name":"x"})", "/x", "file");
        ASSERT_FALSE(read);
        EXPECT_NE(message(read.error()).find("nested too deeply"), std::string::npos);
    }
}

TEST(StateJson, TellsTenUnknownKeysAndCountsTheOthers)
{
    std::string text = R"({"relievo":1,"panes":[{"overrides":{"k":1}}],"parameters":{"depth":0.07)";
    for (int i = 0; i < 200'000; ++i)
        text += ",\"k" + std::to_string(i) + "\":1";
    const auto read = fromJson(State(), text + "}}", "/x", "file");
    ASSERT_TRUE(read);
    EXPECT_FLOAT_EQ(read->state.parameters.depth, 0.07f);
    ASSERT_EQ(read->warnings.size(), 11u);
    EXPECT_EQ(read->warnings.back(), (Warning{"unknown-key", "file: 199991 more unknown keys; ignored"}));
}

TEST(StateJson, NamesInMessagesAreShortAndEscaped)
{
    const std::string wild = "a\\u001b[2J\\nb" + std::string(1 << 20, 'x');
    const auto read
        = fromJson(State(), R"({"relievo":1,")" + wild + R"(":1,"view":")" + wild + R"(","maps":{")" + wild + R"(":{}}})", "/x", "file");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->warnings.size(), 3u);
    for (const Warning& warning : read->warnings) {
        EXPECT_LT(warning.text.size(), 200u);
        EXPECT_NE(warning.text.find("a\\x1B[2J\\nb"), std::string::npos) << warning.text;
    }
}

TEST(StateJson, WhatTheMeshFillsComesBack)
{
    State state;
    state.camera.fill = 0.87f;
    const auto read = fromJson(State{}, toJson(state, fs::current_path()), fs::current_path(), "x");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->state.camera, state.camera);
    EXPECT_EQ(toJson(State{}, fs::current_path()).find("fill"), std::string::npos) << "files say it only where it is used";
}

TEST(StateJson, PanesHoldViewsCamerasAndLightsOfTheirOwn)
{
    const auto read = fromJson(State(), R"({"relievo":1,"view":"depth","camera":{"yaw":5},"panes":[{"technique":"relief"},
        {"technique":"bump","view":"error","camera":{"yaw":9,"distance":3},"overrides":{"lightYaw":70}},{"technique":"flat","view":"nothing"}]})",
        "/x", "file");
    ASSERT_TRUE(read);
    const State& state = read->state;
    ASSERT_EQ(state.panes.size(), 3u);
    EXPECT_EQ(state.panes[0].view, "depth") << "one beside the panes is that of all that name none";
    EXPECT_EQ(state.panes[1].view, "error");
    EXPECT_EQ(state.panes[2].view, "depth");
    EXPECT_TRUE(warnsOf(read->warnings, "unknown-value", "panes[2].view"));
    EXPECT_EQ(cameraOf(state, 0).yaw, 5.f);
    EXPECT_EQ(cameraOf(state, 1).yaw, 9.f);
    EXPECT_EQ(effectiveParameters(state, 0).lightYaw, Parameters().lightYaw);
    EXPECT_EQ(effectiveParameters(state, 1).lightYaw, 70.f);
    EXPECT_EQ(effectiveParameters(state, 1).lightPitch, Parameters().lightPitch);
    State linked = state;
    setCameraOf(linked, 0, Camera{});
    EXPECT_EQ(cameraOf(linked, 2).yaw, Camera().yaw) << "linked panes share one";
    EXPECT_EQ(cameraOf(linked, 1).yaw, 9.f);
}

TEST(StateJson, WhatIsMeasuredIsTheFirstPaneAsItIsSeen)
{
    State state;
    state.panes = {Pane{.technique = "bump", .overrides = {{"depth", 0.2f}, {"lightYaw", 9.f}}, .view = "error"}, Pane{"flat"}};
    state.panes[0].camera.emplace().pitch = 7.f;
    const State plain = ofFirstPane(state);
    EXPECT_EQ(plain.panes, std::vector<Pane>{Pane{"bump"}});
    EXPECT_EQ(plain.parameters, effectiveParameters(state, 0));
    EXPECT_EQ(plain.camera.pitch, 7.f);
    ASSERT_TRUE(setParameter(state, "lightYaw=30"));
    EXPECT_EQ(effectiveParameters(state, 0).lightYaw, 30.f) << "what is asked for now wins over a pane's own light";
}

TEST(StateJson, SixPanesAreReadAndNoMore)
{
    std::string panes;
    for (int i = 0; i < 8; ++i)
        panes += (i == 0 ? "" : ",") + std::string(R"({"technique":"bump"})");
    const auto read = fromJson(State(), R"({"relievo":1,"panes":[)" + panes + "]}", "/x", "file");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->state.panes, std::vector<Pane>(kMaxPanes, Pane{"bump"}));
    EXPECT_TRUE(warnsOf(read->warnings, "out-of-range", "panes"));
    const auto bad
        = fromJson(State(), R"({"relievo":1,"panes":[{"technique":"bump","camera":{"fov":900}},{"camera":3,"light":1}]})", "/x", "file");
    ASSERT_TRUE(bad);
    EXPECT_TRUE(warnsOf(bad->warnings, "out-of-range", "panes[0].camera.fov"));
    EXPECT_TRUE(warnsOf(bad->warnings, "wrong-kind", "panes[1].camera"));
    EXPECT_TRUE(warnsOf(bad->warnings, "unknown-key", "panes[1].light"));
    EXPECT_FALSE(bad->state.panes[1].camera) << "what is no camera links nothing off";
}

TEST(StateJson, PathsAreRelativeToTheFile)
{
    const std::string text = toJson(unusualState(), "/a/b");
    EXPECT_NE(text.find("\"height.png\""), std::string::npos);
    EXPECT_NE(text.find("\"../mesh/pot.glb\""), std::string::npos);
    const auto moved = fromJson(State(), text, "/x/b", "test");
    ASSERT_TRUE(moved);
    EXPECT_EQ(moved->state.slots[0].file, "/x/b/height.png");
    EXPECT_EQ(moved->state.mesh, "/x/mesh/pot.glb");
}

TEST(StateJson, EveryParameterIsWritten)
{
    const auto json = nlohmann::json::parse(toJson(State(), "/"));
    for (const ParameterRow& row : kParameters)
        EXPECT_TRUE(json["parameters"].contains(row.key)) << row.key;
}

TEST(StateJson, PartialFilesKeepTheRest)
{
    const auto read = fromJson(unusualState(), R"({"relievo":1,"parameters":{"maxSteps":64}})", "/", "preset");
    ASSERT_TRUE(read);
    State wanted = unusualState();
    wanted.parameters.maxSteps = 64;
    EXPECT_EQ(read->state, wanted);
}

TEST(StateJson, UnknownKeysAndRangesAreToldByPlace)
{
    const auto read = fromJson(State(), R"({"relievo":1,"colour":3,"parameters":{"depth":9,"deep":1,"wrap":"mirror"},
        "panes":[{"technique":"magic","overrides":{"minSteps":-4}}],"camera":{"pitch":200,"roll":1},"maps":{"hight":{},"height":{"channel":"q","x":1}}})",
        "/", "file.relievo");
    ASSERT_TRUE(read);
    EXPECT_TRUE(warnsOf(read->warnings, "unknown-key", "file.relievo: colour"));
    EXPECT_TRUE(warnsOf(read->warnings, "out-of-range", "parameters.depth"));
    EXPECT_TRUE(warnsOf(read->warnings, "unknown-key", "parameters.deep"));
    EXPECT_TRUE(warnsOf(read->warnings, "wrong-kind", "parameters.wrap"));
    EXPECT_TRUE(warnsOf(read->warnings, "unknown-value", "panes[0].technique"));
    EXPECT_TRUE(warnsOf(read->warnings, "out-of-range", "panes[0].overrides.minSteps"));
    EXPECT_TRUE(warnsOf(read->warnings, "out-of-range", "camera.pitch"));
    EXPECT_TRUE(warnsOf(read->warnings, "unknown-key", "camera.roll"));
    EXPECT_TRUE(warnsOf(read->warnings, "unknown-key", "maps.hight"));
    EXPECT_TRUE(warnsOf(read->warnings, "unknown-value", "maps.height.channel"));
    EXPECT_EQ(read->state.parameters.depth, 1.5f);
    EXPECT_EQ(read->state.panes[0].technique, "relief");
    EXPECT_EQ(std::get<int>(read->state.panes[0].overrides.at("minSteps")), 1);
}

TEST(StateJson, WrongKindsLeaveTheDefault)
{
    const auto read = fromJson(State(), R"({"relievo":1,"mesh":null,"environment":7,"parameters":{"minSteps":8.7}})", "/x", "file");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->state, State());
    EXPECT_EQ(read->warnings.size(), 3u);
}

TEST(StateJson, AFilesPanesOverrideItsParametersInAnyOrder)
{
    const auto read = fromJson(
        State(), R"({"relievo":1,"panes":[{"technique":"relief","overrides":{"depth":0.2}}],"parameters":{"depth":0.1}})", "/x", "file");
    ASSERT_TRUE(read);
    EXPECT_EQ(effectiveParameters(read->state, 0).depth, 0.2f);
    const auto preset = fromJson(read->state, R"({"relievo":1,"parameters":{"depth":0.3}})", "/x", "preset");
    EXPECT_EQ(effectiveParameters(preset->state, 0).depth, 0.3f);
}

TEST(StateJson, ForeignAndNewerFilesAreRefused)
{
    for (const char* text : {"", "{", "[]", "3", "{}", R"({"relievo":"1"})", R"({"relievo":2})", R"({"relievo":0})", R"({"relievo":-7})",
             R"({"relievo":18446744073709551615})"}) {
        const auto read = fromJson(State(), text, "/", "x.relievo");
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().where, "x.relievo");
        EXPECT_FALSE(read.error().hint.empty());
    }
}

TEST(StateJson, DeeplyNestedListsAreToldNotFollowed)
{
    const std::string deep = std::string(200, '[') + std::string(200, ']'); // deeper ones are refused
    for (const std::string& camera : {R"("yaw":)" + deep, R"("target":[)" + deep + ",0,0]", R"("distance":"1")" + std::string()}) {
        const auto read = fromJson(State(), R"({"relievo":1,"camera":{)" + camera + "}}", "/", "x.relievo");
        ASSERT_TRUE(read);
        EXPECT_EQ(read->state, State());
        EXPECT_TRUE(warnsOf(read->warnings, "wrong-kind", "camera."));
    }
}

TEST(StateJson, BackslashesNameFoldersWhereNoSuchFileIs)
{
    const auto fileOf = [](const fs::path& folder) {
        const auto read = fromJson(State(), R"({"relievo":1,"maps":{"color":{"file":"tex\\a.png"}}})", folder, "x.relievo");
        return read->state.slots[std::size_t(MapKind::Color)].file;
    };
    const fs::path folder = fs::temp_directory_path() / "relievo_backslash_test";
    fs::create_directories(folder);
    EXPECT_EQ(fileOf(folder), (folder / "tex/a.png").string());
    ASSERT_TRUE(writeAtomically(folder / "tex\\a.png", std::string_view("x")));
    EXPECT_EQ(fileOf(folder), (folder / "tex\\a.png").string());
    fs::remove_all(folder);
}

TEST(StateJson, PathsBesideALinkedFolderComeBack)
{
    const fs::path folder = fs::canonical(fs::temp_directory_path()) / "relievo_linked_test";
    fs::remove_all(folder);
    fs::create_directories(folder / "far/project");
    fs::create_directories(folder / "tex");
    fs::create_directory_symlink(folder / "far/project", folder / "link");
    State state;
    state.slots[0].file = (folder / "tex/h.png").string();
    const auto read = fromJson(State(), toJson(state, folder / "link"), folder / "link", "x.relievo");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->state.slots[0].file, state.slots[0].file);
    EXPECT_EQ(absolutePath(folder / "link/../x"), folder / "far/x");
    EXPECT_EQ(absolutePath(folder / "./link//x"), folder / "link/x");
    fs::remove_all(folder);
}

TEST(StateJson, PresetsOfTheProgramAreSound)
{
    for (const PresetRow& row : kPresets) {
        const auto read = readPreset(State(), std::string(row.key));
        ASSERT_TRUE(read) << row.key;
        EXPECT_TRUE(read->warnings.empty()) << row.key;
    }
    const auto missing = readPreset(State(), "no-such-preset");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().hint.find("game"), std::string::npos);
}

TEST(StateJson, PresetHoldsNoFiles)
{
    const std::string text = toPresetJson(unusualState());
    EXPECT_EQ(text.find("\"name\""), std::string::npos); // it would rename the material it is laid on
    EXPECT_EQ(text.find("height.png"), std::string::npos);
    const auto read = fromJson(State(), text, "/", "preset");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->state.parameters, unusualState().parameters);
    EXPECT_EQ(read->state.panes[0].technique, "bump");
    EXPECT_TRUE(read->state.slots[0].empty());
}

TEST(File, WritesAreAtomicAndErrorsNameTheFile)
{
    const fs::path folder = fs::temp_directory_path() / "relievo_file_test";
    fs::remove_all(folder);
    const auto missing = writeAtomically(folder / "a.txt", std::string_view("x"));
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().where, (folder / "a.txt").string());
    fs::create_directories(folder);
    ASSERT_TRUE(writeAtomically(folder / "a.txt", std::string_view("old")));
    ASSERT_TRUE(writeAtomically(folder / "a.txt", std::string_view("new")));
    EXPECT_EQ(*readText(folder / "a.txt"), "new");
    EXPECT_FALSE(writeAtomically(folder, std::string_view("x")));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1); // no litter
    EXPECT_EQ(readText(folder).error().code, ErrorCode::Refused);
    EXPECT_EQ(readText(folder / "none").error().code, ErrorCode::NotFound);
    fs::remove_all(folder);
}

TEST(File, AFailedWriteKeepsTheOldFile)
{
    const fs::path file = fs::temp_directory_path() / "relievo_plain_file";
    ASSERT_TRUE(writeAtomically(file, std::string_view("kept")));
    EXPECT_FALSE(writeAtomically(file / "below", std::string_view("x"))); // its parent is no folder
    EXPECT_EQ(*readText(file), "kept");
    fs::remove(file);
}

TEST(File, SavingKeepsRightsLinksAndLongNames)
{
    const fs::path folder = fs::temp_directory_path() / "relievo_rights_test";
    fs::remove_all(folder);
    fs::create_directories(folder);
    const fs::path file = folder / "private.txt", link = folder / "link.txt", longest = folder / std::string(255, 'x');
    ASSERT_TRUE(writeAtomically(file, std::string_view("old")));
    const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
    fs::permissions(file, own);
    ASSERT_TRUE(writeAtomically(file, std::string_view("new")));
    EXPECT_EQ(fs::status(file).permissions(), own);
    fs::create_symlink("made.txt", link);
    ASSERT_TRUE(writeAtomically(link, std::string_view("through")));
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(*readText(folder / "made.txt"), "through");
    fs::create_symlink("loop.txt", folder / "loop.txt");
    EXPECT_FALSE(writeAtomically(folder / "loop.txt", std::string_view("x")));
    const auto written = writeAtomically(longest, std::string_view("x"));
    EXPECT_TRUE(written) << message(written.error());
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 5); // no litter
    fs::remove_all(folder);
}
