// The ray inspector in the window: a click shows each pane's search, and it follows the document.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/docks.h"
#include "app/window/inspector/picking.h"
#include "app/window/inspector/ray_inspector.h"
#include "app/window/inspector/ray_plot.h"
#include "app/window/widgets/segmented.h"
#include "tests/app/window_support.h"
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QMenu>
#include <QTableWidget>
#include <QToolButton>

using namespace relievo;

namespace {
class InspectorTest : public WindowTest {
protected:
    RayInspector& inspector() { return window.docks().inspector(); }
    template <class Widget> Widget& part(const char* name) { return *inspector().findChild<Widget*>(name); }
    QTableWidget& table() { return part<QTableWidget>("steps"); }
    QString verdict() { return part<QLabel>("verdict").text(); }
    // Two techniques on a plane.
    void arrange(const char* first, const char* second)
    {
        window.document().edit("Arrange", [&](State& state) {
            setPaneCount(state, 2);
            state.mesh = "plane";
            state.camera = Camera{};
            state.parameters.silhouettes = Silhouettes::Off;
            state.parameters.depth = 0.2f;
            state.panes[0].technique = first;
            state.panes[1].technique = second;
        });
        settle();
        if (!inspector().isVisible())
            window.action("ray-inspector")->trigger();
        settle();
    }
    void clickAt(double x, double y) // share of the viewport
    {
        QTest::mouseClick(
            &window.viewport(), Qt::LeftButton, {}, QPoint(int(x * window.viewport().width()), int(y * window.viewport().height())));
        ASSERT_TRUE(waitFor([&] { return !inspector().busy() && !inspector().inspected().panes.empty(); }));
    }
};
} // namespace

TEST_F(InspectorTest, AClickShowsTheSearchOfEachPane)
{
    arrange("relief", "cell-cone");
    EXPECT_TRUE(verdict().startsWith("Click into the picture"));
    clickAt(0.25, 0.5);
    ASSERT_EQ(inspector().inspected().panes.size(), 2u);
    const RayInspection& relief = *inspector().inspected().panes[0].view;
    EXPECT_EQ(relief.technique, "relief");
    EXPECT_EQ(table().rowCount(), int(relief.steps.size()));
    EXPECT_EQ(table().item(0, 0)->text(), "linear");
    EXPECT_EQ(verdict(), QString::fromStdString(relief.verdict));
    part<Segmented>("panes").setCurrent(1);
    Q_EMIT part<Segmented>("panes").chosen(1);
    const RayInspection& cones = *inspector().inspected().panes[1].view;
    EXPECT_EQ(table().rowCount(), int(cones.steps.size()));
    EXPECT_NEAR(table().item(table().rowCount() - 1, 2)->text().toDouble(), cones.hit.t, 1e-4);
    EXPECT_EQ(relief.ray.uv, cones.ray.uv) << "panes that share a camera look along one ray";
    Q_EMIT part<Segmented>("which").chosen(0);
    part<Segmented>("which").setCurrent(1);
    Q_EMIT part<Segmented>("which").chosen(1);
    const auto& light = inspector().inspected().panes[1].light;
    EXPECT_EQ(verdict(), light ? QString::fromStdString(light->verdict) : QString("No light comes to this point through the relief."));
}

TEST_F(InspectorTest, ADragIsNoClick)
{
    arrange("relief", "cell-cone");
    const QPoint middle = window.viewport().rect().center() / 2;
    QTest::mousePress(&window.viewport(), Qt::LeftButton, {}, middle);
    QTest::mouseMove(&window.viewport(), middle + QPoint(20, 0));
    QTest::mouseRelease(&window.viewport(), Qt::LeftButton, {}, middle + QPoint(20, 0));
    settle();
    EXPECT_FALSE(inspector().picked());
}

TEST_F(InspectorTest, ItFollowsTheDocumentAndMarksThePlace)
{
    arrange("relief", "cell-cone");
    clickAt(0.25, 0.5);
    auto& marker = *window.viewport().findChild<PickMarker*>();
    EXPECT_TRUE(marker.isVisible());
    EXPECT_LT((marker.geometry().center() - QPoint(window.viewport().width() / 4, window.viewport().height() / 2)).manhattanLength(), 5);
    window.document().edit("Technique", [](State& state) { state.panes[0].technique = "parallax"; });
    ASSERT_TRUE(waitFor([&] {
        return !inspector().busy() && !inspector().inspected().panes.empty()
            && inspector().inspected().panes[0].view->technique == "parallax";
    }));
    EXPECT_TRUE(verdict().startsWith("It does not search")) << verdict().toStdString();
    window.action("undo")->trigger();
    ASSERT_TRUE(waitFor([&] { return !inspector().busy() && inspector().inspected().panes[0].view->technique == "relief"; }));
    part<QToolButton>("close").click();
    EXPECT_FALSE(inspector().isVisible());
    EXPECT_FALSE(marker.isVisible());
    EXPECT_FALSE(window.action("ray-inspector")->isChecked());
}

TEST_F(InspectorTest, NothingThereIsSaid)
{
    arrange("relief", "cell-cone");
    QTest::mouseClick(&window.viewport(), Qt::LeftButton, {}, QPoint(4, 4)); // beside the plane
    ASSERT_TRUE(waitFor([&] { return inspector().picked() && !inspector().busy(); }));
    EXPECT_EQ(verdict(), "There is no mesh at this point.");
    EXPECT_EQ(table().rowCount(), 0);
    window.document().edit("No map",
        [](State& state) { state.slots[std::size_t(MapKind::Height)] = {}, state.panes[0].technique = state.panes[1].technique = "flat"; });
    settle();
    ASSERT_TRUE(waitFor([&] { return !inspector().busy() && verdict().startsWith("There is no height map"); }));
}

TEST_F(InspectorTest, StepsAreScrubbedAndCopied)
{
    arrange("relief", "cone");
    clickAt(0.25, 0.5);
    table().selectRow(2);
    EXPECT_EQ(table().selectionModel()->selectedRows().size(), 1);
    for (QAction* action : part<QToolButton>("copy").menu()->actions())
        if (action->text().contains("CSV"))
            action->trigger();
    const QString csv = QApplication::clipboard()->text();
    EXPECT_TRUE(csv.startsWith("kind,from,to,u,v,height,fetches\n"));
    EXPECT_EQ(csv.count('\n'), table().rowCount() + 1);
    for (QAction* action : part<QToolButton>("copy").menu()->actions())
        if (action->text().contains("SVG"))
            action->trigger();
    EXPECT_TRUE(QApplication::clipboard()->text().contains("<svg"));
}
