// What is written and what is asked first: saving, exporting, closing.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/state_json.h"
#include "tests/app/export_support.h"
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

using namespace relievo;

namespace {
class SavingTest : public ExportingTest {
protected:
    // The question that is open now; nullptr when there is none.
    static QMessageBox* asked(QWidget& parent, const char* name)
    {
        for (QMessageBox* box : parent.findChildren<QMessageBox*>(name))
            if (box->isVisible())
                return box;
        return nullptr;
    }
    static void answer(QMessageBox& box, QMessageBox::ButtonRole role)
    {
        for (QAbstractButton* button : box.buttons())
            if (box.buttonRole(button) == role)
                return button->click();
    }
    void write(const char* name)
    {
        QFile there(file(name));
        ASSERT_TRUE(there.open(QIODevice::WriteOnly));
        there.write("mine");
    }
    QByteArray contents(const char* name)
    {
        QFile there(file(name));
        return there.open(QIODevice::ReadOnly) ? there.readAll() : QByteArray();
    }
    // Saves as `name` by the file chooser.
    void saveAs(const char* name)
    {
        window.document().start(state(), {}); // a chooser that proposes a file that is there would ask on its own
        window.files().saveAs();
        const auto choosers = window.findChildren<QFileDialog*>(); // those that are done may still be there
        const auto chooser = std::ranges::find_if(choosers, &QWidget::isVisible);
        ASSERT_NE(chooser, choosers.end());
        (*chooser)->setDirectory(folder.path());
        auto* typed = (*chooser)->findChild<QLineEdit*>("fileNameEdit");
        typed->setText(name);
        Q_EMIT typed->textEdited(name); // the proposal is no longer selected
        QTimer::singleShot(500, *chooser, [] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()); box && box->objectName().isEmpty())
                box->reject(); // never hang
        });
        static_cast<QDialog*>(*chooser)->accept();
        QTest::qWait(10);
    }
    void dropColor()
    {
        drop(mapRow("color"), writeImage("wall_color.png", 512));
        ASSERT_TRUE(window.assets().background().busy());
    }
    std::string savedColor() { return readState(State{}, file("a.relievo").toStdString())->state.slots[std::size_t(MapKind::Color)].file; }
    void type(const char* text)
    {
        auto* field = editor("depth").findChild<NumberField*>();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
    }
};
} // namespace

TEST_F(SavingTest, ANumberBeingTypedIsSaved)
{
    ASSERT_TRUE(window.document().save(file("a.relievo")));
    type("0.25");
    window.action("save")->trigger();
    EXPECT_FLOAT_EQ(readState(State{}, file("a.relievo").toStdString())->state.parameters.depth, 0.25f);
    type("0.31");
    window.close();
    EXPECT_NE(asked(window, "unsaved"), nullptr) << "the number counts as unsaved";
    EXPECT_FLOAT_EQ(state().parameters.depth, 0.31f);
}

TEST_F(SavingTest, ANumberBeingTypedIsExported)
{
    type("0.25");
    ExportDialog& dialog = exportTo("preset");
    dialog.setOut(file("look.json"));
    dialog.run();
    finish(dialog);
    EXPECT_FLOAT_EQ(readState(State{}, file("look.json").toStdString())->state.parameters.depth, 0.25f);
}

TEST_F(SavingTest, WhatIsStillLoadingIsSaved)
{
    ASSERT_TRUE(window.document().save(file("a.relievo")));
    dropColor();
    window.action("save")->trigger();
    settle();
    EXPECT_EQ(savedColor(), file("wall_color.png").toStdString());
    EXPECT_FALSE(window.document().isModified());
}

// The mesh that was loading when Save was chosen is not wanted any more: what is saved is all that there is, and only once.
TEST_F(SavingTest, ASaveNeedsNotWaitForWhatIsNotWantedAnyMore)
{
    ASSERT_TRUE(window.document().save(file("a.relievo")));
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.321f; });
    window.maps().setMesh("torus");
    window.action("save")->trigger();
    window.maps().setMesh("plane");
    settle();
    const auto saved = [&] { return readState(State{}, file("a.relievo").toStdString())->state; };
    EXPECT_FLOAT_EQ(saved().parameters.depth, 0.321f);
    EXPECT_EQ(saved().mesh, "plane");
    EXPECT_FALSE(window.document().isModified());
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.444f; });
    window.maps().setMesh("sphere");
    settle();
    EXPECT_FLOAT_EQ(saved().parameters.depth, 0.321f) << "nobody asked for that";
}

TEST_F(SavingTest, ClosingWhileAMapLoadsAsks)
{
    ASSERT_TRUE(window.document().save(file("a.relievo")));
    dropColor();
    window.close();
    ASSERT_NE(asked(window, "unsaved"), nullptr);
    answer(*asked(window, "unsaved"), QMessageBox::RejectRole);
    settle();
    EXPECT_TRUE(window.isVisible());
    EXPECT_TRUE(window.document().isModified()) << "it was taken";
    window.action("undo")->trigger();
    settle();
    QTest::qWait(10);
    dropColor();
    window.close();
    ASSERT_NE(asked(window, "unsaved"), nullptr);
    answer(*asked(window, "unsaved"), QMessageBox::AcceptRole);
    ASSERT_TRUE(waitFor([&] { return !window.isVisible(); }));
    EXPECT_EQ(savedColor(), file("wall_color.png").toStdString());
}

TEST_F(SavingTest, WhatIsStillLoadingCanBeDiscarded)
{
    ASSERT_TRUE(window.document().save(file("a.relievo")));
    dropColor();
    window.files().startNew();
    ASSERT_NE(asked(window, "unsaved"), nullptr);
    answer(*asked(window, "unsaved"), QMessageBox::DestructiveRole);
    settle();
    EXPECT_EQ(asked(window, "unsaved"), nullptr) << "asked once";
    EXPECT_TRUE(window.document().file().isEmpty());
    EXPECT_FALSE(window.document().isModified());
    EXPECT_EQ(savedColor(), "sample:bricks@64");
}

TEST_F(SavingTest, AClosingThatCouldNotSaveEverythingStays)
{
    ASSERT_TRUE(window.document().save(file("a.relievo")));
    dropColor();
    window.close();
    ASSERT_NE(asked(window, "unsaved"), nullptr);
    answer(*asked(window, "unsaved"), QMessageBox::AcceptRole);
    window.assets().background().cancel();
    QTest::qWait(50);
    EXPECT_TRUE(window.isVisible());
    window.close();
    EXPECT_FALSE(window.isVisible());
}

TEST_F(SavingTest, ANameWithADotGetsItsSuffix)
{
    saveAs("bricks v1.2");
    EXPECT_EQ(window.document().file(), file("bricks v1.2.relievo"));
    EXPECT_TRUE(QFile::exists(file("bricks v1.2.relievo")));
    EXPECT_FALSE(QFile::exists(file("bricks v1.2")));
    write("wall v2.0.relievo");
    saveAs("wall v2.0");
    QMessageBox* box = asked(window, "replace");
    ASSERT_NE(box, nullptr);
    answer(*box, QMessageBox::RejectRole);
    EXPECT_EQ(contents("wall v2.0.relievo"), "mine");
    QTest::qWait(10);
    saveAs("wall v2.0");
    box = asked(window, "replace");
    ASSERT_NE(box, nullptr);
    answer(*box, QMessageBox::AcceptRole);
    EXPECT_EQ(window.document().file(), file("wall v2.0.relievo"));
}

TEST_F(SavingTest, TheFolderOfAFailedSaveIsNotRemembered)
{
    QSettings().setValue("folders/save-relievo", "/elsewhere");
    saveAs((std::string(248, 'x') + ".y").c_str()); // with its suffix longer than a name may be
    EXPECT_FALSE(window.messages().all().isEmpty());
    EXPECT_EQ(QSettings().value("folders/save-relievo").toString(), "/elsewhere");
    QTest::qWait(10);
    saveAs("short");
    EXPECT_EQ(QSettings().value("folders/save-relievo").toString(), folder.path());
}

TEST_F(SavingTest, AnExportAsksBeforeItReplaces)
{
    write("look.json");
    ExportDialog& dialog = exportTo("preset");
    dialog.setOut(file("look.json"));
    dialog.run();
    QMessageBox* box = asked(dialog, "replace");
    ASSERT_NE(box, nullptr);
    answer(*box, QMessageBox::RejectRole);
    finish(dialog);
    EXPECT_EQ(contents("look.json"), "mine");
    QTest::qWait(10);
    dialog.run();
    answer(*asked(dialog, "replace"), QMessageBox::AcceptRole);
    finish(dialog);
    EXPECT_NE(contents("look.json"), "mine");
    QTest::qWait(10);
    dialog.run();
    EXPECT_EQ(asked(dialog, "replace"), nullptr) << "written by this dialog for this document";
    finish(dialog);
    window.document().start(state(), {});
    dialog.run();
    EXPECT_NE(asked(dialog, "replace"), nullptr) << "another document";
}

TEST_F(SavingTest, AFullFolderIsAskedAboutToo)
{
    write("mine.txt");
    ExportDialog& dialog = exportTo("textures");
    dialog.setOut(folder.path());
    dialog.run();
    ASSERT_NE(asked(dialog, "replace"), nullptr);
    answer(*asked(dialog, "replace"), QMessageBox::RejectRole);
    dialog.setOut(file("new"));
    dialog.run();
    finish(dialog);
    EXPECT_TRUE(QFileInfo(file("new")).isDir());
}

TEST_F(SavingTest, TheExportFollowsTheDocument)
{
    ExportDialog& dialog = exportTo("preset");
    EXPECT_TRUE(out(dialog).text().contains("bricks"));
    dialog.setOut("/proc/none/look.json");
    dialog.run();
    finish(dialog);
    EXPECT_FALSE(result(dialog).isHidden());
    dialog.setTarget("gltf");
    dialog.close();
    window.assets().openDocument("sample:terrain@64", State{});
    settle();
    window.action("export")->trigger();
    EXPECT_TRUE(out(dialog).text().contains("terrain")) << out(dialog).text().toStdString();
    EXPECT_TRUE(result(dialog).isHidden());
    dialog.setOut(file("typed.glb"));
    dialog.close();
    window.action("export")->trigger();
    EXPECT_EQ(out(dialog).text(), file("typed.glb")) << "what was named stays";
}

TEST_F(SavingTest, ExportFaultsAreTold)
{
    ExportDialog& dialog = exportTo("preset");
    dialog.setOut(file("look.json"));
    window.maps().setMesh("teapot");
    window.document().edit("Mesh", [](State& s) { s.mesh = "/no/such/mesh.obj"; });
    dialog.run();
    EXPECT_TRUE(result(dialog).text().contains("not loaded")) << result(dialog).text().toStdString();
    EXPECT_FALSE(QFile::exists(file("look.json")));
    Q_EMIT dialog.findChild<ExportRun*>()->findChild<Background*>()->failed("no memory");
    EXPECT_TRUE(result(dialog).text().contains("no memory"));

    MainWindow other;
    ExportDialog empty(other.document(), other.assets());
    empty.run();
    EXPECT_FALSE(result(empty).text().isEmpty()) << "nothing is loaded at all";
}

TEST_F(SavingTest, ClosingAsksAboutARunningExport)
{
    window.assets().openDocument("sample:cobblestones@512", State{});
    settle();
    ExportDialog& dialog = exportTo("textures");
    dialog.setOut(file("textures"));
    dialog.run();
    ASSERT_TRUE(dialog.busy());
    window.close();
    EXPECT_TRUE(window.isVisible());
    QMessageBox* box = asked(window, "unsaved");
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->text().contains("export")) << box->text().toStdString();
    answer(*box, QMessageBox::RejectRole);
    finish(dialog);
    EXPECT_TRUE(window.isVisible());
    EXPECT_TRUE(QFileInfo(file("textures")).isDir());
    window.close();
    EXPECT_FALSE(window.isVisible()) << "nothing runs and nothing is unsaved";
}
