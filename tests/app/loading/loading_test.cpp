// Work that waits for files: nothing is dropped, reverted or started for nothing, and what could not be done is told until it is cured.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/mesh_reference.h"
#include "core/exporters/exporters.h"
#include "core/mesh/mesh.h"
#include "core/state/presets.h"
#include "tests/app/window_support.h"
#include <QClipboard>
#include <QMenu>
#include <QMessageBox>
#include <QProcess>
#include <QToolButton>
#include <algorithm>
#include <cmath>

using namespace relievo;

namespace {
const std::string& fileOf(const State& state, MapKind kind)
{
    return state.slots[std::size_t(kind)].file;
}

class LoadingTest : public WindowTest {
protected:
    Background& background() { return window.assets().background(); }
    QMessageBox* question() { return window.findChild<QMessageBox*>("unsaved"); }
    void edit(int maxSteps)
    {
        window.document().edit("Steps", [maxSteps](State& s) { s.parameters.maxSteps = maxSteps; });
    }
    bool says(const char* text) { return window.messageLine().text().contains(text); }
};
} // namespace

TEST_F(LoadingTest, ASceneAsksBeforeWorkIsLost)
{
    edit(77);
    const State before = state();
    QMenu menu;
    window.files().fillPresets(menu);
    const auto scene = std::ranges::find_if(kPresets, [](const PresetRow& row) { return !row.sample.empty(); });
    menu.actions()[int(scene - kPresets.begin())]->trigger();
    ASSERT_NE(question(), nullptr);
    question()->button(QMessageBox::Cancel)->click();
    settle();
    EXPECT_EQ(state(), before);
}

TEST_F(LoadingTest, WhatIsEditedWhileMapsLoadStays)
{
    const MapSlots before = state().slots;
    window.assets().openDocument("sample:terrain@512");
    edit(77);
    settle();
    EXPECT_NE(state().slots, before);
    EXPECT_EQ(state().parameters.maxSteps, 77);
    EXPECT_EQ(steps(), 2) << "the opening is a step of its own";
    window.action("undo")->trigger();
    settle();
    EXPECT_EQ(state().slots, before);
    EXPECT_EQ(state().parameters.maxSteps, 77);
}

// Depth, technique and steps come along with what this program exported; what is edited meanwhile stays.
TEST_F(LoadingTest, WhatWasExportedBringsItsRelief)
{
    State exported = openSource("sample:hammered@32", State())->state;
    exported.parameters.depth = 0.05f, exported.parameters.tiling = 3.f, exported.parameters.safeBalls = true;
    exported.panes[0].technique = "sphere";
    const Resources resources = *loadResources(exported, {}, {});
    for (const char* target : {"gltf", "textures"}) {
        const QString out = file(std::string_view(target) == "gltf" ? "a.glb" : "maps");
        ASSERT_TRUE(findExport(target)->run({exported, resources, out.toStdString(), 0, {}}));
        window.assets().openDocument("sample:bricks@32", State{});
        settle();
        window.files().open(out);
        edit(77);
        settle();
        EXPECT_NEAR(state().parameters.depth, 0.05f, 1e-6f) << target;
        EXPECT_EQ(state().panes[0].technique, "sphere") << target;
        EXPECT_EQ(state().parameters.maxSteps, 77) << target;
    }
    EXPECT_FLOAT_EQ(state().parameters.tiling, 3.f); // of the folder; the mesh of the glTF file has it in its UVs
}

TEST_F(LoadingTest, AProjectAsksAboutWhatWasEditedWhileItLoaded)
{
    ASSERT_TRUE(window.document().save(file("a.relievo")));
    window.files().open(file("a.relievo"));
    edit(77);
    settle();
    ASSERT_NE(question(), nullptr);
    question()->button(QMessageBox::Cancel)->click();
    settle();
    EXPECT_EQ(state().parameters.maxSteps, 77);
    EXPECT_TRUE(window.document().isModified());
}

TEST_F(LoadingTest, TwoDropsAtOnceAreBothTaken)
{
    drop(mapRow("height"), writeImage("a_height.png", 256));
    drop(mapRow("color"), writeImage("a_color.png"));
    settle();
    EXPECT_EQ(fileOf(state(), MapKind::Height), file("a_height.png").toStdString());
    EXPECT_EQ(fileOf(state(), MapKind::Color), file("a_color.png").toStdString());
    EXPECT_EQ(steps(), 2);
    EXPECT_TRUE(window.assets().upToDate());
}

TEST_F(LoadingTest, ABrokenFileDoesNotTakeTheNextOneWithIt)
{
    drop(mapRow("height"), folder.filePath("not-there.png"));
    drop(mapRow("color"), writeImage("a_color.png"));
    settle();
    EXPECT_NE(fileOf(state(), MapKind::Height), file("not-there.png").toStdString());
    EXPECT_EQ(fileOf(state(), MapKind::Color), file("a_color.png").toStdString());
}

TEST_F(LoadingTest, ATechniqueClickLeavesTheLoadAlone)
{
    drop(mapRow("height"), writeImage("a_height.png", 256));
    window.setTechnique("cell-cone");
    settle();
    EXPECT_EQ(fileOf(state(), MapKind::Height), file("a_height.png").toStdString());
    EXPECT_EQ(state().panes[0].technique, "cell-cone");
    EXPECT_TRUE(missingMaps().empty());
}

TEST_F(LoadingTest, TheShapeChosenLastIsShown)
{
    window.maps().setMesh("teapot");
    window.maps().setMesh("plane");
    settle();
    EXPECT_EQ(state().mesh, "plane");
    EXPECT_EQ(steps(), 0);
    window.maps().setMesh("teapot");
    window.maps().setMesh("torus");
    settle();
    EXPECT_EQ(state().mesh, "torus");
    EXPECT_EQ(steps(), 1) << "the teapot was overtaken";
}

TEST_F(LoadingTest, ACameraMoveStartsNothingAgain)
{
    window.assets().openDocument("sample:bricks@256");
    settle();
    window.setTechnique("cone");
    EXPECT_TRUE(background().busy());
    background().cancel();
    window.document().edit({}, [](State& s) { s.camera.yaw = 12.f; });
    EXPECT_FALSE(background().busy());
    edit(77);
    EXPECT_FALSE(background().busy()) << "the same map was cancelled";
    window.setTechnique("cell-cone");
    settle();
    EXPECT_TRUE(missingMaps().empty()) << "another one is made";
}

TEST_F(LoadingTest, TheWindowNeverBakesWhileItDraws)
{
    window.setTechnique("cone-relaxed");
    background().cancel();
    EXPECT_TRUE(says("was stopped"));
    QTest::qWait(300); // in which it would measure
    EXPECT_TRUE(window.viewport().picture().isNull());
    QApplication::clipboard()->setText("before");
    window.action("copy-picture")->trigger();
    EXPECT_EQ(QApplication::clipboard()->text(), "before");
    const auto all = window.messages().all();
    EXPECT_TRUE(std::ranges::any_of(all, [](const Message& one) { return one.text.contains("Nothing was copied"); }));
}

TEST_F(LoadingTest, TwoPanesMayWrapDifferently)
{
    window.document().edit("Panes", [](State& s) { s.panes = {Pane{"cell-cone", {}}, Pane{"cell-cone", {{"wrap", 1}}}}; });
    settle();
    EXPECT_EQ(window.assets().resources().accelerationMaps.count(), 2u);
    EXPECT_TRUE(waitFor([&] { return window.viewport().isSettled(); }));
    EXPECT_TRUE(window.messages().all().isEmpty()) << window.messageLine().text().toStdString();
    EXPECT_FALSE(window.viewport().picture().isNull());
}

TEST_F(LoadingTest, ControlsGoBackToWhatIs)
{
    drop(mapRow("roughness"), writeImage("shine.png", 8));
    settle();
    auto* invert = mapRow("roughness").findChild<QToolButton*>("invert");
    QTest::mouseClick(invert, Qt::LeftButton);
    EXPECT_TRUE(invert->isChecked());
    background().cancel();
    EXPECT_FALSE(invert->isChecked());
    auto* shapes = window.maps().findChild<Segmented*>("shapes");
    const int plane = shapes->current();
    QTest::mouseClick(shapes, Qt::LeftButton, Qt::NoModifier, shapes->segment(3).center());
    background().cancel();
    EXPECT_EQ(shapes->current(), plane);
    QFile::remove(file("shine.png"));
    QTest::mouseClick(invert, Qt::LeftButton);
    settle();
    EXPECT_EQ(invert->isChecked(), state().slots[std::size_t(MapKind::Roughness)].invert);
}

TEST_F(LoadingTest, ErrorsVanishWhenTheyAreCured)
{
    window.document().edit("Mesh", [](State& s) { s.mesh = "/no/such/mesh.obj"; });
    settle();
    EXPECT_TRUE(says("mesh.obj")) << window.messageLine().text().toStdString();
    window.action("undo")->trigger();
    settle();
    EXPECT_TRUE(window.messages().all().isEmpty()) << window.messageLine().text().toStdString();
    window.maps().setMesh("/no/such/mesh.obj");
    settle();
    EXPECT_TRUE(says("mesh.obj"));
    window.maps().setMesh("plane");
    settle();
    EXPECT_TRUE(window.messages().all().isEmpty()) << "another one was chosen, which is there already";
}

TEST_F(LoadingTest, AFirstSourceThatFailsLeavesABuiltInMaterial)
{
    MainWindow other;
    other.show();
    other.assets().openDocument("/no/such/wall.png", State{});
    ASSERT_TRUE(waitFor([&] { return other.assets().ready() && !other.assets().background().busy(); }));
    EXPECT_TRUE(other.messageLine().text().contains("/no/such/wall.png"));
    EXPECT_EQ(other.document().state().name, "Cobblestones");
    EXPECT_FALSE(other.document().isModified());
}

TEST_F(LoadingTest, AFirstStateThatFailsLeavesABuiltInMaterial)
{
    QFile broken(file("broken.png"));
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("nothing of use");
    broken.close();
    State given;
    given.slots[std::size_t(MapKind::Height)].file = file("broken.png").toStdString();
    MainWindow other;
    other.show();
    other.assets().openState(given, {});
    ASSERT_TRUE(waitFor([&] { return other.assets().ready() && !other.assets().background().busy(); }));
    EXPECT_TRUE(other.messageLine().text().contains("broken.png")) << other.messageLine().text().toStdString();
    EXPECT_EQ(other.document().state().name, "Cobblestones");
    EXPECT_FALSE(other.document().isModified());
}

TEST_F(LoadingTest, CancellingTheFirstLoadLeavesABuiltInMaterial)
{
    MainWindow other;
    other.show();
    other.assets().openDocument("sample:terrain@4096", State{});
    other.assets().background().cancel();
    ASSERT_TRUE(waitFor([&] { return other.assets().ready() && !other.assets().background().busy(); }));
    EXPECT_EQ(other.document().state().name, "Cobblestones");
    EXPECT_FALSE(other.document().isModified());
    EXPECT_TRUE(other.messages().all().isEmpty());
    EXPECT_TRUE(waitFor([&] { return other.viewport().isFull(); }));
}

TEST_F(LoadingTest, ANormalMapGivenByHandIsRecognisedByItsPixels)
{
    QImage image(64, 64, QImage::Format_RGB888); // of sin(x) sin(y), DirectX style
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const double u = x * 0.2, v = y * 0.2;
            const auto byte = [](double n) { return int(std::lround(127.5 + 100. * n)); };
            image.setPixel(x, y, qRgb(byte(-0.6 * std::cos(u) * std::sin(v)), byte(-0.6 * std::sin(u) * std::cos(v)), 220));
        }
    ASSERT_TRUE(image.save(file("bumps.png")));
    drop(mapRow("normal"), file("bumps.png"));
    settle();
    EXPECT_TRUE(state().slots[std::size_t(MapKind::Normal)].invert);
    EXPECT_TRUE(says("DirectX")) << window.messageLine().text().toStdString();
    EXPECT_EQ(steps(), 1);
    window.maps().assign(MapKind::Normal, {});
    settle();
    EXPECT_FALSE(says("DirectX"));
}

TEST_F(LoadingTest, AWarningForOnePaneDoesNotKeepTheOtherFromBeingCompared)
{
    window.maps().setMesh("torus");
    settle();
    window.document().edit("Panes", [](State& s) {
        s.panes = {Pane{"relief", {{"tiling", 256.f}}}, Pane{"bump", {}}};
        s.camera.distance = 0.05f; // so near that half a pixel is finer than the mesh can be cut
        setView(s, "error-mesh");
    });
    const MeshReference* reference = &window.viewport().reference();
    ASSERT_TRUE(waitFor([&] { return reference->exactOf(0) != nullptr; }, 60000));
    EXPECT_TRUE(says("coarser")) << window.messageLine().text().toStdString();
    EXPECT_NE(reference->exactOf(1), nullptr);
}

TEST_F(LoadingTest, AMenuOfAPaneThatIsGoneDoesNothing)
{
    window.action("two-panes")->trigger();
    window.viewport().findChildren<QAbstractButton*>().back()->click();
    auto* menu = window.viewport().findChild<QMenu*>();
    ASSERT_NE(menu, nullptr);
    window.action("two-panes")->trigger();
    const State before = state();
    menu->actions().back()->trigger();
    menu->close();
    EXPECT_EQ(state(), before);
}

TEST_F(LoadingTest, ADroppedPresetIsApplied)
{
    QFile preset(file("look.json"));
    ASSERT_TRUE(preset.open(QIODevice::WriteOnly));
    preset.write(R"({"relievo":1,"parameters":{"maxSteps":99}})");
    preset.close();
    const MapSlots before = state().slots;
    drop(window, file("look.json"));
    settle();
    EXPECT_EQ(state().parameters.maxSteps, 99);
    EXPECT_EQ(state().slots, before);
    EXPECT_TRUE(window.messages().all().isEmpty());
}

TEST(Editor, WithoutOpenGLItSaysSo)
{
    QProcess editor;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("QT_XCB_GL_INTEGRATION", "none");
    editor.setProcessEnvironment(environment);
    editor.start(RELIEVO_BIN "/relievo-editor", QStringList());
    ASSERT_TRUE(editor.waitForFinished(20000));
    EXPECT_EQ(editor.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(editor.exitCode(), 1);
    EXPECT_TRUE(editor.readAllStandardError().contains("OpenGL"));
}

// The name of the file between the two programs is nobody's to know before, and nothing of it stays.
TEST(Editor, WhatIsHandedOverLeavesNothingBehind)
{
    QTemporaryDir folder;
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("QT_QPA_PLATFORM", "minimal"); // without OpenGL: it ends when it has read the state
    environment.insert("TMPDIR", folder.path());
    program.setProcessEnvironment(environment);
    program.start(RELIEVO_BIN "/relievo", {"sample:bricks@16", "--set", "depth=0.2"});
    ASSERT_TRUE(program.waitForFinished(20000));
    EXPECT_EQ(program.exitCode(), 1);
    EXPECT_TRUE(program.readAllStandardError().contains("OpenGL"));
    EXPECT_EQ(QDir(folder.path()).entryList({"relievo*"}).join(' ').toStdString(), "");
}

TEST(Editor, AStateThatCannotBeReadIsToldAndEndsIt)
{
    QTemporaryDir folder;
    QFile state(folder.filePath("state.json"));
    ASSERT_TRUE(state.open(QIODevice::WriteOnly));
    state.write("{\"relievo\":1,");
    state.close();
    QProcess editor;
    editor.start(RELIEVO_BIN "/relievo-editor", {"--state-json", state.fileName()});
    ASSERT_TRUE(editor.waitForFinished(20000));
    EXPECT_EQ(editor.exitCode(), 1);
    EXPECT_TRUE(editor.readAllStandardError().contains("state.json"));
}
