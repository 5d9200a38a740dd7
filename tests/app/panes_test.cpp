// Panes in the window: any number up to six, each with a view, and a camera and light of its own when it is unlinked.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/overlays.h"
#include "app/window/viewport/pane_layout.h"
#include "tests/app/window_support.h"
#include <QUndoStack>

using namespace relievo;

TEST(PaneLayout, FillsTheViewportWithoutOverlap)
{
    for (const auto& [width, height] : {std::pair{800, 600}, {801, 603}, {320, 240}, {7, 5}})
        for (int count = 1; count <= int(kMaxPanes); ++count) {
            const std::vector<PaneArea> areas = paneAreas(count, width, height);
            ASSERT_EQ(int(areas.size()), count);
            for (std::size_t i = 0; i < areas.size(); ++i) {
                const PaneArea& a = areas[i];
                EXPECT_GE(a.width, 1);
                EXPECT_GE(a.height, 1);
                if (width > 20) {
                    EXPECT_LE(a.x + a.width, width) << count;
                    EXPECT_LE(a.y + a.height, height) << count;
                    for (std::size_t k = 0; k < i; ++k) {
                        const PaneArea& b = areas[k];
                        const bool apart = a.x >= b.x + b.width || b.x >= a.x + a.width || a.y >= b.y + b.height || b.y >= a.y + a.height;
                        EXPECT_TRUE(apart) << count << ": " << i << " and " << k;
                    }
                }
            }
            EXPECT_EQ(areas.front().x, 0);
            EXPECT_EQ(areas.front().y, 0);
            if (width > 20) {
                EXPECT_EQ(areas.back().x + areas.back().width, width) << count;
                EXPECT_EQ(areas.back().y + areas.back().height, height) << count;
            }
        }
}

class PanesTest : public WindowTest {
protected:
    // Opens what a file with these panes would give.
    void show(const std::vector<Pane>& panes)
    {
        State several = state();
        several.panes = panes;
        window.assets().openState(several, {});
        settle();
        ASSERT_TRUE(waitFor([&] { return state().panes == panes && window.viewport().isSettled(); }));
    }
    std::vector<PaneCaption*> captions()
    {
        std::vector<PaneCaption*> shown;
        for (PaneCaption* caption : window.viewport().findChildren<PaneCaption*>())
            if (caption->isVisible())
                shown.push_back(caption);
        return shown;
    }
    QPoint middleOf(int pane)
    {
        const PaneArea area
            = paneAreas(int(state().panes.size()), window.viewport().width(), window.viewport().height())[std::size_t(pane)];
        return {area.x + area.width / 2, area.y + area.height / 2};
    }
};

TEST_F(PanesTest, SixOfAFileAreDrawnEachAsItIs)
{
    const std::vector<Pane> panes
        = {Pane{"relief"}, Pane{"relief", {}, "normal"}, Pane{"bump"}, Pane{"flat"}, Pane{"parallax"}, Pane{"cell-cone", {}, "fetches"}};
    show(panes);
    EXPECT_EQ(captions().size(), 6u);
    const QImage sheet = window.viewport().picture();
    ASSERT_FALSE(sheet.isNull());
    const auto areas = paneAreas(6, sheet.width(), sheet.height());
    for (std::size_t i = 1; i < areas.size(); ++i)
        EXPECT_NE(sheet.copy(areas[i].x, areas[i].y, areas[i].width, areas[i].height),
            sheet.copy(areas[0].x, areas[0].y, areas[0].width, areas[0].height))
            << i;
    QTest::mouseClick(&window.viewport(), Qt::LeftButton, Qt::NoModifier, middleOf(4));
    EXPECT_EQ(window.viewport().activePane(), 4);
    window.setTechnique("steep");
    EXPECT_EQ(state().panes[4].technique, "steep");
    window.parameters().setScope(Scope(5));
    EXPECT_EQ(window.viewport().activePane(), 5);
    window.action("two-panes")->trigger();
    EXPECT_EQ(state().panes.size(), 1u);
    EXPECT_EQ(window.parameters().scope(), kAllPanes);
    window.action("two-panes")->trigger();
    EXPECT_EQ(state().panes.size(), 6u) << "they come back as they were";
}

TEST_F(PanesTest, AnUnlinkedPaneMovesAlone)
{
    Pane own{"bump"};
    own.camera = state().camera;
    own.overrides = {{"lightYaw", 0.f}};
    show({Pane{"relief"}, own});
    const Camera shared = state().camera;
    drag(window.viewport(), {middleOf(1), middleOf(1) + QPoint(40, 10), middleOf(1) + QPoint(60, 20)});
    EXPECT_EQ(state().camera, shared);
    EXPECT_NE(*state().panes[1].camera, shared);
    EXPECT_EQ(steps(), 0) << "a camera's move is no step, whosever it is";
    const Camera moved = *state().panes[1].camera;
    drag(window.viewport(), {middleOf(0), middleOf(0) + QPoint(40, 10), middleOf(0) + QPoint(60, 20)});
    EXPECT_NE(state().camera, shared);
    EXPECT_EQ(*state().panes[1].camera, moved);

    drag(window.viewport(), {middleOf(1), middleOf(1) + QPoint(50, 0)}, Qt::RightButton, Qt::ShiftModifier);
    EXPECT_NE(effectiveParameters(state(), 1).lightYaw, 0.f);
    EXPECT_EQ(state().parameters.lightYaw, Parameters().lightYaw);
    EXPECT_EQ(steps(), 1);
    window.action("reset-camera")->trigger(); // of the pane that was pressed last
    EXPECT_EQ(*state().panes[1].camera, framed({}));
    const Camera still = state().camera;
    window.action("frame")->trigger();
    EXPECT_EQ(state().camera, still);
    const Camera later = *state().panes[1].camera;
    window.action("undo")->trigger();
    EXPECT_EQ(effectiveParameters(state(), 1).lightYaw, 0.f);
    EXPECT_EQ(*state().panes[1].camera, later) << "undo leaves the eye where it is";
}

TEST_F(PanesTest, OnePaneIsSmoothedAgainAfterTheOthersAreGone)
{
    show({Pane{"relief"}, Pane{"bump"}});
    ASSERT_TRUE(waitFor([&] { return window.viewport().smoothSamples() == window.viewport().samplesAtRest().wanted(); }));
    bool began = false;
    QObject::connect(&window.viewport(), &Viewport::painted, &window.viewport(), [&] {
        began = began
            || (window.viewport().smoothSamples() > 0 && window.viewport().smoothSamples() < window.viewport().samplesAtRest().wanted());
    });
    window.action("two-panes")->trigger();
    ASSERT_TRUE(waitFor([&] { return window.viewport().isSettled(); }));
    EXPECT_TRUE(began) << "sample by sample";
    EXPECT_EQ(window.viewport().smoothSamples(), window.viewport().samplesAtRest().wanted());
}

// As many as wanted, from 16 to 256, then nothing more is done; the choice is remembered.
TEST_F(PanesTest, AtRestEdgesAreSmoothedAndThenTheWindowIsIdle)
{
    Viewport& picture = window.viewport();
    ASSERT_TRUE(waitFor([&] { return picture.isSettled(); }));
    EXPECT_EQ(picture.smoothSamples(), SamplesAtRest::kLeast);
    QTest::qWait(50); // the last picture is painted
    int painted = 0;
    QObject::connect(&picture, &Viewport::painted, &picture, [&] { ++painted; });
    QTest::qWait(200);
    EXPECT_EQ(painted, 0);
    EXPECT_FALSE(window.action("smoother")->isChecked());
    window.action("smoother")->trigger();
    EXPECT_EQ(picture.samplesAtRest().wanted(), SamplesAtRest::kMost);
    ASSERT_TRUE(waitFor([&] { return picture.isSettled() && picture.smoothSamples() > SamplesAtRest::kLeast; }));
    EXPECT_LT(painted, 16) << "shown when twice as many have been averaged";
    MainWindow again;
    EXPECT_TRUE(again.action("smoother")->isChecked());
    EXPECT_EQ(again.viewport().samplesAtRest().wanted(), SamplesAtRest::kMost);
    window.action("smoother")->trigger();
    EXPECT_EQ(picture.samplesAtRest().wanted(), SamplesAtRest::kUsual);
}

TEST_F(PanesTest, APresetBringsNumbersAndLeavesTheEyeAndTheView)
{
    Pane own{"bump", {}, "normal"};
    own.camera.emplace().yaw = 77.f;
    show({own, Pane{"flat"}});
    window.files().applyPreset("fine");
    EXPECT_EQ(state().panes[0].technique, "relief");
    EXPECT_EQ(state().panes[0].view, "normal");
    ASSERT_TRUE(state().panes[0].camera);
    EXPECT_EQ(state().panes[0].camera->yaw, 77.f);
}

TEST_F(PanesTest, ViewsOfTheirOwnHaveLegendsOfTheirOwn)
{
    show({Pane{"relief", {}, "fetches"}, Pane{"relief"}, Pane{"relief", {}, "depth"}, Pane{"relief", {}, "fetches"}});
    int legends = 0;
    for (HeatLegend* legend : window.viewport().findChildren<HeatLegend*>())
        legends += legend->isVisible();
    EXPECT_EQ(legends, 3);
    window.setView("fetches");
    legends = 0;
    for (HeatLegend* legend : window.viewport().findChildren<HeatLegend*>())
        legends += legend->isVisible();
    EXPECT_EQ(legends, 4);
    EXPECT_EQ(steps(), 1);
}
