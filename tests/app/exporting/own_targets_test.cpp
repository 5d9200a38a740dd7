// Targets of the user's own in the list: added, faulty, changed, gone.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/own_targets.h"
#include "app/window/dialogs/target_list.h"
#include "core/ground/file.h"
#include "tests/app/export_support.h"
#include <QDir>
#include <QListWidget>
#include <QMessageBox>

using namespace relievo;

namespace {
constexpr const char* kSound = R"({"label": "My engine", "help": "Packs for My engine.",
    "textures": [{"key": "packed", "file": "{{name}}_mine.png", "channels": ["height", "roughness"], "bits": 8}]})";

class OwnTargetsTest : public ExportingTest {
protected:
    void SetUp() override
    {
        m_before = qgetenv("XDG_DATA_HOME");
        qputenv("XDG_DATA_HOME", folder.filePath("data").toLocal8Bit());
        ExportingTest::SetUp();
    }
    void TearDown() override
    {
        ExportingTest::TearDown();
        m_before.isNull() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", m_before);
    }
    TargetList& targets() { return *window.findChild<TargetList*>(); }
    QListWidget& list() { return *targets().findChild<QListWidget*>("targets"); }
    QListWidgetItem* item(const char* label)
    {
        const auto found = list().findItems(label, Qt::MatchExactly);
        return found.isEmpty() ? nullptr : found.front();
    }
    QString write(const char* name, const char* text)
    {
        EXPECT_TRUE(writeAtomically(file(name).toStdString(), std::string_view(text)));
        return file(name);
    }
    void inFolder(const char* name, const char* text)
    {
        ASSERT_TRUE(makeOwnTargetsFolder());
        ASSERT_TRUE(writeAtomically((ownTargetsFolder() + '/' + name).toStdString(), std::string_view(text)));
    }

private:
    QByteArray m_before;
};
} // namespace

TEST_F(OwnTargetsTest, OneIsAddedChosenAndExported)
{
    ExportDialog& dialog = exportTo("gltf");
    EXPECT_FALSE(QDir(ownTargetsFolder()).exists()) << "made on demand";
    EXPECT_EQ(item("Your own"), nullptr);
    targets().add(write("mine.json", kSound));
    ASSERT_NE(item("My engine"), nullptr);
    EXPECT_NE(item("Your own"), nullptr);
    EXPECT_EQ(targets().current().label, "My engine");
    EXPECT_TRUE(QFile::exists(ownTargetsFolder() + "/mine.json"));
    dialog.setOut(file("out"));
    dialog.run();
    finish(dialog);
    EXPECT_TRUE(QFile::exists(file("out/Bricks_mine.png"))) << result(dialog).text().toStdString();
    MainWindow other;
    ExportDialog next(other.document(), other.assets());
    EXPECT_EQ(next.findChild<TargetList*>()->current().label, "My engine") << "remembered as any other";
}

TEST_F(OwnTargetsTest, AFaultyOneIsListedWithItsSentence)
{
    inFolder("broken.json", R"({"textures": [{"key": "a", "file": "a.png", "channels": ["hight"]}]})");
    inFolder("sound.tpl", kSound);
    exportTo("gltf");
    const QListWidgetItem* broken = item("broken.json");
    ASSERT_NE(broken, nullptr);
    EXPECT_TRUE(broken->toolTip().contains("is no channel")) << broken->toolTip().toStdString();
    EXPECT_FALSE(broken->flags() & Qt::ItemIsSelectable);
    ASSERT_NE(item("My engine"), nullptr) << "it does not stop the others";
    targets().setCurrent("own/broken");
    EXPECT_EQ(targets().current().key, "gltf");
    auto& search = *targets().findChild<QLineEdit*>("search");
    search.setText("broken");
    EXPECT_FALSE(broken->isHidden());
    EXPECT_TRUE(item("My engine")->isHidden());
}

TEST_F(OwnTargetsTest, TheFolderIsReadAgainWhenTheDialogIsShown)
{
    inFolder("mine.json", kSound);
    ExportDialog& dialog = exportTo("gltf");
    targets().setCurrent("own/mine");
    ASSERT_EQ(targets().current().label, "My engine");
    dialog.close();
    std::string renamed = kSound;
    renamed.replace(renamed.find("My engine"), 9, "My other engine");
    inFolder("mine.json", renamed.c_str());
    window.action("export")->trigger();
    EXPECT_EQ(targets().current().label, "My other engine");
    EXPECT_EQ(dialog.findChild<QLabel*>("target")->text(), "My other engine");
    dialog.close();
    ASSERT_TRUE(QDir(ownTargetsFolder()).removeRecursively());
    window.action("export")->trigger();
    EXPECT_EQ(targets().current().key, kExports.front().key) << "it is gone";
    EXPECT_EQ(item("Your own"), nullptr);
}

TEST_F(OwnTargetsTest, ANameOfTheProgramsOwnDoesNotHideThat)
{
    inFolder("godot4.json", kSound);
    exportTo("godot4");
    EXPECT_EQ(targets().current().label, "Godot 4");
    targets().setCurrent("own/godot4");
    EXPECT_EQ(targets().current().label, "My engine");
}

TEST_F(OwnTargetsTest, WhatIsThereAlreadyIsAskedFor)
{
    inFolder("mine.json", kSound);
    exportTo("gltf");
    targets().add(write("mine.json", "{}"));
    auto* box = targets().findChild<QMessageBox*>("replace");
    ASSERT_NE(box, nullptr);
    box->reject();
    EXPECT_NE(item("My engine"), nullptr);
    targets().add(file("no_such_file.json"));
    EXPECT_TRUE(result(*window.findChild<ExportDialog*>()).text().contains("no_such_file.json"));
}
