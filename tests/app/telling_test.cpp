// How troubles are told: near the drop, coloured, in words of the window; good news is no warning; a failed save can go elsewhere.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions.h"
#include "core/ground/file.h"
#include "core/state/state_json.h"
#include "tests/app/export_support.h"
#include <QClipboard>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>

using namespace relievo;

namespace {
class TellingTest : public ExportingTest {
protected:
    QLabel& note() { return *window.findChild<QLabel*>("drop-note"); }
    QLabel& line() { return *window.findChild<QLabel*>("message-text"); }
    QString counted() { return window.findChild<QToolButton*>("message-count")->text(); }
    QString broken()
    {
        EXPECT_TRUE(writeAtomically(file("broken.png").toStdString(), std::string_view("nothing of use")));
        return file("broken.png");
    }
    template <class Box> static Box* visible(QWidget& parent, const char* name = nullptr)
    {
        const auto boxes = name ? parent.findChildren<Box*>(name) : parent.findChildren<Box*>();
        const auto found = std::ranges::find_if(boxes, &QWidget::isVisible);
        return found == boxes.end() ? nullptr : *found;
    }
};
} // namespace

TEST_F(TellingTest, AnErrorStandsNearTheDropThatItCameFrom)
{
    EXPECT_TRUE(note().isHidden());
    drop(window.viewport(), broken(), {200, 150});
    settle();
    ASSERT_TRUE(note().isVisible());
    EXPECT_TRUE(note().text().contains("broken.png")) << note().text().toStdString();
    const QPoint at = window.viewport().mapTo(&window, QPoint(200, 150));
    EXPECT_LT((note().geometry().topLeft() - at).manhattanLength(), 40);
    EXPECT_TRUE(window.rect().contains(note().geometry()));
    EXPECT_EQ(line().property("role").toString(), "error");
    drop(window.viewport(), writeImage("good_height.png"));
    settle();
    EXPECT_TRUE(note().isHidden()) << "a sound file";
    EXPECT_NE(line().property("role").toString(), "error");
}

TEST_F(TellingTest, ItStaysInTheWindow)
{
    drop(window.viewport(), broken(), {window.viewport().width() - 3, window.viewport().height() - 3});
    settle();
    ASSERT_TRUE(note().isVisible());
    EXPECT_TRUE(window.rect().contains(note().geometry()));
}

TEST_F(TellingTest, GoodNewsIsNoWarning)
{
    Messages& messages = window.messages();
    messages.set("test", Warnings{{"normal-directx", "a.png is DirectX style: converted"}});
    EXPECT_EQ(counted().trimmed(), "1 note");
    messages.set("test", Warnings{{"normal-directx", "converted"}, {"map-missing", "b.png is not there"}, {"depth-map", "flipped"}});
    EXPECT_EQ(counted().trimmed(), "1 warning, 2 notes");
    EXPECT_EQ(window.messageLine().text(), "b.png is not there");
    EXPECT_TRUE(messages.all()[1].isNote && messages.all()[2].isNote);
}

TEST_F(TellingTest, OptionsOfTheCommandLineAreLeftOut)
{
    window.messages().set("test", Error{"there is none", "x", "Name them so, or set maps by hand (--height FILE)"});
    EXPECT_EQ(window.messageLine().text(), "x: there is none. Name them so, or set maps by hand.");
    QApplication::clipboard()->setText("yaw=no");
    window.action("paste-camera")->trigger();
    for (const Message& one : window.messages().all())
        EXPECT_FALSE(one.text.contains("--")) << one.text.toStdString();
    for (const ExportRow& row : kExports)
        EXPECT_EQ(row.help.find("--"), std::string_view::npos) << row.key;
    for (const ActionRow& row : kActions)
        EXPECT_EQ(row.help.find("--"), std::string_view::npos) << row.key;
}

TEST_F(TellingTest, AFailedSaveCanGoElsewhere)
{
    ASSERT_TRUE(window.document().save(file("a.relievo")));
    window.document().start(state(), "/proc/none/a.relievo");
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.33f; });
    window.action("save")->trigger();
    auto* box = visible<QMessageBox>(window, "save-failed");
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->informativeText().contains("/proc/none"));
    EXPECT_TRUE(window.document().isModified());
    for (QAbstractButton* button : box->buttons())
        if (box->buttonRole(button) == QMessageBox::AcceptRole)
            button->click();
    auto* chooser = visible<QFileDialog>(window);
    ASSERT_NE(chooser, nullptr);
    chooser->reject();
}

TEST_F(TellingTest, WhatLiesBesideAnExportIsAskedFor)
{
    ASSERT_TRUE(writeAtomically(file("wall_height.png").toStdString(), std::string_view("mine")));
    ExportDialog& dialog = exportTo("gltf");
    dialog.setOut(file("wall.glb"));
    dialog.run();
    auto* box = visible<QMessageBox>(dialog, "replace");
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->text().contains("wall_height.png")) << box->text().toStdString();
    EXPECT_FALSE(QFile::exists(file("wall.glb")));
    EXPECT_EQ(*readText(file("wall_height.png").toStdString()), "mine");
    for (QAbstractButton* button : box->buttons())
        if (box->buttonRole(button) == QMessageBox::AcceptRole)
            button->click();
    finish(dialog);
    EXPECT_TRUE(QFile::exists(file("wall.glb")));
    EXPECT_NE(*readText(file("wall_height.png").toStdString()), "mine");
    dialog.run(); // its own files are replaced unasked
    EXPECT_EQ(visible<QMessageBox>(dialog, "replace"), nullptr);
    finish(dialog);
}

TEST_F(TellingTest, MissingFoldersOfExportsAreMade)
{
    for (const char* target : {"gltf", "preset", "textures"}) {
        ExportDialog& dialog = exportTo(target);
        const QString out = file((std::string("new/") + target + "/x" + std::string(findExport(target)->suffix)).c_str());
        dialog.setOut(out);
        dialog.run();
        finish(dialog);
        EXPECT_TRUE(QFile::exists(out)) << result(dialog).text().toStdString();
        dialog.close();
    }
}
