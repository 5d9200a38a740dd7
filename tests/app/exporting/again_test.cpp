// Exporting once more without the dialog, stopping that, and opening the folder that was written to.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/widgets/switch.h"
#include "core/ground/file.h"
#include "core/state/state_json.h"
#include "tests/app/export_support.h"
#include <QDesktopServices>
#include <QMessageBox>
#include <QPushButton>
#include <QUrl>

using namespace relievo;

namespace {
// Takes the place of the system's file manager.
class FileManager : public QObject {
    Q_OBJECT
public:
    FileManager() { QDesktopServices::setUrlHandler("file", this, "open"); }
    ~FileManager() override { QDesktopServices::unsetUrlHandler("file"); }
    QList<QUrl> opened;

public Q_SLOTS:
    void open(const QUrl& url) { opened << url; }
};

class AgainTest : public ExportingTest {
protected:
    void SetUp() override
    {
        ExportingTest::SetUp();
        QSettings().setValue("folders/export", folder.path());
    }
    void exportPreset()
    {
        ExportDialog& dialog = exportTo("preset");
        dialog.setOut(file("look.json"));
        dialog.run();
        finish(dialog);
    }
    ExportDialog& dialog() { return *window.findChild<ExportDialog*>(); }
    float writtenDepth() { return readState(State{}, file("look.json").toStdString())->state.parameters.depth; }
    QPushButton* offered(const char* label)
    {
        for (QPushButton* button : window.messageLine().findChild<QWidget*>("choices")->findChildren<QPushButton*>())
            if (button->text() == label)
                return button;
        return nullptr;
    }
    FileManager manager;
};
} // namespace

TEST_F(AgainTest, WithoutALastTimeTheDialogIsShown)
{
    window.action("export-again")->trigger();
    EXPECT_TRUE(dialog().isVisible());
    EXPECT_FALSE(dialog().busy());
}

TEST_F(AgainTest, TheLastExportIsRepeatedAsTheDocumentIsNow)
{
    exportPreset();
    dialog().close();
    dialog().setTarget("gltf"); // chosen, but not exported
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.31f; });
    window.action("export-again")->trigger();
    EXPECT_FALSE(dialog().isVisible());
    EXPECT_EQ(dialog().findChild<QMessageBox*>(), nullptr) << "its own file is replaced unasked";
    finish(dialog());
    EXPECT_FLOAT_EQ(writtenDepth(), 0.31f);
    EXPECT_TRUE(window.messageLine().text().contains("look.json")) << window.messageLine().text().toStdString();
}

TEST_F(AgainTest, SizeAndCuresAreThoseOfTheLastTime)
{
    ExportDialog& made = exportTo("godot4");
    made.findChild<Switch*>("cure-normals")->click();
    made.setOut(file("godot"));
    made.run();
    finish(made);
    made.close();
    made.findChild<Switch*>("cure-normals")->click(); // another choice, not exported
    window.document().edit("Maps", [](State& s) { s.slots[std::size_t(MapKind::Normal)] = {}; });
    settle();
    ASSERT_TRUE(QDir(file("godot")).removeRecursively());
    window.action("export-again")->trigger();
    finish(made);
    EXPECT_FALSE(QDir(file("godot")).isEmpty());
    EXPECT_TRUE(QDir(file("godot")).entryList({"*_normal*.png"}).isEmpty());
}

TEST_F(AgainTest, AnotherDocumentWasNotExportedYet)
{
    exportPreset();
    dialog().close();
    window.document().start(state(), {});
    window.action("export-again")->trigger();
    EXPECT_TRUE(dialog().isVisible());
    EXPECT_FALSE(dialog().busy());
}

TEST_F(AgainTest, ItTellsItsWayInTheMessageLineAndCanBeStopped)
{
    window.assets().openDocument("sample:cobblestones@512", State{});
    settle();
    ExportDialog& made = exportTo("textures");
    made.setOut(file("textures"));
    made.run();
    finish(made);
    made.close();
    window.action("export-again")->trigger();
    EXPECT_TRUE(window.messageLine().text().contains("Exporting for Texture folder")) << window.messageLine().text().toStdString();
    QPushButton* stop = offered("Stop");
    ASSERT_NE(stop, nullptr);
    QTest::mouseClick(stop, Qt::LeftButton);
    EXPECT_FALSE(made.busy());
    EXPECT_TRUE(window.messageLine().text().contains("stopped")) << window.messageLine().text().toStdString();
}

TEST_F(AgainTest, WhatIsStillLoadingIsTold)
{
    exportPreset();
    dialog().close();
    window.document().edit("Mesh", [](State& s) { s.mesh = "/no/such/mesh.obj"; });
    window.action("export-again")->trigger();
    EXPECT_TRUE(window.messageLine().text().contains("not loaded")) << window.messageLine().text().toStdString();
}

TEST_F(AgainTest, TheFolderOpens)
{
    auto& button = [&]() -> QPushButton& {
        exportPreset();
        return *dialog().findChild<QPushButton*>("open-folder");
    }();
    ASSERT_TRUE(button.isVisible());
    QTest::mouseClick(&button, Qt::LeftButton);
    EXPECT_EQ(manager.opened, QList<QUrl>{QUrl::fromLocalFile(folder.path())});
    dialog().setOut(file("other.json"));
    EXPECT_FALSE(button.isVisible()) << "nothing was written there yet";
    dialog().close();
    window.action("export-again")->trigger();
    finish(dialog());
    QPushButton* offer = offered("Open folder");
    ASSERT_NE(offer, nullptr);
    QTest::mouseClick(offer, Qt::LeftButton);
    EXPECT_EQ(manager.opened.size(), 2);
}

#include "again_test.moc"
