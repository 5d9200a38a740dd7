// relievo report, tune and compare as a user calls them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ground/file.h"
#include "tests/program/run.h"
#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using nlohmann::json;
namespace fs = std::filesystem;

namespace {
const std::string kSource = "hard:bricks@48 ";
}

TEST(Measuring, ReportInAllForms)
{
    TestFolder folder("report");
    const std::string options = " --fast --rays 60 --techniques parallax,relief --quiet";
    ProgramRun run = runRelievo("report " + kSource + "-o " + (folder / "r.json") + options);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json report = json::parse(*relievo::readText(folder / "r.json"));
    EXPECT_EQ(report["title"], "Rough bricks");
    EXPECT_EQ(report["settings"].size(), 8u); // parallax with and without limiting, relief with six step counts
    EXPECT_EQ(report["rays"].size(), 8u * 4u);
    EXPECT_EQ(report["pictures"].size(), 8u * 4u);
    for (const json& row : report["pictures"]) {
        EXPECT_GT(row["msRatio"].get<double>(), 0.);
        EXPECT_TRUE(row["flip"].get<double>() >= 0. && row["flip"].get<double>() < 1.);
    }
    // More steps come closer to the exact picture.
    EXPECT_GT(report["pictures"][8 * 3 + 2]["flip"].get<double>(), report["pictures"].back()["flip"].get<double>());

    run = runRelievo("report " + kSource + "--no-pictures --json --angles 0-10,85-89 -o " + (folder / "r.html") + options);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["rays"], 16);
    const std::string html = *relievo::readText(folder / "r.html");
    EXPECT_NE(html.find("85\u201389\u00b0"), html.npos);
    EXPECT_NE(html.find("data:image/png;base64,iVBORw0KGgo"), html.npos); // heat maps, without a context too
    run = runRelievo("report " + kSource + "--no-pictures -o " + (folder / "r.csv") + options);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(relievo::readText(folder / "r.csv")->starts_with("technique,setting,field,view,rays,wrong,ties,meanFetches,"));
}

// The pictures are of a filling plane, whatever the project's mesh and its first pane's overrides are.
TEST(Measuring, PicturesAreOfThePlaneAtFullResolution)
{
    TestFolder folder("plane");
    std::ofstream(folder / "p.relievo")
        << R"({"relievo":1,"mesh":"sphere","panes":[{"technique":"relief","overrides":{"heightMips":true,"tiling":1}}]})";
    const auto flip = [&](const std::string& state) {
        const ProgramRun run
            = runRelievo("report " + kSource + state + "--fast --rays 20 --techniques parallax --quiet -o " + (folder / "r.json"));
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return json::parse(*relievo::readText(folder / "r.json"))["pictures"].back()["flip"].get<double>();
    };
    const double wanted = flip("");
    EXPECT_NEAR(flip("--preset " + (folder / "p.relievo") + ' '), wanted, 1e-6);
    const auto error = [&](const std::string& state) {
        const ProgramRun run = runRelievo("tune " + kSource + state + "--metric pixels --max-error 100 --rays 20 --techniques flat --json");
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return json::parse(run.out)["error"].get<double>();
    };
    EXPECT_NEAR(error("--mesh sphere "), error(""), 1e-6);
}

TEST(Measuring, CompareLooksAtFullResolution)
{
    TestFolder folder("overrides");
    std::ofstream(folder / "p.relievo") << R"({"relievo":1,"panes":[{"technique":"relief","overrides":{"heightMips":true}}]})";
    const auto psnr = [&](const std::string& state) {
        const ProgramRun run
            = runRelievo("compare hard:bricks@512 --set tiling=8 " + state + "--techniques parallax --json -o " + (folder / "s.png"));
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return json::parse(run.out)["techniques"][0]["psnr"].get<double>();
    };
    EXPECT_NEAR(psnr("--preset " + (folder / "p.relievo") + ' '), psnr(""), 1e-6);
}

TEST(Measuring, QuotesInNamesStayInTheirField)
{
    TestFolder folder("quotes");
    ASSERT_EQ(runRelievo("render sample:bricks@16 --view depth --size 16x16 -o " + (folder / "plain.png")).exitCode, 0);
    fs::rename(folder / "plain.png", folder / "we\"ird_height.png");
    const ProgramRun run
        = runRelievo("report '" + (folder / "we\"ird_height.png") + "' --rays 5 --no-pictures --techniques flat -o " + (folder / "r.csv"));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_NE(relievo::readText(folder / "r.csv")->find("we\"\"ird_height.png\","), std::string::npos);
}

TEST(Measuring, ReportOnAMesh)
{
    TestFolder folder("report");
    const std::string command = "report " + kSource + "--mesh box --fast --rays 10 --techniques bump --quiet -o ";
    ProgramRun run = runRelievo(command + (folder / "r.json"));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json mesh = json::parse(*relievo::readText(folder / "r.json"))["mesh"];
    EXPECT_EQ(mesh["name"], "Box");
    EXPECT_GT(mesh["displacedTriangles"], 10000);
    ASSERT_EQ(mesh["rows"].size(), 10u);
    EXPECT_EQ(mesh["rows"][0]["msRatio"], 1.);
    EXPECT_GT(mesh["rows"][0]["coveragePercent"], 0.5);
    for (int kind = 1; kind < 4; ++kind)
        EXPECT_LT(mesh["rows"][kind]["coveragePercent"].get<double>(), 0.2 * mesh["rows"][0]["coveragePercent"].get<double>()) << kind;
    run = runRelievo(command + (folder / "r.html"));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_NE(relievo::readText(folder / "r.html")->find("<h2>On the mesh</h2>"), std::string::npos);
}

// Far away a filter is nearer to the supersampled picture than none is, in each form of the report; the line of each has all columns.
TEST(Measuring, FarViewsTellWhatEachFilterGetsWrong)
{
    TestFolder folder("far");
    const std::string report = "report sample:bricks@128 --far-views --fast --rays 5 --techniques bump --quiet ";
    ProgramRun run = runRelievo("bake sample:bricks@128 --map normal --quiet -o " + (folder / "n.png"));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const std::string command = report + "--normal " + (folder / "n.png") + " -o ";
    run = runRelievo(command + (folder / "r.json"));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json far = json::parse(*relievo::readText(folder / "r.json"))["farViews"];
    ASSERT_EQ(far["rows"].size(), 8u * 6u);
    const auto error = [&](const char* label, double texels) {
        const auto row = std::ranges::find_if(far["rows"],
            [&](const json& line) { return line["label"] == label && line["degrees"] == 30. && line["texelsAPixel"] == texels; });
        return row == far["rows"].end() ? -1. : (*row)["lightRmsePercent"].get<double>();
    };
    EXPECT_LT(error("anisotropy 16", 16.), 0.6 * error("none", 16.));
    EXPECT_LT(error("none", 1.), error("none", 16.));
    for (const json& line : far["rows"])
        EXPECT_LT(std::abs(line["brightnessStops"].get<double>()), 2.) << line;

    run = runRelievo(command + (folder / "r.csv"));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    std::ifstream csv(folder / "r.csv");
    std::string line, head;
    std::getline(csv, head);
    EXPECT_TRUE(head.ends_with(",brightnessStops,lightRmsePercent"));
    int lines = 0;
    for (; std::getline(csv, line); lines += line.find(",far ") != line.npos)
        EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(head, ',')) << line;
    EXPECT_EQ(lines, 8 * 6);
}

TEST(Measuring, ReportOnTheHardCases)
{
    TestFolder folder("hard");
    const ProgramRun run
        = runRelievo("report --hard-cases --size 16 --rays 20 --no-pictures --techniques relief --quiet -o " + (folder / "r.json"));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json report = json::parse(*relievo::readText(folder / "r.json"));
    EXPECT_EQ(report["fields"].size(), 20u);
    EXPECT_EQ(report["fields"][0]["key"], "needles");
    EXPECT_EQ(report["rays"].size(), 20u * 6u * 4u);
    EXPECT_TRUE(report["pictures"].empty());
    const ProgramRun pictured
        = runRelievo("report --hard-cases --size 16 --rays 20 --fast --techniques parallax --json --quiet -o " + (folder / "r.html"));
    ASSERT_EQ(pictured.exitCode, 0) << pictured.err;
    EXPECT_EQ(json::parse(pictured.out)["pictures"], 4 * 4 * 2); // four fields, four angles, with and without limiting
    EXPECT_NE(relievo::readText(folder / "r.html")->find("Means over Needles, Terraces, Rough bricks, Smooth waves."), std::string::npos);
}

TEST(Measuring, SeveralSourcesAreOneReportWithTotals)
{
    TestFolder folder("several");
    const ProgramRun run = runRelievo("report sample:bricks@32 hard:needles@16 --hard-cases --size 16 --rays 20 --no-pictures "
                                      "--techniques cell-cone,pyramid --quiet -o "
        + (folder / "r.json"));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json report = json::parse(*relievo::readText(folder / "r.json"));
    ASSERT_EQ(report["fields"].size(), 22u);
    EXPECT_EQ(report["title"], "2 materials and hard cases");
    EXPECT_EQ(report["fields"][1]["key"], "hard:needles@16");
    ASSERT_EQ(report["totals"].size(), 2u * 4u);
    EXPECT_EQ(report["totals"][0]["field"], "all fields");
    double rays = 0., fetches = 0., wrong = 0.;
    for (const json& line : report["rays"])
        if (line["technique"] == "pyramid" && line["fromDegrees"] == 88.) {
            rays += line["rays"].get<double>(), wrong += line["wrong"].get<double>();
            fetches += line["rays"].get<double>() * line["meanFetches"].get<double>();
        }
    const auto total = std::ranges::find_if(
        report["totals"], [](const json& line) { return line["technique"] == "pyramid" && line["fromDegrees"] == 88.; });
    ASSERT_NE(total, report["totals"].end());
    EXPECT_EQ((*total)["rays"], rays);
    EXPECT_EQ((*total)["wrong"], wrong);
    EXPECT_NEAR((*total)["meanFetches"].get<double>(), fetches / rays, 1e-9);
}

TEST(Measuring, EqualSeedsGiveEqualReports)
{
    TestFolder folder("seeds");
    const auto text = [&](const std::string& seed) {
        const ProgramRun run
            = runRelievo("report " + kSource + "--no-pictures --techniques relief --rays 50 --seed " + seed + " -o " + (folder / "r.csv"));
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return *relievo::readText(folder / "r.csv");
    };
    EXPECT_EQ(text("4"), text("4"));
    EXPECT_NE(text("4"), text("5"));
}

TEST(Measuring, TuneProvesWhatItChooses)
{
    TestFolder folder("tune");
    ProgramRun run = runRelievo(
        "tune " + kSource + "--techniques parallax,relief --max-error 0.2 --max-missed 60 --json -o " + (folder / "p.relievo"));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json tuned = json::parse(run.out);
    EXPECT_EQ(tuned["found"], true);
    EXPECT_EQ(tuned["technique"], "relief");
    EXPECT_LE(tuned["error"].get<double>(), 0.2);
    EXPECT_LE(tuned["missedPercent"].get<double>(), 60.);
    EXPECT_EQ(tuned["views"].size(), 4u);
    for (const json& tried : tuned["tried"]) // everything cheaper fails
        if (tried["meanFetches"] < tuned["meanFetches"]) {
            EXPECT_EQ(tried["within"], false) << tried.dump();
        }
    const json project = json::parse(*relievo::readText(folder / "p.relievo"));
    EXPECT_EQ(project["panes"][0]["technique"], "relief");
    EXPECT_EQ(project["parameters"]["maxSteps"], tuned["parameters"]["maxSteps"]);
    EXPECT_NEAR(project["parameters"]["depth"].get<double>(), 0.08, 1e-6);
    run = runRelievo("tune " + (folder / "p.relievo") + " --techniques relief --max-error 0.2 --max-missed 60");
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(run.out.starts_with(tuned["setting"].get<std::string>())) << run.out;
}

TEST(Measuring, EnginesHaveATableOfTheirOwn)
{
    TestFolder folder("engines");
    const auto report = [&](const std::string& options) {
        const ProgramRun run
            = runRelievo("report " + kSource + "--no-pictures --rays 20 --quiet " + options + " -o " + (folder / "r.json"));
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return json::parse(*relievo::readText(folder / "r.json"));
    };
    const json all = report("");
    EXPECT_EQ(all["engines"].size(), 11u * 3u); // at 30, 60 and 80 degrees
    for (const json& line : all["engines"]) {
        EXPECT_TRUE(line["technique"].get<std::string>().starts_with("as-")) << line;
        EXPECT_GT(line["meanError"].get<double>(), 0.) << line;
    }
    for (const json& setting : all["settings"])
        EXPECT_FALSE(setting["technique"].get<std::string>().starts_with("as-")) << setting;
    const json one = report("--techniques as-godot4-simple,flat");
    EXPECT_EQ(one["engines"].size(), 3u);
    EXPECT_EQ(one["settings"].size(), 2u); // measured like any other too
    EXPECT_NEAR(one["engines"][0]["degrees"].get<double>(), 30., 0.);
    EXPECT_LT(one["engines"][2]["depthDrawn"], one["engines"][0]["depthDrawn"]);
}

TEST(Measuring, EnginesAreTunedOnlyByName)
{
    ProgramRun run = runRelievo("tune " + kSource + "--rays 20 --max-error 1 --max-missed 100 --json");
    ASSERT_EQ(run.exitCode, 0) << run.err;
    for (const json& tried : json::parse(run.out)["tried"])
        EXPECT_FALSE(tried["technique"].get<std::string>().starts_with("as-"));
    run = runRelievo("tune " + kSource + "--rays 20 --max-error 1 --max-missed 100 --json --techniques as-bevy");
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["technique"], "as-bevy");
}

TEST(Measuring, TuneOnPictures)
{
    for (const char* metric : {"pixels --max-error 4", "flip --max-error 0.2"}) {
        const ProgramRun run = runRelievo("tune " + kSource + "--techniques flat,relief --rays 50 --json --metric " + metric);
        ASSERT_EQ(run.exitCode, 0) << run.err;
        const json tuned = json::parse(run.out);
        EXPECT_EQ(tuned["technique"], "relief") << metric;
        EXPECT_GT(tuned["error"].get<double>(), 0.);
    }
}

TEST(Measuring, TuneWithoutAnAnswerIsThree)
{
    TestFolder folder("none");
    const ProgramRun run
        = runRelievo("tune hard:needles@32 --techniques parallax,relief --rays 200 --max-error 0.000001 -o " + (folder / "p.relievo"));
    EXPECT_EQ(run.exitCode, 3);
    EXPECT_TRUE(run.err.starts_with("relievo: error: ")) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.out.find("Relief"), std::string::npos); // the best there is
    EXPECT_NE(run.err.find("--max-error 1e-06"), std::string::npos) << run.err; // what was asked for, not 0
    EXPECT_FALSE(fs::exists(folder / "p.relievo"));
    const ProgramRun best
        = runRelievo("tune sample:bricks@64 --metric flip --max-error 0.0001 --max-missed 5 --techniques relief --rays 100");
    EXPECT_EQ(best.exitCode, 3);
    EXPECT_EQ(best.out.find(" -  "), std::string::npos) << best.out; // not a setting whose error nobody asked for
    EXPECT_EQ(runRelievo("tune " + kSource + "--techniques relief --max-error 0.5 --max-fetches 1").exitCode, 3);
}

TEST(Measuring, CompareWritesASheet)
{
    TestFolder folder("compare");
    const ProgramRun run = runRelievo(
        "compare " + kSource + "--techniques flat,parallax,relief --json -o " + (folder / "s.png") + " --csv " + (folder / "s.csv"));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(relievo::readText(folder / "s.png")->starts_with("\x89PNG"));
    const json cells = json::parse(run.out)["techniques"];
    ASSERT_EQ(cells.size(), 3u);
    EXPECT_EQ(cells[0]["fetchesPerPixel"], 0.);
    EXPECT_EQ(cells[1]["fetchesPerPixel"], 1.);
    EXPECT_LT(cells[2]["depthRmse"], cells[0]["depthRmse"]);
    EXPECT_LT(cells[2]["flip"], cells[1]["flip"]);
    const std::string csv = *relievo::readText(folder / "s.csv");
    EXPECT_TRUE(csv.starts_with("technique,setting,fetchesPerPixel,"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
    const ProgramRun info = runRelievo("info " + (folder / "s.png") + " --json");
    EXPECT_EQ(json::parse(info.out)["maps"][0]["width"], 3 * 480 + 4 * 20);
}

TEST(Measuring, WrongInputIsToldInOneSentence)
{
    TestFolder folder("wrong");
    const std::string out = " -o " + (folder / "x.json"), sheet = " -o " + (folder / "x.png");
    for (const auto& [arguments, code] :
        std::vector<std::pair<std::string, int>>{{"report" + out, 2}, {"report " + kSource, 2}, {"report " + kSource + "-o x.gif", 2},
            {"report " + kSource + out + " --techniques magic", 2}, {"report " + kSource + out + " --techniques reference", 2},
            {"report " + kSource + out + " --angles 10", 2}, {"report " + kSource + out + " --angles 80-60", 2},
            {"report " + kSource + out + " --angles 0-90", 2}, {"report " + kSource + "sample:nothing" + out, 1},
            {"report " + kSource + out + " --size 64", 2}, {"report " + kSource + out + " --far-views --no-pictures", 2},
            {"report " + kSource + out + " --rays 0", 2}, {"report hard:nothing" + out, 1}, {"tune " + kSource, 2},
            {"tune " + kSource + "--max-error -1", 2}, {"tune " + kSource + "--max-error 1 --metric taste", 2},
            {"tune " + kSource + "--max-error 1 --max-missed 101", 2}, {"tune " + kSource + "--max-error 1 -o x.png", 2},
            {"tune " + kSource + "--max-error nan", 2}, {"tune " + kSource + "--max-error 1 --max-missed nan", 2},
            {"tune none.png --max-error 1", 1}, {"compare " + kSource, 2}, {"compare " + kSource + "-o x.jpg", 2},
            {"compare " + kSource + sheet + " --techniques relief,magic", 2}, {"compare none.png" + sheet, 1}}) {
        const ProgramRun run = runRelievo(arguments);
        EXPECT_EQ(run.exitCode, code) << arguments << run.err;
        EXPECT_FALSE(run.err.empty()) << arguments;
    }
    EXPECT_TRUE(fs::is_empty(folder.path));
}

// A material of colours alone has nothing to search.
TEST(Measuring, AMaterialWithoutHeightsIsRefused)
{
    TestFolder folder("colours");
    ASSERT_EQ(runRelievo("render sample:bricks@16 --view color --size 16x16 -o " + (folder / "wall_color.png")).exitCode, 0);
    for (const std::string command : {"report ", "tune ", "compare "}) {
        const ProgramRun run = runRelievo(command + "--color " + (folder / "wall_color.png")
            + (command == "tune " ? " --max-error 1" : " -o " + (folder / (command == "report " ? "x.csv" : "x.png"))));
        EXPECT_EQ(run.exitCode, 1) << run.err;
        EXPECT_NE(run.err.find("no height map"), std::string::npos) << run.err;
    }
}
