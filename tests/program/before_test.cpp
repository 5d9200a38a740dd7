// Projects, presets and exports of an earlier version (tests/program/before) open without a warning, to the pictures that it drew of them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "core/image/files/image_file.h"
#include "tests/program/run.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const fs::path kBefore = RELIEVO_SOURCE "/tests/program/before";

// Another rasteriser rounds otherwise: so many pixels may differ by more than so many of 255 steps.
constexpr int kLargestDifference = 4;
constexpr double kShareBeyond = 0.01;

// Share of the pixels in which a channel differs by more than kLargestDifference.
double differing(const relievo::Image& a, const relievo::Image& b)
{
    const std::size_t channels = std::size_t(a.channels);
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < a.texelCount() * channels; i += channels) {
        int worst = 0;
        for (std::size_t k = i; k < i + channels; ++k)
            worst = std::max(worst, std::abs(std::to_integer<int>(a.data[k]) - std::to_integer<int>(b.data[k])));
        beyond += worst > kLargestDifference;
    }
    return double(beyond) / double(a.texelCount());
}

// Draws `arguments` and compares with `picture`; returns the warnings' codes.
std::vector<std::string> expectPicture(const std::string& arguments, const fs::path& picture)
{
    TestFolder folder("before");
    const std::string drawn = folder / "x.png";
    const ProgramRun run = runRelievo("render --size 64x48 --json " + arguments + " -o " + drawn);
    EXPECT_EQ(run.exitCode, 0) << arguments << run.err;
    const auto expected = relievo::readImage(picture), found = relievo::readImage(drawn);
    if (run.exitCode != 0 || !expected || !found) {
        ADD_FAILURE() << picture << " has nothing to be compared with";
        return {};
    }
    const auto shape = [](const relievo::Image& image) { return std::tuple(image.width, image.height, image.channels, image.type); };
    const bool comparable = shape(expected->image) == shape(found->image);
    EXPECT_TRUE(comparable) << picture;
    EXPECT_LE(comparable ? differing(expected->image, found->image) : 1., kShareBeyond) << arguments << " is not " << picture;
    std::vector<std::string> codes;
    const json told = json::parse(run.out);
    for (const json& warning : told["warnings"])
        if (warning["code"] != "relief-too-deep") // said since of what was drawn then
            codes.push_back(warning["code"]);
    return codes;
}

const std::vector<std::string> kNothing;

std::vector<fs::path> filesOf(const std::string& folder, const std::string& suffix)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(kBefore / folder))
        if (entry.path().extension() == suffix)
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace

TEST(Before, ProjectsOpenToTheSamePictures)
{
    const auto projects = filesOf("projects", ".relievo");
    EXPECT_EQ(projects.size(), 15u);
    for (const fs::path& project : projects) {
        const json state = json::parse(*relievo::readText(project));
        const std::string view = " --view " + state["view"].get<std::string>();
        EXPECT_EQ(expectPicture(project.string() + view, fs::path(project).replace_extension(".png")), kNothing) << project;
    }
}

// The command line draws the first pane: the second one is drawn with the two swapped.
TEST(Before, TheSecondPaneIsTheSamePicture)
{
    const auto pictures = filesOf("projects/second", ".png");
    EXPECT_EQ(pictures.size(), 2u);
    for (const fs::path& picture : pictures) {
        json state = json::parse(*relievo::readText(kBefore / "projects" / picture.stem().concat(".relievo")));
        ASSERT_EQ(state["panes"].size(), 2u) << picture;
        std::swap(state["panes"][0], state["panes"][1]);
        TestFolder folder("swapped");
        ASSERT_TRUE(relievo::writeAtomically(folder / "x.relievo", std::string_view(state.dump())));
        EXPECT_EQ(expectPicture(folder / "x.relievo --view " + state["view"].get<std::string>(), picture), kNothing) << picture;
    }
}

TEST(Before, PresetsGiveTheSamePictures)
{
    const auto presets = filesOf("presets", ".json");
    EXPECT_EQ(presets.size(), 2u);
    for (const fs::path& preset : presets)
        EXPECT_EQ(expectPicture("sample:scales@64 --preset " + preset.string(), fs::path(preset).replace_extension(".png")), kNothing)
            << preset;
}

TEST(Before, ExportsOpenToTheSamePictures)
{
    EXPECT_EQ(expectPicture((kBefore / "exports/box.glb").string(), kBefore / "exports/box.png"), kNothing);
    EXPECT_EQ(expectPicture((kBefore / "exports/textures").string(), kBefore / "exports/textures.png"),
        std::vector<std::string>{"relief-json"}); // says where depth and technique come from
}
