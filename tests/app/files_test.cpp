// Files in the window: opening, dropping, assigning, saving, exporting, and what happens when they are broken.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/export_dialog.h"
#include "app/window/document/background.h"
#include "app/window/document/files.h"
#include "core/image/samples/samples.h"
#include "tests/app/window_support.h"
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QToolButton>

using namespace relievo;

namespace {
const MapSlot& slotOf(const State& state, MapKind kind)
{
    return state.slots[std::size_t(kind)];
}
QMessageBox* question(MainWindow& window)
{
    return window.findChild<QMessageBox*>("unsaved");
}
} // namespace

TEST_F(WindowTest, ADroppedImageIsOpened)
{
    drop(window, writeImage("wall_height.png"));
    settle();
    EXPECT_EQ(slotOf(state(), MapKind::Height).file, file("wall_height.png").toStdString());
    ASSERT_TRUE(window.assets().resources().material->height);
    EXPECT_EQ(window.assets().resources().material->height->width(), 16);
    EXPECT_EQ(recentFiles().value(0), file("wall_height.png"));
}

TEST_F(WindowTest, ADropIsOneStepWhereWorkWouldBeLost)
{
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.3f; });
    const MapSlots before = state().slots;
    drop(window, writeImage("wall_height.png"));
    settle();
    EXPECT_EQ(steps(), 2);
    window.action("undo")->trigger();
    settle();
    EXPECT_EQ(state().slots, before);
    EXPECT_FLOAT_EQ(state().parameters.depth, 0.3f);
    EXPECT_EQ(window.assets().resources().material->slots, before) << "the data follows undo";
}

TEST_F(WindowTest, ADroppedMeshReplacesTheMesh)
{
    QFile mesh(file("one.obj"));
    ASSERT_TRUE(mesh.open(QIODevice::WriteOnly));
    mesh.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    mesh.close();
    drop(window, file("one.obj"));
    settle();
    EXPECT_EQ(state().mesh, file("one.obj").toStdString());
    EXPECT_EQ(window.assets().resources().mesh->indices.size(), 3u);
    EXPECT_EQ(steps(), 1);
}

TEST_F(WindowTest, ABrokenFileKeepsTheDocumentAndSaysSo)
{
    QFile broken(file("broken.png"));
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("\x89PNG\r\n\x1a\n and then nothing of use");
    broken.close();
    const State before = state();
    drop(window, file("broken.png"));
    settle();
    EXPECT_EQ(state(), before);
    ASSERT_FALSE(window.messages().all().isEmpty());
    EXPECT_TRUE(window.messageLine().text().contains("broken.png")) << window.messageLine().text().toStdString();
    window.maps().assign(MapKind::Color, file("broken.png"));
    settle();
    EXPECT_EQ(state(), before);
    window.maps().setMesh(file("not-there.glb"));
    settle();
    EXPECT_EQ(state(), before);
    EXPECT_TRUE(window.messageLine().text().contains("not-there.glb"));
    drop(window, writeImage("good_height.png"));
    settle();
    EXPECT_FALSE(window.messageLine().text().contains("not-there")) << "cured: withdrawn";
}

TEST_F(WindowTest, MapsAreAssignedInvertedAndCleared)
{
    drop(mapRow("roughness"), writeImage("shine.png", 8));
    settle();
    EXPECT_EQ(slotOf(state(), MapKind::Roughness).file, file("shine.png").toStdString());
    ASSERT_NE(window.assets().resources().material->map(MapKind::Roughness), nullptr);
    const float before = window.assets().resources().material->map(MapKind::Roughness)->value(0, 0, 0);
    QTest::mouseClick(mapRow("roughness").findChild<QToolButton*>("invert"), Qt::LeftButton);
    settle();
    EXPECT_NEAR(window.assets().resources().material->map(MapKind::Roughness)->value(0, 0, 0), 1.f - before, 1e-3f);
    QTest::mouseClick(mapRow("roughness").findChild<QToolButton*>("clear"), Qt::LeftButton);
    settle();
    EXPECT_TRUE(slotOf(state(), MapKind::Roughness).empty());
    EXPECT_EQ(window.assets().resources().material->map(MapKind::Roughness), nullptr);
    EXPECT_EQ(steps(), 3);
}

TEST_F(WindowTest, WithoutAHeightMapReliefSaysWhatIsMissing)
{
    window.maps().assign(MapKind::Height, {});
    settle();
    EXPECT_TRUE(waitFor([&] { return window.messageLine().text().contains("height map"); }));
    window.setTechnique("flat");
    EXPECT_TRUE(waitFor([&] { return window.messages().all().isEmpty(); }));
}

TEST_F(WindowTest, MovedTexturesAreToldAndLocated)
{
    drop(window, writeImage("a_height.png"));
    settle();
    window.maps().assign(MapKind::Color, writeImage("a_color.png"));
    settle();
    ASSERT_TRUE(window.document().save(file("a.relievo")));
    QDir(folder.path()).mkdir("new");
    for (const char* name : {"a_height.png", "a_color.png"})
        ASSERT_TRUE(QFile::rename(file(name), folder.filePath(QString("new/") + name)));
    window.assets().openDocument("sample:bricks@64", State{});
    settle();
    window.files().open(file("a.relievo"));
    settle();
    EXPECT_TRUE(mapRow("height").isMissing());
    EXPECT_TRUE(mapRow("color").isMissing());
    EXPECT_FALSE(mapRow("normal").isMissing());
    EXPECT_TRUE(window.messageLine().text().contains("a_height.png") || window.messageLine().text().contains("a_color.png"));
    window.maps().locate(MapKind::Height, folder.filePath("new/a_height.png"));
    settle();
    EXPECT_FALSE(mapRow("height").isMissing());
    EXPECT_FALSE(mapRow("color").isMissing()) << "found beside the other";
    EXPECT_TRUE(waitFor([&] { return window.messages().all().isEmpty(); }));
}

TEST_F(WindowTest, SavedAndOpenedAgainIsEqual)
{
    window.document().edit("Panes", [](State& s) {
        setPaneCount(s, 2);
        s.parameters.depth = 0.123f;
        s.mesh = "torus";
    });
    settle();
    const State before = state();
    ASSERT_TRUE(window.document().save(file("b.relievo")));
    EXPECT_FALSE(window.isWindowModified());
    window.files().startNew();
    settle();
    EXPECT_NE(state(), before);
    window.files().open(file("b.relievo"));
    settle();
    EXPECT_EQ(state(), before);
    EXPECT_EQ(window.document().file(), file("b.relievo"));
    EXPECT_TRUE(window.windowTitle().startsWith("b[*]"));
    EXPECT_EQ(recentFiles().value(0), file("b.relievo"));
}

TEST_F(WindowTest, LoadingDoesNotHoldTheWindowUp)
{
    int ticks = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &timer, [&] { ++ticks; });
    timer.start(0);
    bool loaded = false;
    QObject::connect(&window.assets(), &Assets::resourcesChanged, &timer, [&] { loaded = true; });
    int whileLoading = 0;
    window.assets().openDocument("sample:cobblestones@512");
    EXPECT_TRUE(window.assets().background().busy()) << "returned before it was done";
    ASSERT_TRUE(waitFor([&] {
        whileLoading = loaded ? whileLoading : ticks;
        return loaded;
    }));
    EXPECT_GT(whileLoading, 1);
}

TEST_F(WindowTest, LoadingCanBeCancelled)
{
    const State before = state();
    window.assets().openDocument("sample:terrain@4096");
    window.assets().background().cancel();
    EXPECT_FALSE(window.assets().background().busy());
    QTest::qWait(50);
    EXPECT_EQ(state(), before);
    EXPECT_TRUE(window.messages().all().isEmpty());
}

TEST_F(WindowTest, TheExportDialogWritesAFile)
{
    window.action("export")->trigger();
    auto* dialog = window.findChild<ExportDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_FALSE(dialog->isModal());
    dialog->setTarget("preset");
    dialog->findChild<QLineEdit*>("out")->setText(file("look.json"));
    QTest::mouseClick(dialog->findChild<QPushButton*>("run"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return !dialog->busy(); }));
    EXPECT_TRUE(QFile::exists(file("look.json")));
    EXPECT_TRUE(dialog->findChild<QLabel*>("result")->text().contains("look.json"));
    dialog->setOut("/proc/none/look.json");
    dialog->run();
    ASSERT_TRUE(waitFor([&] { return !dialog->busy(); }));
    EXPECT_TRUE(dialog->findChild<QLabel*>("result")->text().contains("/proc/none"));
}

TEST_F(WindowTest, ClosingWithUnsavedWorkAsks)
{
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.3f; });
    EXPECT_TRUE(window.isWindowModified());
    window.close();
    ASSERT_NE(question(window), nullptr);
    EXPECT_TRUE(window.isVisible());
    question(window)->button(QMessageBox::Cancel)->click();
    QTest::qWait(10);
    EXPECT_TRUE(window.isVisible());
    window.close();
    ASSERT_TRUE(waitFor([&] { return question(window) != nullptr; }));
    window.findChildren<QMessageBox*>("unsaved").back()->button(QMessageBox::Discard)->click();
    EXPECT_TRUE(waitFor([&] { return !window.isVisible(); }));
}

TEST_F(WindowTest, OpeningOverUnsavedWorkAsks)
{
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.3f; });
    window.files().startNew();
    ASSERT_NE(question(window), nullptr);
    question(window)->button(QMessageBox::Discard)->click();
    settle();
    EXPECT_EQ(steps(), 0);
}

TEST_F(WindowTest, AFolderOfRealTexturesOpens)
{
    const QString set = QString(RELIEVO_TEST_DATA) + "/materials/3dtextures_rock_024_dx";
    if (!QFileInfo::exists(set))
        GTEST_SKIP() << "no " << set.toStdString();
    window.files().open(set);
    settle();
    EXPECT_FALSE(slotOf(state(), MapKind::Height).empty());
    EXPECT_TRUE(slotOf(state(), MapKind::Normal).invert) << "DirectX style";
    EXPECT_TRUE(waitFor([&] { return window.viewport().isFull(); }));
}

TEST_F(WindowTest, APresetChangesNumbersAndKeepsMaps)
{
    const MapSlots before = state().slots;
    auto* files = window.findChild<Files*>();
    ASSERT_TRUE(files);
    files->applyPreset("fine");
    EXPECT_EQ(state().parameters.maxSteps, 256);
    EXPECT_EQ(state().slots, before);
    EXPECT_EQ(steps(), 1);
    files->applyPreset("no such preset");
    EXPECT_EQ(steps(), 1);
}

TEST_F(WindowTest, WorkThatThrowsIsToldNotFatal)
{
    Background background;
    QString told;
    QObject::connect(&background, &Background::failed, [&](const QString& what) { told = what; });
    background.start([](const Progress&) -> Background::Then { throw std::bad_alloc(); });
    for (int i = 0; i < 200 && told.isEmpty(); ++i)
        QTest::qWait(10);
    EXPECT_TRUE(told.contains("memory"));
    EXPECT_FALSE(background.busy());
}
