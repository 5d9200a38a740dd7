// The files of an export, before and after it is written.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/file_list.h"
#include "core/exporters/file_sizes.h"
#include "core/ground/file.h"
#include "tests/app/export_support.h"
#include <QTreeWidget>

using namespace relievo;

namespace {
class FileListTest : public ExportingTest {
protected:
    FileList& files() { return *window.findChild<FileList*>(); }
    QTreeWidget& list() { return *files().findChild<QTreeWidget*>("files"); }
    QString title() { return files().findChild<QLabel*>("files-title")->text(); }
    QStringList column(int column)
    {
        QStringList texts;
        for (int line = 0; line < list().topLevelItemCount(); ++line)
            texts << list().topLevelItem(line)->text(column);
        return texts;
    }
    void named()
    {
        ASSERT_TRUE(waitFor([&] { return !files().busy(); }));
    }
};
} // namespace

TEST_F(FileListTest, TheyAreNamedBeforeAndMeasuredAfterwards)
{
    ExportDialog& dialog = exportTo("godot4");
    dialog.setOut(file("godot"));
    named();
    const QStringList names = column(0);
    EXPECT_TRUE(names.contains("Bricks.tres")) << names.join('\n').toStdString();
    EXPECT_TRUE(QDir(file("godot")).isEmpty()) << "nothing is written to find them";
    for (const QString& size : column(1))
        EXPECT_TRUE(size.startsWith("about") || size == "a few kB") << size.toStdString();
    EXPECT_TRUE(title().contains("about")) << title().toStdString();
    dialog.run();
    finish(dialog);
    QStringList after = column(0), before = names;
    after.sort(), before.sort();
    EXPECT_EQ(after, before);
    EXPECT_FALSE(column(1).join(' ').contains("about")) << column(1).join(' ').toStdString();
    EXPECT_EQ(column(2).count("written"), names.size());
}

TEST_F(FileListTest, WhatWouldBeReplacedIsMarked)
{
    ASSERT_TRUE(writeAtomically(file("wall_height.png").toStdString(), std::string_view("mine")));
    ExportDialog& dialog = exportTo("gltf");
    dialog.setOut(file("wall.glb"));
    named();
    ASSERT_EQ(column(0), (QStringList{"wall.glb", "wall_height.png"}));
    EXPECT_EQ(column(2), (QStringList{"", "is replaced"}));
    dialog.setOut(file("other.glb"));
    named();
    EXPECT_EQ(column(2), (QStringList{"", ""}));
}

TEST_F(FileListTest, TheyFollowTargetAndDocument)
{
    ExportDialog& dialog = exportTo("textures");
    named();
    const QString before = title();
    EXPECT_TRUE(column(0).contains("relief.json"));
    dialog.setTarget("preset");
    named();
    EXPECT_EQ(column(0), QStringList{"bricks.json"});
    dialog.setTarget("textures");
    window.document().edit("Maps", [](State& s) { s.slots[std::size_t(MapKind::Roughness)] = {}; });
    settle();
    named();
    EXPECT_NE(title(), before);
    window.findChild<QLineEdit*>("out")->clear();
    dialog.setOut("");
    named();
    EXPECT_TRUE(column(0).isEmpty());
}

TEST_F(FileListTest, GuessesFollowTheSizeOfTheTextures)
{
    const Resources& resources = window.assets().resources();
    for (const char* target : {"packed", "textures", "gltf", "web"}) {
        const ExportRow& row = *findExport(target);
        const auto sum = [&](int size) {
            const ExportJob job{state(), resources, file("out").toStdString() + std::string(row.suffix), size, {}};
            double bytes = 0.;
            for (const std::filesystem::path& path : row.writes(job))
                bytes += aboutBytes(row, job, path);
            return bytes;
        };
        EXPECT_GT(sum(0), 4096.) << target << ": at least a byte a texel";
        EXPECT_DOUBLE_EQ(sum(0), sum(64)) << target << ": nothing is made larger";
        EXPECT_GT(sum(0), sum(32)) << target;
    }
}
