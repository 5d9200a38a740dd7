// Packing presets in the export dialog: chosen, edited, saved, and what is wrong with them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/packing_choice.h"
#include "app/window/dialogs/packing_editor.h"
#include "app/window/dialogs/packing_table.h"
#include "core/ground/file.h"
#include "tests/app/export_support.h"
#include <QComboBox>
#include <QDir>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>

using namespace relievo;

namespace {
constexpr const char* kPacking = R"({"textures": [
    {"key": "mask", "file": "{{name}}_mask.tga", "channels": ["ao", "roughness", "0.25", "height"], "bits": 8},
    {"key": "color", "file": "{{name}}_c.png", "channels": ["color_r", "color_g", "color_b"], "srgb": true, "when": "no codes"}]})";
enum Column { Fault, Key, Name, Format, Red, Green, Blue, Alpha, Bits };

class PackingTest : public ExportingTest {
protected:
    void SetUp() override
    {
        ExportingTest::SetUp();
        ASSERT_TRUE(writeAtomically(file("mine.json").toStdString(), std::string_view(kPacking)));
    }
    PackingChoice& packing() { return *window.findChild<PackingChoice*>(); }
    QComboBox& choices() { return *packing().findChild<QComboBox*>("packing"); }
    PackingEditor& edit()
    {
        packing().findChild<QToolButton*>("edit-packing")->click();
        return *packing().findChild<PackingEditor*>();
    }
    static QTableWidget& table(PackingEditor& editor) { return *editor.findChild<QTableWidget*>("textures"); }
    static QComboBox& list(PackingEditor& editor, int row, int column)
    {
        return *qobject_cast<QComboBox*>(table(editor).cellWidget(row, column));
    }
    static QLineEdit& text(PackingEditor& editor, int row, int column)
    {
        return *qobject_cast<QLineEdit*>(table(editor).cellWidget(row, column));
    }
    static QString fault(PackingEditor& editor, int row) { return table(editor).cellWidget(row, Fault)->toolTip(); }
    static bool canSave(PackingEditor& editor) { return editor.findChild<QPushButton*>("save")->isEnabled(); }
};
} // namespace

TEST_F(PackingTest, AFileTakesThePlaceOfTheTargetsTextures)
{
    ExportDialog& dialog = exportTo("packed");
    EXPECT_EQ(choices().currentText(), "The target's own");
    packing().setFile(file("mine.json"));
    EXPECT_EQ(choices().currentText(), "mine.json");
    dialog.setOut(file("out"));
    dialog.run();
    finish(dialog);
    EXPECT_TRUE(QFile::exists(file("out/Bricks_mask.tga"))) << result(dialog).text().toStdString();
    EXPECT_FALSE(QFile::exists(file("out/Bricks_OcclusionRoughnessMetallic.png")));
    packing().setFile("");
    EXPECT_EQ(choices().currentText(), "The target's own");
    EXPECT_GE(choices().findText("mine.json"), 0) << "offered again";
    dialog.setTarget("gltf");
    EXPECT_FALSE(packing().isEnabled()) << "code writes it";
    EXPECT_EQ(packing().packing(), nullptr);
}

TEST_F(PackingTest, AFileThatCannotBeUsedIsToldAndChangesNothing)
{
    ExportDialog& dialog = exportTo("packed");
    packing().setFile(file("mine.json"));
    ASSERT_TRUE(writeAtomically(file("bad.json").toStdString(), std::string_view(R"({"textures": 3})")));
    packing().setFile(file("bad.json"));
    EXPECT_TRUE(result(dialog).text().contains("must be a list")) << result(dialog).text().toStdString();
    EXPECT_EQ(choices().currentText(), "mine.json");
    EXPECT_LT(choices().findText("bad.json"), 0);
}

TEST_F(PackingTest, WhatIsSavedIsWhatWasRead)
{
    exportTo("packed");
    packing().setFile(file("mine.json"));
    PackingEditor& editor = edit();
    ASSERT_EQ(table(editor).rowCount(), 2);
    EXPECT_EQ(list(editor, 0, Green).currentText(), "roughness");
    EXPECT_EQ(list(editor, 0, Format).currentText(), ".tga");
    ASSERT_TRUE(canSave(editor));
    ASSERT_TRUE(editor.saveTo(file("again.json")));
    EXPECT_EQ(choices().currentText(), "again.json") << "chosen at once";
    const auto before = parseTarget(kPacking, "a", false), after = parseTarget(*readText(file("again.json").toStdString()), "b", false);
    ASSERT_TRUE(after);
    EXPECT_EQ(packingText(before->textures), packingText(after->textures));
}

// Of each of the program's own targets, by the parser.
TEST(Packing, TheTexturesOfAllTargetsRoundTrip)
{
    for (const ExportRow& row : kExports) {
        if (row.code)
            continue;
        const auto again = parseTarget(packingText(textOf(row).textures), "again", false);
        ASSERT_TRUE(again) << row.key << ": " << message(again.error());
        EXPECT_EQ(packingText(again->textures), packingText(textOf(row).textures)) << row.key;
        EXPECT_EQ(again->textures.size(), textOf(row).textures.size());
    }
}

TEST_F(PackingTest, EachRowTellsItsFaultAndNothingIsSavedMeanwhile)
{
    exportTo("packed");
    packing().setFile(file("mine.json"));
    PackingEditor& editor = edit();
    list(editor, 0, Red).setCurrentText("occlusion");
    EXPECT_TRUE(fault(editor, 0).contains("is no channel")) << fault(editor, 0).toStdString();
    EXPECT_TRUE(fault(editor, 1).isEmpty());
    EXPECT_FALSE(canSave(editor));
    list(editor, 0, Red).setCurrentText("0.75");
    EXPECT_TRUE(canSave(editor)) << fault(editor, 0).toStdString();
    text(editor, 1, Key).setText("mask");
    EXPECT_TRUE(fault(editor, 1).contains("twice")) << fault(editor, 1).toStdString();
    EXPECT_TRUE(fault(editor, 0).isEmpty()) << "the first of the two may be called so";
    text(editor, 1, Key).setText("color");
    list(editor, 1, Red).setCurrentText("");
    EXPECT_FALSE(fault(editor, 1).isEmpty()) << "a channel before the last must be something";
    EXPECT_TRUE(editor.findChild<QLabel*>("fault")->text().startsWith("Line 2"))
        << editor.findChild<QLabel*>("fault")->text().toStdString();
    list(editor, 1, Red).setCurrentText("color_r");
    EXPECT_TRUE(canSave(editor));
}

TEST_F(PackingTest, RowsComeAndGo)
{
    exportTo("packed");
    packing().setFile(file("mine.json"));
    PackingEditor& editor = edit();
    editor.findChild<QPushButton*>("add")->click();
    ASSERT_EQ(table(editor).rowCount(), 3);
    EXPECT_TRUE(canSave(editor)) << "a new one is sound";
    list(editor, 2, Bits).setCurrentText("16");
    EXPECT_EQ(editor.findChild<PackingTable*>()->textures().back().bits, 16);
    for (int left = 3; left > 0; --left)
        qobject_cast<QToolButton*>(table(editor).cellWidget(0, table(editor).columnCount() - 1))->click();
    EXPECT_EQ(table(editor).rowCount(), 0);
    EXPECT_FALSE(canSave(editor)) << "nothing to write";
}

TEST_F(PackingTest, AFolderThatCannotBeWrittenToIsTold)
{
    exportTo("packed");
    PackingEditor& editor = edit();
    EXPECT_GT(table(editor).rowCount(), 0) << "of the target's own";
    EXPECT_FALSE(editor.saveTo("/proc/none/p.json"));
    EXPECT_TRUE(editor.findChild<QLabel*>("fault")->text().contains("/proc/none"));
    EXPECT_TRUE(editor.isVisible());
}
