// The walk of someone who chooses a technique: open a set, compare four, find the worst point, see why, tune to one pixel, export; then all
// of it undone, done again, saved and opened.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/compare/compare_bar.h"
#include "app/window/decide/decide_dock.h"
#include "app/window/decide/tune_panel.h"
#include "app/window/docks.h"
#include "app/window/inspector/ray_inspector.h"
#include "core/analysis/settings.h"
#include "core/state/state_json.h"
#include "tests/app/export_support.h"
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QUndoStack>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace relievo;

namespace {
constexpr int kLong = 120000; // ms

class WalkTest : public ExportingTest {
protected:
    void rest()
    {
        settle();
        ASSERT_TRUE(waitFor([&] { return missingMaps().empty() && window.viewport().isSettled(); }));
    }
    RayInspector& inspector() { return window.docks().inspector(); }
    // What the command line finds along the same ray.
    double depthByCommand(const RayInspection& inspected)
    {
        const SearchRay& ray = inspected.ray;
        QProcess command;
        command.start(RELIEVO_BIN "/relievo",
            {"inspect", "sample:bricks@64", "--technique", QString::fromStdString(inspected.technique), "--set",
                QString("depth=%1").arg(double(state().parameters.depth)), "--ray",
                QString("%1,%2,%3,%4")
                    .arg(ray.uv.x, 0, 'g', 17)
                    .arg(ray.uv.y, 0, 'g', 17)
                    .arg(ray.duv.x, 0, 'g', 17)
                    .arg(ray.duv.y, 0, 'g', 17),
                "--json", "--quiet"});
        if (!command.waitForFinished(kLong))
            return std::nan("");
        const auto told = nlohmann::json::parse(command.readAllStandardOutput().toStdString(), nullptr, false);
        return told.is_object() ? told["hit"].value("t", std::nan("")) : std::nan("");
    }
};
} // namespace

TEST_F(WalkTest, FromASetToAnExportedChoice)
{
    window.document().edit("Plane", [](State& s) {
        s.mesh = "plane";
        s.parameters.silhouettes = Silhouettes::Off;
        s.parameters.depth = 0.15f;
        s.camera = Camera{};
        s.camera.pitch = 25.f;
    });
    settle();
    const State opened = state();
    const int before = steps();

    // Four techniques, one of them by its error.
    QTest::keyClick(&window, Qt::Key_4, Qt::AltModifier);
    ASSERT_EQ(state().panes.size(), 4u);
    chooseInCaption("technique", "steep", 0);
    chooseInCaption("view", "error", 3);
    rest();
    auto captions = window.viewport().findChildren<PaneCaption*>();
    ASSERT_GE(captions.size(), 4);
    EXPECT_TRUE(captions[0]->accessibleName().contains("fetches/px"));
    EXPECT_TRUE(captions[0]->accessibleName().contains(" ms")) << captions[0]->accessibleName().toStdString();
    EXPECT_TRUE(captions[3]->accessibleName().contains("RMSE"));
    EXPECT_FALSE(captions[0]->accessibleName().contains("RMSE"));

    // In place, and back.
    QTest::keyClick(&window.viewport(), Qt::Key_W);
    EXPECT_TRUE(window.comparing().compares(InPlaceMode::Wipe));
    QTest::keyClick(&window.viewport(), Qt::Key_W);
    EXPECT_FALSE(window.viewport().places().inPlace().isOn());

    // The worst point of the first, and why.
    window.viewport().setActivePane(0);
    rest();
    window.action("worst-point")->trigger();
    ASSERT_TRUE(inspector().isVisible());
    ASSERT_TRUE(waitFor([&] { return !inspector().busy() && inspector().inspected().panes.size() == 4; }));
    const RayInspection& worst = *inspector().inspected().panes[0].view;
    EXPECT_GT(std::abs(worst.hit.t - worst.exact), 0.05) << "it is wrong there";
    EXPECT_FALSE(inspector().findChild<QLabel*>("verdict")->text().isEmpty());
    EXPECT_NEAR(depthByCommand(worst), worst.hit.t, 1e-4);
    EXPECT_NEAR(worst.steps.empty() ? -1. : worst.steps.back().to, worst.hit.t, 0.05);

    // Tuned to one pixel.
    window.action("speed-error")->trigger();
    EXPECT_FALSE(inspector().isVisible());
    TunePanel& tune = window.docks().decide().tuning();
    window.docks().decide().showPage(tune);
    TuneQuestion question;
    question.metric = TuneMetric::Pixels;
    question.budget.maxError = 1.;
    tune.setQuestion(question);
    QTest::mouseClick(tune.findChild<QPushButton*>("find"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return !tune.busy(); }, kLong));
    ASSERT_TRUE(tune.answer()) << tune.findChild<QLabel*>("found")->text().toStdString();
    const Tuned tuned = *tune.answer();
    EXPECT_LE(tuned.candidates[*tuned.chosen].error, 1.);
    QTest::mouseClick(tune.findChild<QPushButton*>("apply"), Qt::LeftButton);
    EXPECT_EQ(state().panes[0].technique, tuned.settings[tuned.candidates[*tuned.chosen].setting].technique->key);

    // Exported, undone, done again, saved and opened.
    ExportDialog& dialog = exportTo("preset");
    dialog.setOut(file("look.json"));
    dialog.run();
    finish(dialog);
    EXPECT_TRUE(QFileInfo::exists(file("look.json")));
    dialog.close();
    const State chosen = state();
    window.document().undoStack().setIndex(before);
    EXPECT_EQ(state(), opened);
    window.document().undoStack().setIndex(window.document().undoStack().count());
    EXPECT_EQ(state(), chosen);
    ASSERT_TRUE(window.document().save(file("walk.relievo")));
    window.assets().openDocument(file("walk.relievo"), State{});
    ASSERT_TRUE(waitFor([&] { return window.assets().ready() && !window.assets().background().busy(); }));
    EXPECT_EQ(state().panes, chosen.panes);
    EXPECT_EQ(state().parameters, chosen.parameters);
}
