// Every real texture set beside the checkout: named right, drawn, traced alike by CPU and GPU.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "tests/program/run.h"
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const fs::path kMaterials = fs::path(RELIEVO_TEST_DATA) / "materials";

std::vector<std::string> setNames()
{
    std::vector<std::string> names;
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(kMaterials, code))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

// Sets in containers that Relievo does not read.
bool mayBeRefused(const std::string& name)
{
    return name.find("ktx") != name.npos || name.find("rawf32") != name.npos;
}

std::string raysText()
{
    std::mt19937 random(77);
    std::uniform_real_distribution<float> unit(0.f, 1.f);
    std::ostringstream text;
    text << "u,v,du,dv\n";
    for (int i = 0; i < 10000; ++i) {
        const float angle = 6.2831853f * unit(random), travel = 0.08f * std::tan(1.5f * unit(random));
        text << unit(random) << ',' << unit(random) << ',' << travel * std::cos(angle) << ',' << travel * std::sin(angle) << '\n';
    }
    return text.str();
}

// All techniques but those whose maps take seconds to bake.
const std::vector<std::string> kSoonReady
    = {"flat", "bump", "parallax", "steep", "pom", "contact", "interval", "relief", "relief-fixed", "pyramid", "cell-cone"};

class RealSet : public testing::TestWithParam<std::string> { };

} // namespace

TEST(RealSets, AreThere)
{
    if (setNames().empty())
        GTEST_SKIP() << "no texture sets at " << kMaterials;
    SUCCEED();
}

TEST_P(RealSet, IsDrawn)
{
    TestFolder folder("set_" + GetParam());
    const std::string set = (kMaterials / GetParam()).string();
    const ProgramRun info = runRelievo("info --json " + set);
    if (mayBeRefused(GetParam())) {
        EXPECT_EQ(info.exitCode, 1);
        EXPECT_NE(info.err.find("cannot be read"), std::string::npos) << info.err;
        return;
    }
    ASSERT_EQ(info.exitCode, 0) << info.err;
    const json found = json::parse(info.out);
    const bool hasHeight = std::any_of(found["maps"].begin(), found["maps"].end(), [](const json& map) { return map["kind"] == "height"; });
    for (const std::string& technique : kSoonReady) {
        const std::string out = folder / (technique + ".png");
        const ProgramRun run = runRelievo("render " + set + " --technique " + technique + " --size 64x48 --samples 1 -o " + out);
        const bool possible = hasHeight || technique == "flat" || technique == "bump";
        EXPECT_EQ(run.exitCode, possible ? 0 : 1) << technique << run.err;
        EXPECT_EQ(fs::exists(out), possible) << technique;
        if (!possible) {
            EXPECT_NE(run.err.find("height map"), std::string::npos) << run.err;
        }
    }
}

TEST_P(RealSet, CpuAndGpuTraceAlike)
{
    if (mayBeRefused(GetParam()) || GetParam().find("no_height") != std::string::npos)
        return;
    TestFolder folder("trace_" + GetParam());
    ASSERT_TRUE(relievo::writeAtomically(folder / "rays.csv", raysText()));
    for (const std::string technique : {"flat", "bump", "parallax", "relief"}) {
        std::vector<std::vector<double>> t(2);
        for (const int device : {0, 1}) {
            const ProgramRun run = runRelievo("trace " + (kMaterials / GetParam()).string() + " --technique " + technique + " --device "
                + (device ? "gl" : "cpu") + " --rays " + (folder / "rays.csv") + " -o " + (folder / "hits.csv"));
            ASSERT_EQ(run.exitCode, 0) << run.err;
            std::ifstream in(folder / "hits.csv");
            std::string line;
            std::getline(in, line);
            while (std::getline(in, line))
                t[std::size_t(device)].push_back(std::stod(line.substr(2)));
        }
        ASSERT_EQ(t[0].size(), 10000u);
        ASSERT_EQ(t[1].size(), 10000u);
        int apart = 0;
        for (std::size_t i = 0; i < t[0].size(); ++i)
            apart += !(std::abs(t[0][i] - t[1][i]) < 1e-4);
        EXPECT_LE(apart, 10) << technique; // 99.9 %
    }
}

// CONVENTIONS.tsv: set, normal file, height file, height channel, ..., height polarity, normal convention.
TEST(RealSets, ConventionsAreTheMeasuredTruth)
{
    std::ifstream table(fs::path(RELIEVO_TEST_DATA) / "CONVENTIONS.tsv");
    if (!table)
        GTEST_SKIP() << "no CONVENTIONS.tsv at " << RELIEVO_TEST_DATA;
    std::string line;
    std::getline(table, line);
    int sets = 0;
    for (; std::getline(table, line); ++sets) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, '\t');)
            cells.push_back(cell);
        const ProgramRun info = runRelievo("info --json " + (kMaterials / cells[0]).string());
        ASSERT_EQ(info.exitCode, 0) << info.err;
        const json found = json::parse(info.out);
        std::map<std::string, json> byKind;
        for (const json& map : found["maps"])
            byKind[map["kind"]] = map;
        EXPECT_EQ(byKind["normal"]["file"], cells[1]) << cells[0];
        EXPECT_EQ(byKind["height"]["file"], cells[2]) << cells[0];
        EXPECT_EQ(byKind["height"]["channel"] == "a", cells[3] == "A") << cells[0];
        EXPECT_EQ(byKind["height"]["convention"], cells[6].substr(0, cells[6].find(' '))) << cells[0];
        EXPECT_EQ(byKind["normal"]["convention"], cells[7].rfind("GL", 0) == 0 ? "gl" : "dx") << cells[0];
    }
    EXPECT_GE(sets, 10);
}

INSTANTIATE_TEST_SUITE_P(Materials, RealSet, testing::ValuesIn(setNames()), [](const auto& tested) {
    std::string name = tested.param;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealSet);
