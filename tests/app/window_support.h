// A main window for a test: started on a small built-in material, driven by real events.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "app/window/document/editing.h"
#include "app/window/document/files.h"
#include "app/window/document/recent_files.h"
#include "app/window/main_window.h"
#include "app/window/panels/choice_menus.h"
#include "app/window/panels/map_panel.h"
#include "app/window/panels/map_row.h"
#include "app/window/panels/message_line.h"
#include "app/window/panels/parameter_editor.h"
#include "app/window/panels/parameter_panel.h"
#include "app/window/viewport/overlays.h"
#include "app/window/viewport/viewport.h"
#include "app/window/widgets/number_field.h"
#include "app/window/widgets/segmented.h"
#include "app/window/widgets/slider.h"
#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMimeData>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest/QTest>
#include <gtest/gtest.h>

namespace relievo {

inline bool waitFor(const std::function<bool()>& done, int limit = 20000)
{
    return QTest::qWaitFor(done, limit);
}

class WindowTest : public testing::Test {
protected:
    void SetUp() override
    {
        QSettings().clear();
        window.viewport().wantSamples(SamplesAtRest::kLeast); // soon at rest
        window.show();
        window.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
        window.assets().openDocument("sample:bricks@64", State{});
        ASSERT_TRUE(waitFor([&] { return window.assets().ready() && !window.assets().background().busy(); }));
        ASSERT_TRUE(waitFor([&] { return window.viewport().isFull(); })) << "needs OpenGL 4.1";
    }
    void TearDown() override { window.document().start(window.document().state(), {}); } // nothing unsaved: no question

    const State& state() { return window.document().state(); }
    int steps() { return window.document().undoStack().count(); }
    void settle()
    {
        ASSERT_TRUE(waitFor([&] { return !window.assets().background().busy(); }));
    }
    ParameterEditor& editor(const char* key) { return *window.parameters().findChild<ParameterEditor*>(key); }
    Slider& slider(const char* key) { return *editor(key).findChild<Slider*>(); }
    MapRow& mapRow(const char* kind) { return *window.maps().findChild<MapRow*>(QString("map-") + kind); }
    // Acceleration maps that the document wants and that are not made.
    std::vector<std::string_view> missingMaps()
    {
        const Resources& resources = window.assets().resources();
        return resources.accelerationMaps.missingFor(state(), *resources.material);
    }
    // Of the caption of a pane: "technique" or "view". Pressed, it opens a menu, whose item `key` is chosen.
    void chooseInCaption(const char* what, const char* key, std::size_t pane = 0)
    {
        auto* button = window.viewport().findChildren<CaptionChoice*>(what)[qsizetype(pane)];
        QTest::mouseClick(button, Qt::LeftButton);
        auto* menu = button->findChild<QMenu*>();
        ASSERT_NE(menu, nullptr);
        menu->findChild<QAction*>(key)->trigger();
        menu->close();
    }
    QString file(const char* name) { return folder.filePath(name); }

    // Press, moves and release on a widget.
    static void drag(
        QWidget& widget, const QVector<QPoint>& path, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = Qt::NoModifier)
    {
        QTest::mousePress(&widget, button, keys, path.front());
        for (const QPoint& point : path) {
            QMouseEvent move(QEvent::MouseMove, point, widget.mapToGlobal(QPointF(point)), Qt::NoButton, button, keys);
            QApplication::sendEvent(&widget, &move);
        }
        QTest::mouseRelease(&widget, button, keys, path.back());
    }
    static void drop(QWidget& widget, const QString& path, QPoint at = {20, 20})
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&widget, &enter);
        ASSERT_TRUE(enter.isAccepted());
        QDropEvent dropped(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&widget, &dropped);
    }
    // An 8-bit grey image with a slope.
    QString writeImage(const char* name, int size = 16)
    {
        QImage image(size, size, QImage::Format_Grayscale8);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                image.setPixel(x, y, qRgb(x * 255 / size, x * 255 / size, x * 255 / size));
        image.save(file(name));
        return file(name);
    }

    QTemporaryDir folder;
    MainWindow window;
};

} // namespace relievo
