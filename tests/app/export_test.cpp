// The export dialog: names are made whole, it can be stopped, and its end is told wherever the user looks.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/export_support.h"
#include <QPushButton>

using namespace relievo;

namespace {
class ExportTest : public ExportingTest {
protected:
    void SetUp() override
    {
        ExportingTest::SetUp();
        QSettings().setValue("folders/export", folder.path());
    }
    // A large export of textures, running.
    ExportDialog& started()
    {
        window.assets().openDocument("sample:cobblestones@512", State{});
        settle();
        ExportDialog& dialog = exportTo("textures");
        dialog.setOut(file("textures"));
        dialog.run();
        EXPECT_TRUE(dialog.busy());
        return dialog;
    }
    bool says(const char* text) { return window.messageLine().text().contains(text); }
};
} // namespace

TEST_F(ExportTest, ItCanBeStopped)
{
    ExportDialog& dialog = started();
    auto* cancel = dialog.findChild<QPushButton*>("cancel");
    ASSERT_NE(cancel, nullptr);
    EXPECT_TRUE(cancel->isVisible());
    QTest::mouseClick(cancel, Qt::LeftButton);
    EXPECT_FALSE(dialog.busy());
    EXPECT_FALSE(cancel->isVisible());
    EXPECT_TRUE(result(dialog).text().contains("stopped")) << result(dialog).text().toStdString();
    EXPECT_TRUE(dialog.findChild<QPushButton*>("run")->isEnabled());
}

TEST_F(ExportTest, AClosedDialogTellsItsEndInTheMessageLine)
{
    ExportDialog& dialog = started();
    dialog.close();
    EXPECT_TRUE(dialog.busy());
    finish(dialog);
    EXPECT_TRUE(says("Exported to")) << window.messageLine().text().toStdString();
    window.action("export")->trigger();
    EXPECT_FALSE(says("Exported to"));
    dialog.close();
    Q_EMIT dialog.findChild<ExportRun*>()->findChild<Background*>()->failed("no memory");
    EXPECT_TRUE(says("no memory")) << window.messageLine().text().toStdString();
    window.action("export")->trigger();
    EXPECT_TRUE(window.messages().all().isEmpty());
}

TEST_F(ExportTest, ANameIsMadeWhole)
{
    ExportDialog& dialog = exportTo("preset");
    out(dialog).selectAll();
    QTest::keyClicks(&out(dialog), "my look v1.2");
    dialog.run();
    finish(dialog);
    EXPECT_EQ(out(dialog).text(), file("my look v1.2.json"));
    EXPECT_TRUE(QFile::exists(file("my look v1.2.json"))) << result(dialog).text().toStdString();
    EXPECT_FALSE(QFile::exists("my look v1.2"));
}

TEST_F(ExportTest, WhatWasWrittenIsOfItsNameAndTarget)
{
    ExportDialog& dialog = exportTo("preset");
    const auto write = [&] {
        dialog.setOut(file("look.json"));
        dialog.run();
        finish(dialog);
        EXPECT_FALSE(result(dialog).isHidden());
    };
    write();
    QTest::keyClicks(&out(dialog), "x");
    EXPECT_TRUE(result(dialog).isHidden());
    write();
    dialog.setTarget("gltf");
    EXPECT_TRUE(result(dialog).isHidden());
}

TEST_F(ExportTest, OfTwoPicturesItSaysWhichOne)
{
    ExportDialog& dialog = exportTo("preset");
    auto* which = dialog.findChild<QLabel*>("which");
    ASSERT_NE(which, nullptr);
    EXPECT_TRUE(which->isHidden());
    window.action("two-panes")->trigger();
    EXPECT_FALSE(which->isHidden());
    EXPECT_EQ(which->text(), "Picture A (Relief) is exported.");
    window.action("two-panes")->trigger();
    EXPECT_TRUE(which->isHidden());
}

TEST_F(ExportTest, OnlyFoldersThatCouldBeWrittenToAreRemembered)
{
    ExportDialog& dialog = exportTo("preset");
    dialog.setOut("/proc/none/look.json"); // where none can be made
    dialog.run();
    finish(dialog);
    EXPECT_EQ(QSettings().value("folders/export").toString(), folder.path());
    ASSERT_TRUE(QDir(folder.path()).mkdir("deeper"));
    dialog.setOut(file("deeper/look.json"));
    dialog.run();
    finish(dialog);
    EXPECT_EQ(QSettings().value("folders/export").toString(), file("deeper"));
}

TEST_F(ExportTest, ItSaysBeforehandWhatTheEngineWillDraw)
{
    ExportDialog& dialog = exportTo("godot4");
    const QLabel& drawing = *dialog.findChild<QLabel*>("drawing");
    ASSERT_TRUE(waitFor([&] { return drawing.text().startsWith("Godot 4 will draw"); })) << drawing.text().toStdString();
    const QString before = drawing.text();
    window.document().edit("Heights", [](State& s) { s.parameters.depth = s.parameters.depth * 0.1f; });
    EXPECT_TRUE(waitFor([&] { return drawing.text() != before; })); // of another depth
    dialog.setTarget("gltf"); // glTF: no engine is behind it
    EXPECT_TRUE(waitFor([&] { return drawing.text().isEmpty(); }));
}
