// What the eye and the hand meet first: the starting scene, room on small screens, controls that stay, drops, keys, contrast.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/export_dialog.h"
#include "app/window/document/starting_scene.h"
#include "app/window/panels/choice_menus.h"
#include "app/window/panels/drop_frame.h"
#include "app/window/widgets/text.h"
#include "app/window/widgets/theme.h"
#include "core/mesh/mesh.h"
#include "core/state/environments.h"
#include "tests/app/window_support.h"
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QStyle>
#include <QToolButton>
#include <cmath>

using namespace relievo;

namespace {
class LookTest : public WindowTest {
protected:
    QAbstractButton& addMap() { return *window.maps().findChild<QAbstractButton*>("add-map"); }
    // In the window, of the widget's middle.
    QPoint placeOf(const QWidget& widget) { return widget.mapTo(widget.window(), widget.rect().center()); }
    bool isInside(const QWidget& widget)
    {
        return widget.isVisible() && window.rect().contains(QRect(widget.mapTo(&window, QPoint(0, 0)), widget.size()));
    }
};

double luminance(const QColor& color)
{
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b)
{
    const double one = luminance(a), other = luminance(b);
    return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}
} // namespace

TEST_F(LookTest, ANewDocumentIsASphereWithTrueSilhouettes)
{
    window.action("new")->trigger();
    settle();
    ASSERT_TRUE(waitFor([&] { return state().mesh == "sphere"; }));
    EXPECT_EQ(state().parameters.silhouettes, Silhouettes::Prisms);
    EXPECT_EQ(state().parameters.background, Backdrop::Gradient);
    EXPECT_TRUE(state().parameters.ground);
    EXPECT_EQ(state().camera, startingScene().camera);
    EXPECT_FALSE(window.document().isModified());
    EXPECT_LT(std::abs(state().camera.pitch), 15.f) << "the poles lie on the outline";
    window.maps().setMesh("plane");
    settle();
    EXPECT_GT(state().camera.pitch, 20.f) << "nothing would be seen of a plane from its edge";
}

TEST_F(LookTest, EnvironmentsAreChosenByTheirPictures)
{
    auto& list = *window.maps().findChild<QComboBox*>("environments");
    ASSERT_EQ(list.count(), int(kEnvironments.size()));
    QList<QRgb> middles;
    for (int i = 0; i < list.count(); ++i) {
        EXPECT_EQ(list.itemText(i), qt(kEnvironments[std::size_t(i)].label));
        const QRgb above = list.itemIcon(i).pixmap(list.iconSize()).toImage().pixel(24, 6);
        EXPECT_FALSE(middles.contains(above)) << i;
        middles.append(above);
    }
    list.setCurrentIndex(2);
    Q_EMIT list.activated(2);
    settle();
    EXPECT_EQ(state().environment, kEnvironments[2].key);
    ASSERT_TRUE(waitFor([&] { return window.assets().resources().environmentName == state().environment; }));
    window.action("undo")->trigger();
    settle();
    EXPECT_EQ(state().environment, "studio");
    EXPECT_EQ(list.currentIndex(), 0);
}

TEST_F(LookTest, AProjectOwesNothingToTheSceneBeforeIt)
{
    QFile project(file("old.relievo"));
    ASSERT_TRUE(project.open(QIODevice::WriteOnly));
    project.write(R"({"relievo":1,"maps":{"height":{"file":"sample:bricks@64"}},"camera":{"yaw":10}})");
    project.close();
    window.action("new")->trigger();
    settle();
    window.document().start(state(), {});
    window.files().open(file("old.relievo"));
    settle();
    EXPECT_EQ(state().mesh, State{}.mesh);
    EXPECT_EQ(state().parameters, State{}.parameters);
    EXPECT_EQ(state().camera.pitch, Camera{}.pitch);
    EXPECT_EQ(state().camera.fill, 0.f);
}

TEST_F(LookTest, EverythingIsReachedInASmallWindow)
{
    for (const QSize size : {QSize(800, 600), QSize(640, 360)}) {
        window.resize(size);
        ASSERT_TRUE(waitFor([&] { return window.size() == size; })) << size.width();
        QTest::qWait(50);
        auto* tabs = window.findChild<Segmented*>("panel");
        ASSERT_TRUE(isInside(*tabs));
        QTest::mouseClick(tabs, Qt::LeftButton, Qt::NoModifier, tabs->segment(1).center());
        EXPECT_TRUE(isInside(window.maps()));
        EXPECT_FALSE(window.parameters().isVisible());
        QTest::mouseClick(tabs, Qt::LeftButton, Qt::NoModifier, tabs->segment(0).center());
        EXPECT_TRUE(isInside(window.parameters()));
        EXPECT_TRUE(isInside(window.viewport()));
        EXPECT_TRUE(isInside(slider("depth")));
        for (const QToolButton* button : window.findChildren<QToolButton*>())
            if (button->isVisible() && button->defaultAction()) {
                EXPECT_TRUE(isInside(*button)) << button->defaultAction()->text().toStdString();
            }
    }
    window.resize(1280, 700);
    ASSERT_TRUE(waitFor([&] { return window.maps().isVisible() && window.parameters().isVisible(); })) << "a column on each side";
    EXPECT_LT(placeOf(window.maps()).x(), placeOf(window.viewport()).x());
}

TEST_F(LookTest, TheFirstSizeFitsTheScreen)
{
    MainWindow first;
    const QSize room = first.screen()->availableSize();
    EXPECT_LE(first.width(), room.width());
    EXPECT_LE(first.height(), room.height());
}

TEST_F(LookTest, SlidersAreLongAndFineWhereValuesAreSmall)
{
    window.resize(1280, 800);
    QTest::qWait(50);
    for (const Slider* one : window.parameters().findChildren<Slider*>())
        if (one->isVisible()) {
            EXPECT_GE(one->width(), 120);
        }
    const SliderScale depth = scaleOf(*findParameter("depth"));
    EXPECT_LT(depth.value(0.5), 0.25) << "of 1.5";
    EXPECT_NEAR(depth.position(0.08), 0.4, 0.1) << "what is usual lies in the middle";
}

TEST_F(LookTest, CaptionsOfferTechniquesInGroupsAndViews)
{
    window.action("two-panes")->trigger();
    chooseInCaption("technique", "cell-cone", 1);
    EXPECT_EQ(state().panes[1].technique, "cell-cone");
    EXPECT_EQ(state().panes[0].technique, "relief");
    EXPECT_EQ(window.viewport().activePane(), 1);
    chooseInCaption("view", "normal", 1);
    EXPECT_EQ(state().panes[1].view, "normal");
    EXPECT_EQ(state().panes[0].view, "shaded") << "the other one stays";
    QMenu menu;
    fillTechniques(menu, "relief", [](const TechniqueRow&) {});
    const auto headings = std::ranges::count_if(menu.actions(), [](QAction* a) { return !a->isSeparator() && !a->isEnabled(); });
    EXPECT_EQ(headings, 5);
    EXPECT_NE(menu.findChild<QAction*>("as-godot4"), nullptr);
    EXPECT_TRUE(menu.findChild<QAction*>("relief")->isChecked());
}

TEST_F(LookTest, MapsThatAreNotThereAreFoldedAway)
{
    EXPECT_TRUE(mapRow("height").isVisible());
    EXPECT_FALSE(mapRow("normal").isVisible());
    QTest::mouseClick(&addMap(), Qt::LeftButton);
    EXPECT_TRUE(mapRow("normal").isVisible());
    EXPECT_GT(placeOf(mapRow("normal")).y(), placeOf(addMap()).y());
    window.maps().assign(MapKind::Metallic, writeImage("m.png"));
    settle();
    ASSERT_TRUE(waitFor([&] { return mapRow("metallic").isFilled(); }));
    EXPECT_TRUE(mapRow("metallic").isVisible());
    EXPECT_FALSE(mapRow("opacity").isVisible());
    window.maps().assign(MapKind::Height, {});
    settle();
    EXPECT_TRUE(waitFor([&] { return !mapRow("height").isFilled(); }));
    EXPECT_TRUE(mapRow("height").isVisible()) << "most else comes from it";
}

TEST_F(LookTest, ADraggedFileUnfoldsTheMaps)
{
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(writeImage("n.png"))});
    QDragEnterEvent enter({20, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&addMap(), &enter);
    EXPECT_TRUE(mapRow("normal").isVisible());
}

TEST_F(LookTest, WhatIsClickedDoesNotMove)
{
    auto* shapes = window.maps().findChild<Segmented*>("shapes");
    const QPoint before = placeOf(*shapes);
    window.maps().assign(MapKind::Metallic, writeImage("m.png"));
    window.maps().setMesh("teapot");
    settle();
    ASSERT_TRUE(waitFor([&] { return mapRow("metallic").isFilled() && state().mesh == "teapot"; }));
    QTest::qWait(50);
    EXPECT_EQ(placeOf(*shapes), before);

    window.action("export")->trigger();
    auto* dialog = window.findChild<ExportDialog*>();
    auto* run = dialog->findChild<QPushButton*>("run");
    ASSERT_TRUE(waitFor([&] { return run->isVisible(); }));
    QTest::qWait(50);
    const QPoint there = run->mapToGlobal(QPoint(0, 0));
    for (const ExportRow& target : kExports) {
        dialog->setTarget(target.key);
        dialog->setOut(file("out") + qt(target.key));
        QTest::mouseClick(run, Qt::LeftButton);
        ASSERT_TRUE(waitFor([&] { return !dialog->busy() && dialog->findChild<QLabel*>("result")->isVisible(); }));
        QTest::qWait(50);
        EXPECT_EQ(run->mapToGlobal(QPoint(0, 0)), there) << target.key;
    }
    dialog->close();
}

TEST_F(LookTest, ADropIsACopyAndSeenBefore)
{
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(writeImage("h.png"))});
    auto* frame = window.findChild<DropFrame*>();
    for (QWidget* target : {static_cast<QWidget*>(&window), static_cast<QWidget*>(&mapRow("normal"))}) {
        QDragEnterEvent enter({20, 20}, Qt::CopyAction | Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
        enter.setDropAction(Qt::MoveAction); // as some file managers propose it
        QApplication::sendEvent(target, &enter);
        EXPECT_TRUE(enter.isAccepted());
        EXPECT_EQ(enter.dropAction(), Qt::CopyAction);
        EXPECT_TRUE(frame->isVisible());
        QDropEvent dropped({20, 20}, Qt::CopyAction | Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
        dropped.setDropAction(Qt::MoveAction);
        QApplication::sendEvent(target, &dropped);
        EXPECT_EQ(dropped.dropAction(), Qt::CopyAction);
        EXPECT_FALSE(frame->isVisible());
        settle();
    }
    QDragEnterEvent moves({20, 20}, Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &moves);
    EXPECT_FALSE(moves.isAccepted()) << "its source would remove the file";
}

TEST_F(LookTest, KeysOrbitAndZoom)
{
    const Camera before = state().camera;
    QTest::keyClick(&window.viewport(), Qt::Key_Right);
    EXPECT_NE(state().camera.yaw, before.yaw);
    QTest::keyClick(&window.viewport(), Qt::Key_Left);
    EXPECT_FLOAT_EQ(state().camera.yaw, before.yaw);
    QTest::keyClick(&window.viewport(), Qt::Key_Up);
    EXPECT_GT(state().camera.pitch, before.pitch);
    QTest::keyClick(&window.viewport(), Qt::Key_PageUp);
    const float near = state().camera.distance.value_or(0.f);
    QTest::keyClick(&window.viewport(), Qt::Key_PageDown);
    EXPECT_GT(state().camera.distance.value_or(0.f), near);
    EXPECT_EQ(steps(), 0);
    window.action("shortcuts")->trigger();
    int told = 0;
    for (const QLabel* label : window.findChildren<QLabel*>())
        told += label->text() == "move closer" || label->text() == "orbit to the left";
    EXPECT_EQ(told, 2);
}

TEST_F(LookTest, DimTextIsReadable)
{
    for (const Look look : {Look::Light, Look::Dark}) {
        applyLook(*qApp, look);
        const QPalette palette = QApplication::palette();
        for (const QPalette::ColorRole behind : {QPalette::Window, QPalette::Base, QPalette::Button})
            for (const QColor& text : {dimText(palette), warningColor(palette), palette.color(QPalette::WindowText)})
                EXPECT_GE(contrast(text, palette.color(behind)), 5.5) << text.name().toStdString();
    }
}

TEST_F(LookTest, BoxesShowOwnIcons)
{
    for (const QStyle::StandardPixmap which : {QStyle::SP_DirIcon, QStyle::SP_FileDialogToParent, QStyle::SP_MessageBoxWarning})
        EXPECT_NE(QApplication::style()->standardIcon(which).pixmap(16).toImage(), QImage());
    EXPECT_EQ(QApplication::style()->standardIcon(QStyle::SP_DirIcon).pixmap(16).toImage(), icon("folder").pixmap(16).toImage());
    EXPECT_EQ(QApplication::style()->standardIcon(QStyle::SP_MessageBoxWarning).pixmap(16).toImage(), icon("warning").pixmap(16).toImage());
}
