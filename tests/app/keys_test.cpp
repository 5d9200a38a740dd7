// The keyboard: number fields, sliders, menus' keys, map slots; and the list of many messages.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/window_support.h"
#include <QFileDialog>
#include <QListWidget>
#include <QMenu>
#include <QScreen>
#include <QTextBrowser>

using namespace relievo;

namespace {
class KeysTest : public WindowTest {
protected:
    NumberField& field(const char* key) { return *editor(key).findChild<NumberField*>(); }
    // A key that is held: its repeats come as X11 sends them, each with a release of its own.
    static void hold(QWidget& widget, int key, int repeats)
    {
        const auto send = [&](QEvent::Type type, bool repeat) {
            QKeyEvent event(type, key, Qt::NoModifier, QString(), repeat);
            QApplication::sendEvent(&widget, &event);
        };
        send(QEvent::KeyPress, false);
        for (int i = 0; i < repeats; ++i) {
            send(QEvent::KeyRelease, true);
            send(QEvent::KeyPress, true);
        }
    }
    static void release(QWidget& widget, int key) { QTest::keyRelease(&widget, Qt::Key(key)); }
};
} // namespace

TEST_F(KeysTest, TheViewsAndTechniquesHaveTheirKeysAfterTheMenuWasOpenToo)
{
    for (QMenu* menu : window.findChildren<QMenu*>())
        if (menu->title() == "Show" || menu->title() == "Technique") {
            Q_EMIT menu->aboutToShow();
            const QString second = menu->findChild<QAction*>(menu->title() == "Show" ? "color" : "bump")->text();
            EXPECT_TRUE(second.endsWith("2")) << second.toStdString();
        }
    QTest::keyClick(&window, Qt::Key_5);
    EXPECT_EQ(state().panes.front().view, "fetches");
    QTest::keyClick(&window, Qt::Key_2, Qt::ControlModifier);
    EXPECT_EQ(state().panes[0].technique, "bump");
}

TEST_F(KeysTest, CtrlZAfterATypedNumberIsTheDocuments)
{
    const float before = state().parameters.depth;
    field("depth").setFocus();
    field("depth").selectAll();
    QTest::keyClicks(&field("depth"), "0.25");
    QTest::keyClick(&field("depth"), Qt::Key_Return);
    ASSERT_FLOAT_EQ(state().parameters.depth, 0.25f);
    QTest::keyClick(&field("depth"), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FLOAT_EQ(state().parameters.depth, before);
    field("depth").selectAll();
    QTest::keyClicks(&field("depth"), "0.4");
    QTest::keyClick(&field("depth"), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NE(field("depth").text(), "0.4") << "while typing it is the field's";
    EXPECT_FLOAT_EQ(state().parameters.depth, before);
}

TEST_F(KeysTest, AHeldArrowIsOneStep)
{
    const float before = state().parameters.depth;
    for (QWidget* widget : {static_cast<QWidget*>(&slider("depth")), static_cast<QWidget*>(&field("depth"))}) {
        widget->setFocus();
        hold(*widget, Qt::Key_Up, 5);
        release(*widget, Qt::Key_Up);
        EXPECT_EQ(steps(), 1);
        EXPECT_FALSE(window.document().inGesture());
        hold(*widget, Qt::Key_Up, 5);
        EXPECT_TRUE(window.document().inGesture());
        window.viewport().setFocus();
        EXPECT_FALSE(window.document().inGesture()) << "the focus went with the key down";
        EXPECT_EQ(steps(), 2);
        window.action("undo")->trigger();
        window.action("undo")->trigger();
        EXPECT_FLOAT_EQ(state().parameters.depth, before);
        window.document().start(state(), {});
    }
}

TEST_F(KeysTest, MapSlotsAreReachedByTheKeyboard)
{
    MapRow& row = mapRow("roughness");
    EXPECT_TRUE(row.focusPolicy() & Qt::TabFocus);
    row.setFocus();
    QTest::keyClick(&row, Qt::Key_Space);
    auto* chooser = window.findChild<QFileDialog*>();
    ASSERT_NE(chooser, nullptr);
    chooser->reject();
    drop(row, writeImage("shine.png", 8));
    settle();
    QTest::keyClick(&row, Qt::Key_Delete);
    settle();
    EXPECT_TRUE(state().slots[std::size_t(MapKind::Roughness)].empty());
}

TEST_F(KeysTest, ManyMessagesAreScrolled)
{
    Warnings many;
    for (int i = 0; i < 60; ++i)
        many.push_back({"a", "Warning number " + std::to_string(i) + "."});
    const int before = window.height();
    window.messages().set("test", many);
    window.messageLine().setOpen(true);
    QTest::qWait(50);
    EXPECT_LT(window.messageLine().height(), 300);
    EXPECT_EQ(window.height(), before);
    window.messages().set("test", Warnings{{"a", "One."}});
    EXPECT_TRUE(waitFor([&] { return window.messageLine().height() < 90; }, 5000)) << "no higher than what there is";
    window.messages().clear("test");
}

// The pages are embedded, and lead to each other.
TEST_F(KeysTest, TheManualIsReadInTheWindow)
{
    window.action("manual")->trigger();
    auto* manual = window.findChild<QDialog*>("manual");
    ASSERT_NE(manual, nullptr);
    auto* text = manual->findChild<QTextBrowser*>();
    auto* pages = manual->findChild<QListWidget*>();
    for (int page = 0; page < pages->count(); ++page) {
        pages->setCurrentRow(page);
        EXPECT_GT(text->toPlainText().size(), 1000) << pages->currentItem()->text().toStdString();
    }
    pages->setCurrentRow(0);
    Q_EMIT text->anchorClicked(QUrl("deciding.md"));
    EXPECT_EQ(pages->currentItem()->text(), "Deciding on a technique");
    EXPECT_TRUE(text->toPlainText().startsWith("Deciding"));
    window.action("manual")->trigger();
    EXPECT_EQ(window.findChildren<QDialog*>("manual").size(), 1) << "one is enough";
    manual->close();
}
