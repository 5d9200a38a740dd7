// What is done with panes, as functions of the State, and in the window by menu, keys and dragging.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/compare/compare_bar.h"
#include "app/window/viewport/overlays.h"
#include "app/window/viewport/pane_drops.h"
#include "tests/app/window_support.h"
#include <QUndoStack>

using namespace relievo;

namespace {
State withPanes(std::vector<Pane> panes)
{
    State state;
    state.panes = std::move(panes);
    return state;
}

std::string techniques(const State& state)
{
    std::string all;
    for (const Pane& pane : state.panes)
        all += pane.technique + ' ';
    return all;
}
} // namespace

TEST(PaneEdits, NewPanesShowWhatIsNotShownYet)
{
    State state = withPanes({Pane{"relief"}});
    setPaneCount(state, 6);
    EXPECT_EQ(techniques(state), "relief parallax cell-cone pom bump steep ");
    setPaneCount(state, 2);
    EXPECT_EQ(techniques(state), "relief parallax ");
    setPaneCount(state, 99);
    EXPECT_EQ(state.panes.size(), kMaxPanes);
}

TEST(PaneEdits, SwapDuplicateAndClose)
{
    State state = withPanes({Pane{"relief"}, Pane{"bump", {{"depth", 0.3f}}, "normal"}});
    duplicatePane(state, 1);
    EXPECT_EQ(techniques(state), "relief bump bump ");
    EXPECT_EQ(state.panes[1], state.panes[2]);
    swapPanes(state, 0, 2);
    EXPECT_EQ(techniques(state), "bump bump relief ");
    closePane(state, 1);
    EXPECT_EQ(techniques(state), "bump relief ");
    closePane(state, 0);
    closePane(state, 0);
    EXPECT_EQ(techniques(state), "relief ") << "one is always left";
    for (int i = 0; i < 10; ++i)
        duplicatePane(state, 0);
    EXPECT_EQ(state.panes.size(), kMaxPanes);
}

TEST(PaneEdits, AnUnlinkedPaneKeepsCameraAndLightAsTheyWere)
{
    State state = withPanes({Pane{"relief"}, Pane{"bump"}});
    state.camera.yaw = 77.f;
    state.parameters.lightYaw = 12.f;
    setLinked(state, 1, false);
    state.camera.yaw = 5.f;
    state.parameters.lightYaw = 50.f;
    EXPECT_EQ(cameraOf(state, 1).yaw, 77.f);
    EXPECT_EQ(effectiveParameters(state, 1).lightYaw, 12.f);
    EXPECT_TRUE(ownValues(state, 1).empty()) << "its light goes with its camera";
    setLinked(state, 1, true);
    EXPECT_EQ(cameraOf(state, 1).yaw, 5.f);
    EXPECT_EQ(effectiveParameters(state, 1).lightYaw, 50.f);
    EXPECT_EQ(state.panes[1], Pane{"bump"});
}

TEST(PaneEdits, OwnValuesAreTakenOverOrDropped)
{
    State state = withPanes({Pane{"relief"}, Pane{"relief", {{"depth", 0.3f}, {"maxSteps", 12}}}, Pane{"relief", {{"depth", 0.1f}}}});
    ASSERT_EQ(ownValues(state, 1).size(), 2u);
    State shared = state;
    shareOwnValues(shared, 1);
    for (std::size_t pane = 0; pane < 3; ++pane) {
        EXPECT_EQ(effectiveParameters(shared, pane).depth, 0.3f);
        EXPECT_EQ(effectiveParameters(shared, pane).maxSteps, 12);
    }
    dropOwnValues(state, 1);
    EXPECT_EQ(state.panes[1], Pane{"relief"});
    EXPECT_EQ(effectiveParameters(state, 2).depth, 0.1f) << "another pane's stays";
}

TEST(PaneEdits, FurtherPanesComeBackAsTheyWere)
{
    FurtherPanes further;
    State state = withPanes({Pane{"relief"}, Pane{"bump"}, Pane{"flat"}, Pane{"steep"}});
    const State four = state;
    further.show(state, std::size_t(2));
    EXPECT_EQ(techniques(state), "relief bump ");
    further.show(state, false);
    EXPECT_EQ(techniques(state), "relief ");
    further.show(state, std::size_t(3));
    EXPECT_EQ(techniques(state), "relief bump flat ");
    further.show(state, false);
    further.show(state, true);
    EXPECT_EQ(state.panes, four.panes);
}

class PaneEditsTest : public WindowTest {
protected:
    QMenu& menuOfPane(std::size_t pane)
    {
        auto* button = window.viewport().findChildren<CaptionChoice*>("more")[qsizetype(pane)];
        QTest::mouseClick(button, Qt::LeftButton);
        return *button->findChild<QMenu*>();
    }
    void choose(std::size_t pane, const char* item)
    {
        QMenu& menu = menuOfPane(pane);
        auto* action = menu.findChild<QAction*>(item);
        ASSERT_NE(action, nullptr) << item;
        action->trigger();
        menu.close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    void dropOn(QMimeData* data, std::size_t pane)
    {
        const std::unique_ptr<QMimeData> owned(data);
        const PaneArea area = window.viewport().places().areas()[pane];
        const QPoint at(area.x + area.width / 2, area.y + area.height / 2);
        QDragEnterEvent enter(at, Qt::CopyAction, data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window.viewport(), &enter);
        ASSERT_TRUE(enter.isAccepted());
        QDropEvent dropped(at, Qt::CopyAction, data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window.viewport(), &dropped);
    }
};

TEST_F(PaneEditsTest, CountsByKeyAndMenu)
{
    for (const int count : {4, 6, 3, 1, 2}) {
        QTest::keyClick(&window, Qt::Key(Qt::Key_0 + count), Qt::AltModifier);
        EXPECT_EQ(int(state().panes.size()), count);
        EXPECT_EQ(window.action("two-panes")->isChecked(), count > 1);
        EXPECT_EQ(window.comparing().isVisible(), count > 1);
    }
    EXPECT_EQ(steps(), 5);
    window.document().undoStack().setIndex(0);
    EXPECT_EQ(state().panes.size(), 1u);
}

TEST_F(PaneEditsTest, TheMenuOfAPane)
{
    QTest::keyClick(&window, Qt::Key_2, Qt::AltModifier);
    window.setTechnique("bump");
    choose(0, "duplicate");
    EXPECT_EQ(techniques(state()), "bump bump parallax ");
    choose(0, "swap-C");
    EXPECT_EQ(techniques(state()), "parallax bump bump ");
    choose(2, "close");
    EXPECT_EQ(techniques(state()), "parallax bump ");
    choose(1, "own-camera");
    EXPECT_FALSE(isLinked(state(), 1));
    choose(1, "own-values");
    EXPECT_EQ(window.parameters().scope(), Scope(1));
    editor("depth").findChild<NumberField*>()->setFocus();
    window.document().edit("Depth", [](State& s) { assign(s, *findParameter("depth"), 0.31f, Scope(1)); });
    EXPECT_EQ(effectiveParameters(state(), 1).depth, 0.31f);
    EXPECT_NE(state().parameters.depth, 0.31f);
    choose(1, "take-over");
    EXPECT_EQ(state().parameters.depth, 0.31f);
    EXPECT_TRUE(ownValues(state(), 1).empty());
    EXPECT_EQ(window.document().undoStack().undoText(), "Take over");
}

TEST_F(PaneEditsTest, ATechniqueIsDroppedOnAPaneAndAPaneOnAnother)
{
    QTest::keyClick(&window, Qt::Key_4, Qt::AltModifier);
    const std::string before = techniques(state());
    dropOn(draggedTechnique("steep"), 2);
    EXPECT_EQ(state().panes[2].technique, "steep");
    dropOn(draggedPane(0), 3);
    EXPECT_EQ(state().panes[0].technique, "pom");
    EXPECT_EQ(state().panes[3].technique, "relief");
    const int steps = this->steps();
    dropOn(draggedPane(1), 1);
    dropOn(draggedPane(17), 1);
    dropOn(draggedTechnique("no such"), 1);
    EXPECT_EQ(this->steps(), steps) << "nothing to do";
    window.action("undo")->trigger();
    window.action("undo")->trigger();
    EXPECT_EQ(techniques(state()), before);
}

TEST_F(PaneEditsTest, AFileDroppedOnThePictureIsStillOpened)
{
    drop(window.viewport(), writeImage("slope_height.png"), window.viewport().rect().center());
}
