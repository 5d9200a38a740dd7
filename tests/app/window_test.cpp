// The window, driven by real events: panels, picture, panes, undo, camera, files.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions.h"
#include "app/window/dialogs/color_dialog.h"
#include "app/window/viewport/overlays.h"
#include "app/window/widgets/switch.h"
#include "tests/app/window_support.h"
#include <QClipboard>
#include <QLabel>
#include <QToolButton>

using namespace relievo;

TEST_F(WindowTest, StartsWithAPictureAtOnce)
{
    const QImage picture = window.viewport().picture();
    ASSERT_FALSE(picture.isNull());
    EXPECT_NE(picture.pixel(picture.width() / 2, picture.height() / 2), picture.pixel(2, 2));
    EXPECT_FALSE(window.document().isModified());
    EXPECT_TRUE(window.messages().all().isEmpty()) << window.messages().all().front().text.toStdString();
}

TEST_F(WindowTest, GoesCleanlyWithStepsLeft)
{
    MainWindow other;
    other.show();
    other.assets().openDocument("sample:bricks@16", State{});
    ASSERT_TRUE(waitFor([&] { return other.assets().ready(); }));
    other.document().edit("Depth", [](State& s) { s.parameters.depth = 0.3f; });
    other.assets().openDocument("sample:terrain@1024"); // and with work under way
}

TEST_F(WindowTest, EveryActionHasAnItem)
{
    for (const ActionRow& row : kActions)
        EXPECT_NE(window.action(row.key), nullptr) << row.key;
}

TEST_F(WindowTest, OneRowForEachShownParameter)
{
    for (const ParameterRow& row : kParameters) {
        auto* found = window.parameters().findChild<ParameterEditor*>(QString::fromStdString(std::string(row.key)));
        ASSERT_NE(found, nullptr) << row.key;
        EXPECT_EQ(!found->isHidden(), isShown(state(), row)) << row.key;
        EXPECT_NE(found->toolTip().indexOf(QString::fromStdString(std::string(row.help)).left(12)), -1) << row.key;
    }
    window.setTechnique("flat");
    EXPECT_TRUE(editor("maxSteps").isHidden());
}

TEST_F(WindowTest, ASliderDragIsOneStepAndBackIsNone)
{
    Slider& depth = slider("depth");
    const QPoint from = depth.handle();
    const float before = state().parameters.depth;
    drag(depth, {from, from + QPoint(10, 0), from + QPoint(20, 0), from + QPoint(30, 0)});
    EXPECT_EQ(steps(), 1);
    EXPECT_GT(state().parameters.depth, before);
    EXPECT_EQ(depth.value(), double(state().parameters.depth));
    window.action("undo")->trigger();
    EXPECT_EQ(state().parameters.depth, before);
    EXPECT_EQ(depth.value(), double(before));

    window.document().start(state(), {});
    drag(depth, {from, from + QPoint(25, 0), from});
    EXPECT_EQ(steps(), 0);
    EXPECT_EQ(state().parameters.depth, before);
}

TEST_F(WindowTest, CtrlIsFineAndShiftCoarse)
{
    Slider& depth = slider("depth");
    const QPoint from = depth.handle();
    const float before = state().parameters.depth;
    drag(depth, {from, from + QPoint(20, 0)}, Qt::LeftButton, Qt::ControlModifier);
    const float fine = state().parameters.depth - before;
    window.action("undo")->trigger();
    drag(depth, {from, from + QPoint(20, 0)});
    EXPECT_GT(state().parameters.depth - before, 4 * fine);
    EXPECT_GT(fine, 0.f);
    window.action("undo")->trigger();
    drag(depth, {from, from + QPoint(20, 0)}, Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NEAR(std::remainder(double(state().parameters.depth), 0.01), 0., 1e-6) << "coarse: a round number";
}

TEST_F(WindowTest, DoubleClickResets)
{
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.3f; });
    QTest::mouseDClick(editor("depth").findChild<QLabel*>(), Qt::LeftButton);
    EXPECT_EQ(state().parameters.depth, Parameters{}.depth);
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.3f; });
    QTest::mouseDClick(&slider("depth"), Qt::LeftButton, Qt::NoModifier, slider("depth").handle());
    EXPECT_EQ(state().parameters.depth, Parameters{}.depth);
}

TEST_F(WindowTest, NumbersAreTypedAndKeptInRange)
{
    auto* field = editor("depth").findChild<NumberField*>();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "0.25");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_FLOAT_EQ(state().parameters.depth, 0.25f);
    field->selectAll();
    QTest::keyClicks(field, "7");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_FLOAT_EQ(state().parameters.depth, 1.5f);
    field->selectAll();
    QTest::keyClicks(field, "deep");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_FLOAT_EQ(state().parameters.depth, 1.5f);
    EXPECT_EQ(field->text(), "1.500");
}

TEST_F(WindowTest, ATechniqueClickChangesPictureAndState)
{
    const QImage before = window.viewport().picture();
    const auto shown = [&] { return window.viewport().findChild<CaptionChoice*>("technique")->text(); };
    const QString relief = shown();
    chooseInCaption("technique", "flat");
    EXPECT_EQ(state().panes[0].technique, "flat");
    EXPECT_EQ(shown(), "Flat");
    EXPECT_EQ(steps(), 1);
    EXPECT_NE(window.viewport().picture(), before);
    EXPECT_TRUE(waitFor([&] { return window.viewport().isSettled(); }));
    window.action("undo")->trigger();
    EXPECT_EQ(shown(), relief);
}

TEST_F(WindowTest, TwoPanesEachWithATechniqueAndValuesOfTheirOwn)
{
    window.action("two-panes")->trigger();
    ASSERT_EQ(state().panes.size(), 2u);
    EXPECT_NE(state().panes[0].technique, state().panes[1].technique);
    Viewport& picture = window.viewport();
    QTest::mouseClick(&picture, Qt::LeftButton, Qt::NoModifier, QPoint(picture.width() * 3 / 4, picture.height() / 2));
    EXPECT_EQ(picture.activePane(), 1);
    window.setTechnique("bump");
    EXPECT_EQ(state().panes[1].technique, "bump");
    EXPECT_EQ(state().panes[0].technique, "relief");

    window.parameters().setScope(Scope(1));
    QTest::mouseClick(editor("heightMips").findChild<Switch*>(), Qt::LeftButton, Qt::NoModifier, QPoint(10, 10));
    EXPECT_TRUE(state().panes[1].overrides.contains("heightMips"));
    EXPECT_TRUE(state().parameters.heightMips);
    const QImage sheet = picture.picture();
    EXPECT_NE(sheet.copy(0, 0, sheet.width() / 2 - 1, sheet.height()),
        sheet.copy(sheet.width() / 2 + 1, 0, sheet.width() / 2 - 1, sheet.height()));
    window.action("two-panes")->trigger();
    EXPECT_EQ(state().panes.size(), 1u);
    EXPECT_EQ(window.parameters().scope(), kAllPanes);
}

TEST_F(WindowTest, OrbitingMovesTheCameraWithoutAStep)
{
    const Camera before = state().camera;
    drag(window.viewport(), {{200, 200}, {240, 210}, {260, 220}});
    EXPECT_NE(state().camera, before);
    EXPECT_EQ(steps(), 0);
    EXPECT_FALSE(window.document().isModified());
    QWheelEvent wheel(
        {200, 200}, window.viewport().mapToGlobal(QPointF(200, 200)), {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&window.viewport(), &wheel);
    EXPECT_TRUE(state().camera.distance.has_value());
    window.action("frame")->trigger();
    EXPECT_FALSE(state().camera.distance.has_value());
    window.action("reset-camera")->trigger();
    EXPECT_EQ(state().camera, framed({}));
}

TEST_F(WindowTest, TheLightIsDraggedAsOneStep)
{
    const float yaw = state().parameters.lightYaw;
    drag(window.viewport(), {{200, 200}, {240, 210}, {260, 220}}, Qt::RightButton, Qt::ShiftModifier);
    EXPECT_NE(state().parameters.lightYaw, yaw);
    EXPECT_EQ(steps(), 1);
}

TEST_F(WindowTest, FlyingTakesTheLettersFromTheMenus)
{
    Viewport& picture = window.viewport();
    QTest::mousePress(&picture, Qt::RightButton, Qt::NoModifier, {200, 200});
    QTest::keyPress(&picture, Qt::Key_W);
    EXPECT_TRUE(waitFor([&] { return state().camera.target.has_value(); }));
    QTest::keyRelease(&picture, Qt::Key_W);
    QTest::mouseRelease(&picture, Qt::RightButton, Qt::NoModifier, {200, 200});
    EXPECT_EQ(steps(), 0);
}

TEST_F(WindowTest, ThePictureIsFullAgainWhenTheHandRests)
{
    Viewport& picture = window.viewport();
    QTest::mousePress(&picture, Qt::LeftButton, Qt::NoModifier, {200, 200});
    for (int i = 1; i < 6; ++i) {
        QMouseEvent move(QEvent::MouseMove, QPointF(200 + 5 * i, 200), picture.mapToGlobal(QPointF(200 + 5 * i, 200)), Qt::NoButton,
            Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&picture, &move);
        QTest::qWait(5);
    }
    EXPECT_TRUE(waitFor([&] { return picture.isFull(); })) << "with the button still down";
    QTest::mouseRelease(&picture, Qt::LeftButton, Qt::NoModifier, {225, 200});
    EXPECT_TRUE(waitFor([&] { return picture.isSettled(); }));
}

TEST_F(WindowTest, TheCameraTravelsAsText)
{
    window.document().edit({}, [](State& s) { s.camera.yaw = 12.5f, s.camera.distance = 2.f; });
    const Camera copied = state().camera;
    window.action("copy-camera")->trigger();
    window.action("reset-camera")->trigger();
    window.action("paste-camera")->trigger();
    EXPECT_EQ(state().camera, copied);
    QApplication::clipboard()->setText("no camera at all");
    window.action("paste-camera")->trigger();
    EXPECT_EQ(state().camera, copied);
    EXPECT_TRUE(window.messages().all().size() == 1 && window.messages().all().front().isError);
}

TEST_F(WindowTest, ThePictureIsCopied)
{
    window.action("copy-picture")->trigger();
    const QImage copied = QApplication::clipboard()->image();
    EXPECT_EQ(copied.height(), int(window.viewport().height() * window.viewport().devicePixelRatioF()));
}

TEST_F(WindowTest, ViewsAndWireframeFollowTheState)
{
    QTest::keyClick(&window, Qt::Key_5);
    EXPECT_EQ(state().panes.front().view, "fetches");
    window.action("wireframe")->trigger();
    EXPECT_TRUE(state().parameters.wireframe);
    window.action("undo")->trigger();
    EXPECT_FALSE(window.action("wireframe")->isChecked());
}

TEST_F(WindowTest, MessagesAreCountedOpenedAndVanish)
{
    window.messages().set("test", Warnings{{"a", "One."}, {"b", "Two."}});
    auto* count = window.messageLine().findChild<QToolButton*>("message-count");
    EXPECT_EQ(count->text().trimmed(), "2 warnings");
    QTest::mouseClick(count, Qt::LeftButton);
    EXPECT_TRUE(window.messageLine().isOpen());
    window.messages().clear("test");
    EXPECT_FALSE(window.messageLine().isOpen());
    EXPECT_TRUE(count->isHidden());
}

TEST_F(WindowTest, HiddenPanelsStayHidden)
{
    const int width = window.maps().width();
    window.action("panels")->trigger();
    EXPECT_TRUE(window.maps().isHidden());
    window.close();
    MainWindow next;
    next.show();
    EXPECT_FALSE(next.action("panels")->isChecked());
    EXPECT_TRUE(next.maps().isHidden());
    EXPECT_TRUE(next.parameters().isHidden());
    next.action("panels")->trigger();
    EXPECT_TRUE(next.maps().isVisible());
    EXPECT_NEAR(next.maps().width(), width, 2);
    next.close();
    EXPECT_TRUE(MainWindow().action("panels")->isChecked());
}

TEST_F(WindowTest, EachPaneHasALegendAndItsEndIsSetForAll)
{
    const auto shown = [&] {
        QVector<HeatLegend*> list;
        for (HeatLegend* legend : window.viewport().findChildren<HeatLegend*>())
            if (legend->isVisible())
                list.append(legend);
        return list;
    };
    EXPECT_TRUE(shown().isEmpty());
    window.setView("fetches");
    EXPECT_EQ(shown().size(), 1);
    window.action("two-panes")->trigger();
    EXPECT_EQ(shown().size(), 2);
    window.document().edit("Range", [](State& s) { s.panes[1].overrides["fetchRange"] = 80.f; }); // as a file may have it
    ASSERT_EQ(shown().size(), 2);
    const int middle = window.viewport().width() / 2;
    EXPECT_EQ(shown()[0]->max(), 40.);
    EXPECT_LT(shown()[0]->geometry().right(), middle);
    EXPECT_EQ(shown()[1]->max(), 80.);
    EXPECT_GT(shown()[1]->x(), middle);
    window.parameters().setScope(Scope(1));
    auto* field = editor("fetchRange").findChild<NumberField*>();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "60");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(shown()[0]->max(), 60.);
    EXPECT_EQ(shown()[1]->max(), 60.) << "what is set by hand is for both";
    EXPECT_FLOAT_EQ(state().parameters.fetchRange, 60.f);
}

TEST_F(WindowTest, AChosenColorIsAStepOfItsOwn)
{
    const glm::vec3 before = state().parameters.lightColor;
    editor("lightColor").findChild<Swatch*>()->click();
    auto* dialog = editor("lightColor").findChild<ColorDialog*>();
    ASSERT_NE(dialog, nullptr);
    QWidget* picker = nullptr;
    for (QWidget* part : dialog->findChildren<QWidget*>())
        if (QString(part->metaObject()->className()).endsWith("QColorPicker"))
            picker = part;
    ASSERT_NE(picker, nullptr);
    const auto pick = [&](QPoint from, QPoint to) {
        drag(*picker, {from, (from + to) / 2, to});
        QTest::qWait(10);
    };
    pick({10, 10}, {40, 30});
    const glm::vec3 first = state().parameters.lightColor;
    EXPECT_NE(first, before);
    EXPECT_EQ(steps(), 1);
    EXPECT_FALSE(window.document().inGesture()) << "the dialog is still open";
    pick({60, 40}, {80, 50});
    EXPECT_EQ(steps(), 2);
    const QPoint handle = slider("depth").handle();
    drag(slider("depth"), {handle, handle + QPoint(20, 0)});
    drag(slider("depth"), {slider("depth").handle(), slider("depth").handle() + QPoint(20, 0)});
    EXPECT_EQ(steps(), 4);
    for (int i = 0; i < 3; ++i)
        window.action("undo")->trigger();
    EXPECT_EQ(state().parameters.lightColor, first);
    EXPECT_EQ(dialog->currentColor().rgb(), toDisplay(first).rgb()) << "the dialog follows";
    window.action("undo")->trigger();
    EXPECT_EQ(state().parameters.lightColor, before);
    dialog->close();
    EXPECT_FALSE(window.document().inGesture());
}
