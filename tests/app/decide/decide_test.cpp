// Deciding in the window: the plot of speed against error, tuning, distance, contact sheets and reports.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/decide/decide_dock.h"
#include "app/window/decide/distance_page.h"
#include "app/window/decide/measuring_run.h"
#include "app/window/decide/speed_page.h"
#include "app/window/decide/speed_plot.h"
#include "app/window/decide/tune_panel.h"
#include "app/window/docks.h"
#include "app/window/widgets/custom_plot.h"
#include "app/window/widgets/text.h"
#include "tests/app/window_support.h"
#include <QDesktopServices>
#include <QFileInfo>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>
#include <QUrl>
#include <cmath>

using namespace relievo;

namespace {
constexpr int kLong = 120000; // ms

// Takes what would be opened by another program.
class Launched : public QObject {
    Q_OBJECT
public:
    Launched() { QDesktopServices::setUrlHandler("file", this, "open"); }
    ~Launched() override { QDesktopServices::unsetUrlHandler("file"); }
    QList<QUrl> urls;
public Q_SLOTS:
    void open(const QUrl& url) { urls << url; }
};

class DecideTest : public WindowTest {
protected:
    DecideDock& dock() { return window.docks().decide(); }
    SpeedPage& speed() { return dock().speed(); }
    const std::vector<MeasuredSetting>& points() { return speed().sweep().points(); }
    void open(QWidget& page)
    {
        if (!dock().isVisible())
            window.action("speed-error")->trigger();
        dock().showPage(page);
        ASSERT_TRUE(dock().isVisible());
    }
    bool measured()
    {
        const bool done = waitFor([&] { return !speed().sweep().busy() && !points().empty(); }, kLong);
        QCoreApplication::processEvents(); // the plot is drawn when it is next idle: points lie elsewhere then
        return done;
    }
    // Of one with a few steps.
    double steepError(double HitErrors::*error)
    {
        const auto found = std::ranges::find(points(), "Steep parallax 8", [](const MeasuredSetting& p) { return p.setting.label; });
        return found == points().end() ? std::nan("") : found->errors.*error;
    }
    // The point with steps that no other one is near, of another technique than the present.
    std::size_t loneliest()
    {
        std::size_t best = 0;
        double far = -1.;
        for (std::size_t i = 0; i < points().size(); ++i) {
            if (points()[i].setting.technique == present()->setting.technique || !points()[i].setting.technique->searches)
                continue;
            double nearest = 1e9;
            for (std::size_t j = 0; j < points().size(); ++j)
                if (const QPointF away = speed().plot().placeOf(i) - speed().plot().placeOf(j); i != j)
                    nearest = std::min(nearest, std::hypot(away.x(), away.y()));
            if (nearest > far)
                far = nearest, best = i;
        }
        return best;
    }
    const MeasuredSetting* present()
    {
        const auto found = std::ranges::find(points(), true, &MeasuredSetting::isPresent);
        return found == points().end() ? nullptr : &*found;
    }
    void clickPoint(std::size_t point)
    {
        auto* plot = speed().plot().findChild<QCustomPlot*>();
        const QPoint at = speed().plot().placeOf(point).toPoint();
        QTest::mouseMove(plot, at + QPoint(60, 40));
        QTest::mouseMove(plot, at);
        QTest::mouseClick(plot, Qt::LeftButton, {}, at);
    }
    TunePanel& tune() { return dock().tuning(); }
    void find(const TuneQuestion& question)
    {
        open(tune());
        tune().setQuestion(question);
        QTest::mouseClick(tune().findChild<QPushButton*>("find"), Qt::LeftButton);
        ASSERT_TRUE(waitFor([&] { return !tune().busy(); }, kLong));
    }
    QString found() { return tune().findChild<QLabel*>("found")->text(); }
};
} // namespace

TEST_F(DecideTest, APointIsClickedAndTakenBack)
{
    open(speed());
    ASSERT_TRUE(measured());
    EXPECT_GT(points().size(), 80u) << "every technique and setting";
    ASSERT_TRUE(present());
    EXPECT_EQ(present()->setting.technique->key, state().panes.front().technique);
    EXPECT_GT(speed().plot().front().size(), 2u);
    const State before = state();
    for (const MeasuredSetting& point : points())
        if (point.setting.technique->isExact) {
            EXPECT_LT(point.errors.rmse, 1e-3) << point.setting.label;
        }
    const std::size_t point = loneliest();
    const SearchSetting wanted = points()[point].setting;
    clickPoint(point);
    EXPECT_EQ(state().panes.front().technique, wanted.technique->key);
    EXPECT_EQ(steps(), 1);
    ASSERT_TRUE(measured());
    EXPECT_EQ(keyOf(present()->setting), keyOf(wanted));
    window.action("undo")->trigger();
    EXPECT_EQ(state(), before);
}

TEST_F(DecideTest, OfTwoPanesTheActiveOneTakesIt)
{
    window.document().edit("Two", [](State& two) { setPaneCount(two, 2); });
    window.viewport().setActivePane(1);
    open(speed());
    ASSERT_TRUE(measured());
    const Pane first = state().panes.front();
    const Parameters shared = state().parameters;
    const std::size_t point = loneliest();
    const SearchSetting wanted = points()[point].setting;
    clickPoint(point);
    EXPECT_EQ(state().panes[1].technique, wanted.technique->key);
    EXPECT_EQ(parametersText({wanted.technique, {}, {}, effectiveParameters(state(), 1)}), parametersText(wanted));
    EXPECT_EQ(state().panes[0], first);
    EXPECT_EQ(state().parameters, shared);
}

TEST_F(DecideTest, CoarseFiguresComeFirst)
{
    window.assets().openDocument("sample:bricks@300", State{});
    settle();
    open(speed());
    ASSERT_TRUE(waitFor([&] { return !points().empty(); }, kLong));
    EXPECT_TRUE(points().front().isCoarse);
    ASSERT_TRUE(measured());
    EXPECT_FALSE(std::ranges::any_of(points(), &MeasuredSetting::isCoarse));
}

TEST_F(DecideTest, TheViewCounts)
{
    window.document().edit({}, [](State& moved) { moved.camera.pitch = 80.f; });
    open(speed());
    ASSERT_TRUE(measured());
    const double steep = steepError(&HitErrors::rmsePixels);
    window.document().edit({}, [](State& moved) { moved.camera.pitch = 20.f; });
    EXPECT_TRUE(speed().sweep().busy());
    ASSERT_TRUE(measured());
    EXPECT_GT(steepError(&HitErrors::rmsePixels), 1.5 * steep) << "flatter views shift more";
    const double before = steepError(&HitErrors::rmse);
    window.document().edit("Light", [](State& lit) { lit.parameters.lightYaw = 10.f; });
    ASSERT_TRUE(measured());
    EXPECT_EQ(steepError(&HitErrors::rmse), before) << "light is no matter of the search";
}

TEST_F(DecideTest, ClosedItComputesNothing)
{
    EXPECT_FALSE(speed().sweep().busy());
    open(speed());
    ASSERT_TRUE(waitFor([&] { return !points().empty() || speed().sweep().busy(); }));
    dock().findChild<QToolButton*>("close")->click();
    EXPECT_FALSE(dock().isVisible());
    EXPECT_FALSE(window.action("speed-error")->isChecked());
    EXPECT_FALSE(speed().sweep().busy());
    window.document().edit("Depth", [](State& deep) { deep.parameters.depth = 0.2f; });
    EXPECT_FALSE(speed().sweep().busy());
    open(speed());
    window.action("ray-inspector")->trigger();
    EXPECT_FALSE(dock().isVisible()) << "one dock at a time";
    EXPECT_FALSE(window.action("speed-error")->isChecked());
}

TEST_F(DecideTest, NothingToMeasureIsSaid)
{
    open(speed());
    window.document().edit({}, [](State& away) { away.camera.distance = 1.f, away.camera.target = glm::vec3(0.f, 50.f, 0.f); });
    ASSERT_TRUE(waitFor([&] { return speed().sweep().note().startsWith("Nothing of the relief"); }, kLong));
    window.document().edit("No map", [](State& none) {
        none.slots[std::size_t(MapKind::Height)] = {};
        none.panes.front().technique = "flat";
    });
    settle();
    ASSERT_TRUE(waitFor([&] { return speed().sweep().note().startsWith("There is no height map"); }, kLong));
    EXPECT_TRUE(points().empty());
}

TEST_F(DecideTest, TuningGivesTheAnswerOfTheCommand)
{
    TuneQuestion question;
    question.budget = {0.01, 0.05};
    find(question);
    ASSERT_TRUE(tune().answer()) << found().toStdString();
    const Tuned& tuned = *tune().answer();
    const Candidate& chosen = tuned.candidates[*tuned.chosen];
    QProcess command;
    command.start(RELIEVO_BIN "/relievo", {"tune", "sample:bricks@64", "--max-error", "0.01", "--max-missed", "5", "--json"});
    ASSERT_TRUE(command.waitForFinished(kLong));
    const QString said = QString::fromUtf8(command.readAllStandardOutput()).section("\"tried\"", 0, 0);
    EXPECT_TRUE(said.contains('"' + qt(tuned.settings[chosen.setting].label) + '"')) << said.toStdString();
    const QString number = said.section("\"meanFetches\":", 1, 1).section(',', 0, 0).trimmed();
    EXPECT_EQ(number.toDouble(), chosen.meanFetches) << said.toStdString();
    EXPECT_EQ(tune().findChild<QTableWidget*>("proof")->rowCount(), int(kAngleBands.size()));
    const State before = state();
    QTest::mouseClick(tune().findChild<QPushButton*>("apply"), Qt::LeftButton);
    EXPECT_EQ(state().panes.front().technique, tuned.settings[chosen.setting].technique->key);
    EXPECT_EQ(steps(), 1);
    window.action("undo")->trigger();
    EXPECT_EQ(state(), before);
}

TEST_F(DecideTest, TuningTheOtherWayRoundAndFromThisView)
{
    TuneQuestion question;
    question.leastError = true;
    question.views = TuneViews::Seen;
    question.budget.maxFetches = 24.;
    find(question);
    ASSERT_TRUE(tune().answer()) << found().toStdString();
    const Tuned& tuned = *tune().answer();
    const Candidate& chosen = tuned.candidates[*tuned.chosen];
    EXPECT_LE(chosen.meanFetches, 24.);
    for (const Candidate& other : tuned.candidates)
        if (other.meanFetches <= 24.) {
            EXPECT_GE(other.error, chosen.error);
        }
    question = {};
    question.metric = TuneMetric::Pixels;
    question.views = TuneViews::Around;
    question.budget.maxError = 0.5;
    find(question);
    ASSERT_TRUE(tune().answer()) << found().toStdString();
    EXPECT_EQ(tune().findChild<QTableWidget*>("proof")->rowCount(), kTurns);
    question = {};
    question.views = TuneViews::Seen;
    question.budget.maxError = 0.; // none is right to the last bit
    find(question);
    EXPECT_FALSE(tune().answer());
    EXPECT_TRUE(found().startsWith("No setting is that exact")) << found().toStdString();
    EXPECT_FALSE(tune().findChild<QPushButton*>("apply")->isVisible());
}

TEST_F(DecideTest, TuningIsStoppedByClosing)
{
    open(tune());
    tune().find();
    EXPECT_TRUE(tune().busy());
    dock().findChild<QToolButton*>("close")->click();
    EXPECT_FALSE(tune().busy());
}

TEST_F(DecideTest, TheFadeDistanceGrowsWithTheDepth)
{
    open(dock().distance());
    const auto settled = [&] { return !dock().distance().busy() && !dock().distance().answer().figures.empty(); };
    ASSERT_TRUE(waitFor(settled, kLong));
    const double fade = dock().distance().fadeDistance();
    EXPECT_GT(fade, 0.);
    EXPECT_TRUE(dock().distance().findChild<QLabel*>("suggestion")->text().contains("fade to bump"));
    window.document().edit("Depth", [](State& deep) { deep.parameters.depth *= 2.f; });
    ASSERT_TRUE(waitFor([&] { return settled() && dock().distance().fadeDistance() > 1.2 * fade; }, kLong));
    EXPECT_LT(dock().distance().fadeDistance(), 2.1 * fade);
}

TEST_F(DecideTest, AContactSheetIsWrittenAndOpened)
{
    Launched launched;
    MeasuringRun& run = measuringOf(window);
    const QString out = file("sheet.png");
    run.start(Action::ContactSheet, out, {"--techniques", "parallax"});
    EXPECT_TRUE(run.busy());
    ASSERT_TRUE(waitFor([&] { return !run.busy(); }, kLong));
    EXPECT_FALSE(QImage(out).isNull()) << window.messageLine().text().toStdString();
    EXPECT_EQ(launched.urls, QList<QUrl>{QUrl::fromLocalFile(out)});
}

TEST_F(DecideTest, AReportIsStoppedAndLeavesNothing)
{
    Launched launched;
    MeasuringRun& run = measuringOf(window);
    const QString out = file("report.html");
    run.start(Action::Report, out);
    ASSERT_TRUE(waitFor([&] { return window.messageLine().text().startsWith("Measuring for the report"); }));
    for (const Message& told : window.messages().all())
        if (told.text.startsWith("Measuring for the report") && !told.choices.isEmpty())
            told.choices.front().take();
    EXPECT_FALSE(run.busy());
    EXPECT_FALSE(QFileInfo::exists(out));
    EXPECT_TRUE(launched.urls.isEmpty());
    run.start(Action::Report, file("report.txt")); // what the command refuses is told in its words
    ASSERT_TRUE(waitFor([&] { return !run.busy(); }, kLong));
    EXPECT_TRUE(window.messageLine().text().contains(".html, .json or .csv")) << window.messageLine().text().toStdString();
}

#include "decide_test.moc"
