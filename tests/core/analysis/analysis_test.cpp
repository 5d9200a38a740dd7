// Settings from the tables, sweeps, tuning and the forms of a report.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/report.h"
#include "core/analysis/report_plot.h"
#include "core/analysis/tune.h"
#include "core/image/samples/hard_cases.h"
#include "core/trace/shader_on_cpu.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

using namespace relievo;

namespace {

SweepField fieldOf(std::string_view key, int size = 48)
{
    const HardCaseRow& row = *findHardCase(key);
    return {std::string(key), std::string(row.label), row.make(size, 1), 0.08};
}

SweepPlan planOf(std::vector<const char*> techniques, std::vector<const char*> fields, std::vector<int> steps = {8, 64})
{
    SweepPlan plan;
    for (const char* key : techniques)
        for (SearchSetting& setting : settingsOf(*findTechnique(key), Parameters(), steps))
            plan.settings.push_back(std::move(setting));
    for (const char* key : fields)
        plan.fields.push_back(fieldOf(key));
    plan.rays = 300;
    return plan;
}

Report reportOf(const SweepPlan& plan)
{
    Report report;
    report.title = "A <title> & \"more\"";
    report.plan = plan;
    report.rows = *sweep(plan);
    report.angles = {30., 75.};
    report.renderer = "none", report.exactLabel = "Exact", report.pictureWidth = 8, report.pictureHeight = 6;
    for (std::size_t s = 0; s < plan.settings.size(); ++s)
        for (std::size_t f = 0; f < plan.fields.size(); ++f)
            for (std::size_t a = 0; a < 2; ++a)
                report.pictures.push_back(
                    {s, f, a, 2., 1.5 + double(s), s ? 40. : std::numeric_limits<double>::infinity(), 0.01 * double(s)});
    for (const double angle : kEngineAngles)
        report.engines.push_back({findTechnique("as-godot4"), 0, angle, {0.5, 0.125, 0.25}});
    report.heatField = "Needles";
    report.heats = {{"Relief", {std::byte(1), std::byte(2)}, {std::byte(0xff)}, 12., 0.01}};
    report.warnings = {{"test", "Look <here>"}};
    return report;
}

Candidate candidate(std::size_t setting, double mean, int most, double error, double missed = 0.)
{
    return {setting, mean, most, error, missed};
}

} // namespace

TEST(Settings, FollowTheTable)
{
    const auto relief = settingsOf(*findTechnique("relief"), Parameters(), kReportSteps);
    ASSERT_EQ(relief.size(), kReportSteps.size());
    for (std::size_t i = 0; i < relief.size(); ++i) {
        EXPECT_EQ(relief[i].parameters.minSteps, kReportSteps[i]);
        EXPECT_EQ(relief[i].parameters.maxSteps, kReportSteps[i]);
        EXPECT_FALSE(relief[i].parameters.heightMips);
        EXPECT_EQ(relief[i].label, "Relief " + std::to_string(kReportSteps[i]) + "+6");
        EXPECT_EQ(relief[i].series, "Relief");
    }
    const auto parallax = settingsOf(*findTechnique("parallax"), Parameters(), kReportSteps);
    ASSERT_EQ(parallax.size(), 2u);
    EXPECT_TRUE(parallax[1].parameters.offsetLimiting);
    EXPECT_EQ(parallax[1].label, "Parallax, offset limiting");
    EXPECT_EQ(settingsOf(*findTechnique("flat"), Parameters(), kReportSteps).size(), 1u);
}

TEST(Settings, OfEveryTechniqueDiffer)
{
    std::set<std::string> labels;
    for (const TechniqueRow& row : kTechniques)
        for (const SearchSetting& setting : settingsOf(row, Parameters(), kTuneSteps)) {
            EXPECT_EQ(setting.technique, &row);
            EXPECT_TRUE(labels.insert(setting.label).second) << setting.label;
            for (const ParameterRow& parameter : kParameters)
                EXPECT_TRUE(inRange(parameter, get(setting.parameters, parameter))) << setting.label;
        }
}

TEST(Settings, ChangeOnlyTheSearchOfAState)
{
    State state;
    state.parameters.depth = 0.3f;
    state.panes = {Pane{"bump", {{"depth", 0.2f}, {"maxSteps", 99}}}, Pane{}};
    SearchSetting setting = settingsOf(*findTechnique("relief"), Parameters(), std::array{64}).front();
    setting.parameters.depth = 0.01f;
    const State changed = withSetting(state, setting);
    ASSERT_EQ(changed.panes.size(), 1u);
    EXPECT_EQ(changed.panes.front(), (Pane{"relief", {}}));
    EXPECT_EQ(changed.parameters.depth, 0.2f); // what the first pane was drawn with
    EXPECT_EQ(changed.parameters.maxSteps, 64);
    EXPECT_TRUE(changed.parameters.heightMips);
    EXPECT_EQ(parametersText(setting), "minSteps=64 maxSteps=64 refineSteps=6");
}

TEST(Settings, TechniquesByName)
{
    const std::vector<std::string> some = {"relief", "flat", "relief"};
    EXPECT_EQ(techniquesNamed(some)->size(), 2u);
    EXPECT_EQ(techniquesNamed({})->size(),
        std::size_t(std::ranges::count_if(kTechniques, [](const auto& r) { return !r.file.empty() && !r.isEngine(); })));
    EXPECT_EQ(techniquesNamed(std::vector<std::string>{"as-godot4"})->front()->key, "as-godot4"); // engines only by name
    EXPECT_FALSE(techniquesNamed(std::vector<std::string>{"magic"}));
    EXPECT_FALSE(techniquesNamed(std::vector<std::string>{"reference"}));
}

TEST(Settings, MostExactHasAShader)
{
    const SearchSetting exact = mostExactSetting(Parameters());
    EXPECT_FALSE(exact.technique->file.empty());
    const bool anyExact = std::ranges::any_of(kTechniques, [](const auto& r) { return r.isExact && !r.file.empty(); });
    EXPECT_EQ(exact.technique->isExact, anyExact);
}

TEST(Sweep, MeasuresEverySettingFieldAndBand)
{
    const SweepPlan plan = planOf({"flat", "relief"}, {"needles", "waves"});
    float last = 0.f;
    Progress progress;
    progress.report = [&](float share) { last = std::max(last, share); };
    const auto rows = sweep(plan, progress);
    ASSERT_TRUE(rows);
    EXPECT_EQ(rows->size(), 3u * 2u * 4u);
    EXPECT_FLOAT_EQ(last, 1.f);
    for (const SweepRow& row : *rows) {
        EXPECT_EQ(row.errors.rays, 300u);
        if (plan.settings[row.setting].technique->key == "flat") {
            EXPECT_EQ(row.errors.meanFetches, 0.);
            EXPECT_EQ(row.errors.tooDeep, 0u);
        } else {
            EXPECT_EQ(row.bytesPerTexel, 4.); // floats
            EXPECT_EQ(row.errors.tooShort, 0u);
        }
    }
    // More steps: more fetches, fewer errors. Needles are harder than waves.
    const HitErrors few = overFields(*rows, 1), many = overFields(*rows, 2);
    EXPECT_GT(many.meanFetches, few.meanFetches);
    EXPECT_LT(many.wrongShare(), few.wrongShare());
    EXPECT_EQ(few.rays, 2u * 4u * 300u);
    EXPECT_EQ(overFields(*rows, 1, 2).rays, 2u * 300u);
}

// The figures do not depend on the number of threads or on who asks; every technique of the table takes part.
TEST(Sweep, IsReproducible)
{
    SweepPlan plan;
    for (const TechniqueRow& row : kTechniques)
        plan.settings.push_back(plainSetting(row, Parameters()));
    plan.fields = {fieldOf("noise", 24)};
    plan.rays = 200;
    const auto a = sweep(plan);
    plan.freshMaps = true;
    const auto b = sweep(plan);
    ASSERT_TRUE(a && b);
    for (std::size_t i = 0; i < a->size(); ++i) {
        EXPECT_EQ((*a)[i].errors.rmse, (*b)[i].errors.rmse);
        EXPECT_EQ((*a)[i].errors.meanFetches, (*b)[i].errors.meanFetches);
        EXPECT_EQ((*a)[i].bytesPerTexel, (*b)[i].bytesPerTexel);
        const TechniqueRow& technique = *plan.settings[(*a)[i].setting].technique;
        EXPECT_EQ((*b)[i].bakeSeconds > 0., !technique.accelerationMap.empty()) << technique.key;
        EXPECT_EQ((*a)[i].errors.invalid, 0u) << technique.key;
        if (technique.isExact) {
            EXPECT_EQ((*a)[i].errors.wrongShare(), 0.) << technique.key;
        }
    }
    plan.seed = 2;
    EXPECT_NE(sweep(plan)->back().errors.meanFetches, a->back().errors.meanFetches);
}

// 32 linear steps and halvings at 80 to 88 degrees: some 30 % of the rays are wrong on hard fields
// (resources/help/speed-and-error.md, "Beside known figures").
// Here, at 128 texels: clearly more than at 0 to 60 degrees, and none too short.
TEST(Sweep, LinearSearchIsAsWrongAsKnown)
{
    SweepPlan plan = planOf({"relief"}, {}, {32});
    for (const char* key : {"needles", "noise", "checker", "bricks", "waves", "fbm"})
        plan.fields.push_back(fieldOf(key, 128));
    plan.rays = 1000;
    const auto rows = *sweep(plan);
    EXPECT_LT(overFields(rows, 0, 0).wrongShare(), 0.08);
    EXPECT_GT(overFields(rows, 0, 2).wrongShare(), 0.15);
    EXPECT_LT(overFields(rows, 0, 2).wrongShare(), 0.6);
    EXPECT_EQ(overFields(rows, 0).tooShort, 0u);
}

TEST(Sweep, StopsWhenCancelled)
{
    std::stop_source stop;
    stop.request_stop();
    const auto rows = sweep(planOf({"relief"}, {"waves"}), {{}, stop.get_token()});
    ASSERT_FALSE(rows);
    EXPECT_TRUE(isCancelled(rows.error()));
}

TEST(Tune, CheapestFirstAndTiesByTheMost)
{
    const SweepPlan plan = planOf({"relief", "parallax"}, {"waves"}, {64, 8});
    const auto rows = *sweep(plan);
    const auto candidates = candidatesOf(rows, plan.settings.size());
    ASSERT_EQ(candidates.size(), 4u);
    EXPECT_TRUE(std::ranges::is_sorted(candidates, {}, &Candidate::meanFetches));
    EXPECT_EQ(plan.settings[candidates.front().setting].technique->key, "parallax");
    double worst = 0.;
    for (const SweepRow& row : rows)
        if (row.setting == candidates.back().setting)
            worst = std::max(worst, row.errors.rmse);
    EXPECT_EQ(candidates.back().error, worst);
}

TEST(Tune, TakesTheFirstWithinTheBudget)
{
    const std::vector<Candidate> all
        = {candidate(0, 1., 1, 0.5), candidate(1, 5., 9, 0.02, 0.3), candidate(2, 9., 12, 0.04), candidate(3, 20., 22, 0.001)};
    const auto chosen = [&](TuneBudget budget, ErrorOf errorOf = {}) {
        std::vector<Candidate> candidates = all;
        const auto best = choose(candidates, budget, errorOf);
        return *best ? int((*best)->setting) : -1;
    };
    EXPECT_EQ(chosen({.maxError = 1.}), 0);
    EXPECT_EQ(chosen({.maxError = 0.05}), 1);
    EXPECT_EQ(chosen({.maxError = 0.05, .maxMissed = 0.1}), 2);
    EXPECT_EQ(chosen({.maxError = 0.01}), 3);
    EXPECT_EQ(chosen({.maxError = 0.01, .maxFetches = 15.}), -1);
    EXPECT_EQ(chosen({.maxError = 0.0001}), -1);
    // Pictures are asked for in order, and no longer than needed.
    std::vector<std::size_t> asked;
    EXPECT_EQ(chosen({.maxError = 0.1},
                  [&](std::size_t setting) -> Expected<double> {
                      asked.push_back(setting);
                      return setting == 2 ? 0.05 : 0.2;
                  }),
        2);
    EXPECT_EQ(asked, (std::vector<std::size_t>{0, 1, 2}));
    std::vector<Candidate> candidates = all;
    EXPECT_FALSE(choose(candidates, {.maxError = 1.}, [](std::size_t) -> Expected<double> { return failure("GPU", "broken"); }));
}

TEST(HeatPictures, ShowFetchesAndErrors)
{
    HeatView view;
    view.width = 40, view.height = 20;
    const SweepField field = fieldOf("bricks");
    const auto relief = heatPictures(plainSetting(*findTechnique("relief"), Parameters()), field.heights, view);
    ASSERT_TRUE(relief);
    EXPECT_EQ(relief->fetches.data.size(), 40u * 20u * 3u);
    EXPECT_GT(relief->meanFetches, 5.);
    const auto exact = heatPictures(plainSetting(*findTechnique("reference"), Parameters()), field.heights, view);
    EXPECT_EQ(exact->meanError, 0.);
    const glm::vec3 none = heatColor(0.f) * 255.f;
    for (std::size_t i = 0; i < exact->error.data.size(); ++i)
        ASSERT_EQ(std::to_integer<long>(exact->error.data[i]), std::lround(none[int(i % 3)]));
}

TEST(Report, FiguresHaveThreeDigits)
{
    EXPECT_EQ(figure(0.), "0");
    EXPECT_EQ(figure(28.449), "28.4");
    EXPECT_EQ(figure(0.03123), "0.0312");
    EXPECT_EQ(figure(1240.4), "1240");
    EXPECT_EQ(figure(0.00002), "0.00002");
    EXPECT_EQ(figure(1e-9), "0");
    EXPECT_EQ(figure(1e100), "1e+100");
    EXPECT_EQ(figure(std::nan("")), "-");
    EXPECT_EQ(figure(std::numeric_limits<double>::infinity()), "inf");
}

TEST(Report, JsonHoldsEveryRow)
{
    const SweepPlan plan = planOf({"relief", "parallax"}, {"needles", "waves"});
    const Report report = reportOf(plan);
    const auto json = nlohmann::json::parse(reportJson(report));
    ASSERT_EQ(json["rays"].size(), report.rows.size());
    EXPECT_EQ(json["pictures"].size(), report.pictures.size());
    EXPECT_EQ(json["settings"][0]["parameters"], "minSteps=8 maxSteps=8 refineSteps=6");
    EXPECT_EQ(json["fields"][1]["key"], "waves");
    const SweepRow& row = report.rows[5];
    EXPECT_EQ(json["rays"][5]["meanFetches"].get<double>(), row.errors.meanFetches);
    EXPECT_EQ(json["rays"][5]["overshootPercent"].get<double>(), 100. * row.errors.share(row.errors.tooDeep));
    EXPECT_TRUE(json["pictures"][0]["psnr"].is_null()); // equal pictures
    EXPECT_EQ(json["pictures"].back()["degrees"], 75.);
    ASSERT_EQ(json["engines"].size(), 3u);
    EXPECT_EQ(json["engines"][1],
        (nlohmann::json{{"technique", "as-godot4"}, {"engine", "Godot 4"}, {"field", "needles"}, {"degrees", 60.}, {"depthDrawn", 0.5},
            {"meanError", 0.125}, {"tooHigh", 0.25}}));
}

TEST(Sweep, BytesFollowWhatAFetchReturns)
{
    const auto floats = *sweep(planOf({"relief"}, {"needles"}));
    for (const SweepRow& row : floats)
        EXPECT_DOUBLE_EQ(row.errors.meanBytes, 4. * row.errors.meanFetches);
    const auto codesAndCorners = *sweep(planOf({"cell-cone"}, {"needles"})); // 8 bytes, and four floats
    for (const SweepRow& row : codesAndCorners) {
        EXPECT_GT(row.errors.meanBytes, 8. * row.errors.meanFetches);
        EXPECT_LE(row.errors.meanBytes, 16. * row.errors.meanFetches);
    }
}

TEST(Report, CsvIsRectangular)
{
    const Report report = reportOf(planOf({"relief", "parallax"}, {"needles"}));
    std::istringstream in(reportCsv(report));
    std::string line;
    std::size_t lines = 0;
    std::ptrdiff_t columns = 0;
    while (std::getline(in, line)) {
        bool inside = false;
        std::ptrdiff_t commas = 0;
        for (const char c : line) {
            inside ^= c == '"';
            commas += c == ',' && !inside;
        }
        columns = lines++ ? columns : commas;
        EXPECT_EQ(commas, columns) << line;
    }
    EXPECT_EQ(lines, 1 + report.rows.size() + report.pictures.size() + report.engines.size() + report.mesh.rows.size());
    EXPECT_NE(reportCsv(report).find("as-godot4,As Godot 4,needles,engine 60,"), std::string::npos);
}

TEST(Report, FarViewsStandInEachForm)
{
    Report report = reportOf(planOf({"relief"}, {"needles"}));
    EXPECT_EQ(farHtml(report), "");
    EXPECT_EQ(reportJson(report).find("farViews"), std::string::npos);
    report.far = {.field = "Bricks", .technique = "Bump", .width = 4, .height = 3, .finer = 16, .views = {{30., 4.}}, .rows = {}};
    report.far.rows = {{"no, filter", {{-0.5, 0.25}}}};
    EXPECT_NE(farHtml(report).find("<td>no, filter</td><td class='first'>-0.500</td><td>25.0</td>"), std::string::npos);
    EXPECT_NE(reportHtml(report).find("<h2>Far away</h2>"), std::string::npos);
    const std::string csv = reportCsv(report);
    EXPECT_NE(csv.find(",\"no, filter\",Bricks,far 30 x4,"), std::string::npos);
    EXPECT_TRUE(csv.ends_with(",-0.5,25\n"));
    EXPECT_NE(reportJson(report).find("\"brightnessStops\": -0.5"), std::string::npos);
}

TEST(Report, CsvHoldsTheMesh)
{
    Report report = reportOf(planOf({"relief"}, {"needles"}));
    report.mesh.name = "Box";
    report.mesh.rows = {{"no, silhouettes", 0.25, 1.5, 3., 1.}, {"prisms", 0.125, 0.5, 0., std::nan("")}};
    const std::string csv = reportCsv(report);
    const auto commas = [&](const std::string& from, const std::string& to) { // between two columns
        const std::size_t at = csv.find(from);
        return std::string(
            std::size_t(std::count(csv.begin() + std::ptrdiff_t(at), csv.begin() + std::ptrdiff_t(csv.find(to, at)), ',')), ',');
    };
    ASSERT_TRUE(csv.substr(0, csv.find('\n')).ends_with(",coveragePercent,depthRmsePixels,invalidPixels,brightnessStops,lightRmsePercent"));
    const std::string before = ",mesh" + commas("view", "msRatio"), after = commas("msRatio", "coveragePercent");
    EXPECT_NE(csv.find(",\"no, silhouettes\",Box" + before + '1' + after + "25,1.5,3,,\n"), csv.npos) << csv;
    EXPECT_NE(csv.find(",prisms,Box" + before + after + "12.5,0.5,0,,\n"), csv.npos) << csv;
}

TEST(Report, HtmlIsWholeAndSelfContained)
{
    const Report report = reportOf(planOf({"flat", "relief", "parallax"}, {"needles", "waves"}));
    const std::string html = reportHtml(report);
    EXPECT_NE(html.find("A &lt;title&gt; &amp; &quot;more&quot;"), html.npos);
    EXPECT_NE(html.find("Look &lt;here&gt;"), html.npos);
    for (const char* forbidden : {"<script", "http://", "https://", "<link", "@import", "url(", "nan", "inf<"})
        EXPECT_EQ(html.find(forbidden), html.npos) << forbidden;
    EXPECT_NE(html.find("data:image/png;base64,AQI="), html.npos);
    EXPECT_NE(html.find("data:image/png;base64,/w=="), html.npos);
    for (const char* tag : {"table", "tr", "svg", "g", "figure", "details", "div", "text"}) {
        const auto count = [&](const std::string& what) {
            std::size_t n = 0;
            for (std::size_t at = html.find(what); at != html.npos; at = html.find(what, at + 1))
                ++n;
            return n;
        };
        EXPECT_EQ(count(std::string("<") + tag + ">") + count(std::string("<") + tag + " "), count(std::string("</") + tag + ">")) << tag;
    }
    std::size_t plots = 0;
    for (std::size_t at = html.find("<svg class='plot'"); at != html.npos; at = html.find("<svg class='plot'", at + 1))
        ++plots;
    EXPECT_EQ(plots, 4u + 4u + 2u); // RMSE and wrong hits in each band, FLIP at each angle
    for (const SearchSetting& setting : report.plan.settings)
        EXPECT_NE(html.find(setting.label), html.npos);
    EXPECT_NE(html.find("<h2>As engines draw it</h2>"), html.npos);
    EXPECT_NE(html.find("<td>As Godot 4</td><td class='first'>50.0</td><td>0.125</td>"), html.npos);
}

TEST(Report, AxesHoldEveryPoint)
{
    const std::vector<std::vector<PlotCurve>> plots = {{{0, false, {{3.3, 0.02, "a"}, {170., 0., "b"}}}}, {{1, true, {{12., 0.4, "c"}}}}};
    const PlotAxes axes = axesFor(plots, 1e-4, "x", "y");
    EXPECT_LE(axes.xFrom, 3.3);
    EXPECT_GE(axes.xTo, 170.);
    EXPECT_GE(axes.yTo, 0.4);
    EXPECT_EQ(axes.yFrom, 1e-4);
    EXPECT_NE(plotSvg("title", axes, plots[0]).find("<title>b</title>"), std::string::npos);
    EXPECT_FALSE(axes.large);
    const std::vector<PlotCurve> small = {{0, false, {{3., 2.2e-5, ""}, {9., 6e-5, ""}}}}; // a span of less than a decade has ticks between
    const std::string svg = plotSvg("", axesFor({small}, 1e-5, "", ""), small);
    EXPECT_NE(svg.find("2 · 10<tspan dy='-4' font-size='8'>-5</tspan>"), std::string::npos) << svg;
    const std::vector<PlotCurve> many(9, plots[0][0]), empty(9, PlotCurve{0, false, {}});
    EXPECT_TRUE(axesFor({many}, 0.1, "", "").large);
    EXPECT_FALSE(axesFor({empty}, 0.1, "", "").large); // curves without points are not drawn
    EXPECT_GT(axesFor({}, 0.1, "", "").xTo, axesFor({}, 0.1, "", "").xFrom); // nothing to show is no fault
}
