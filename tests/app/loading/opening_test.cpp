// What opening and dropping a SOURCE takes of it, what stays of the document before, and what is asked.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/exporters.h"
#include "core/scene/source.h"
#include "tests/app/window_support.h"
#include <QDialog>
#include <QListWidget>
#include <QPushButton>
#include <algorithm>

using namespace relievo;

namespace {
class OpeningTest : public WindowTest {
protected:
    // An exported glTF binary of a sphere with three tiles along its UVs.
    QString exported()
    {
        State given = openSource("sample:hammered@32", State())->state;
        given.mesh = "sphere";
        given.parameters.depth = 0.05f, given.parameters.tiling = 3.f;
        const Resources resources = *loadResources(given, {}, {});
        EXPECT_TRUE(findExport("gltf")->run({given, resources, file("own.glb").toStdString(), 0, {}}));
        return file("own.glb");
    }
    void edit(const StateChange& change) { window.document().edit("Edit", change); }
    QStringList choices()
    {
        QStringList labels;
        for (const QPushButton* button : buttons())
            labels << button->text();
        return labels;
    }
    void choose(const char* label)
    {
        for (QPushButton* button : buttons())
            if (button->text() == label)
                return QTest::mouseClick(button, Qt::LeftButton), settle();
        FAIL() << "no choice " << label;
    }
    const std::string& heights() { return state().slots[std::size_t(MapKind::Height)].file; }

private:
    QList<QPushButton*> buttons() { return window.messageLine().findChild<QWidget*>("choices")->findChildren<QPushButton*>(); }
};
} // namespace

// The exported mesh has the tiling in its UVs: were the window's taken too, the tiles would be nine.
TEST_F(OpeningTest, AnOwnExportOpenedAgainIsTheSamePicture)
{
    const QString own = exported();
    edit([](State& s) { s.mesh = "sphere", s.parameters.depth = 0.2f, s.parameters.tiling = 3.f; });
    settle();
    window.assets().openDocument(own);
    settle();
    EXPECT_EQ(state().mesh, own.toStdString());
    EXPECT_FLOAT_EQ(state().parameters.tiling, 1.f);
    EXPECT_NEAR(state().parameters.depth, 0.05f, 1e-6f);
    EXPECT_EQ(steps(), 0);
}

TEST_F(OpeningTest, CameraLightAndTechniqueStayAndNothingElse)
{
    edit([](State& s) {
        s.mesh = "torus";
        s.camera.yaw = 77.f;
        s.parameters.lightYaw = 12.f, s.parameters.lightSize = 3.f;
        s.parameters.depth = 0.3f, s.parameters.tiling = 4.f, s.parameters.rotation = 30.f, s.parameters.maxSteps = 99;
        s.panes = {Pane{"steep", {{"depth", 0.5f}, {"lightPitch", 20.f}}}};
    });
    settle();
    const State before = state();
    ASSERT_EQ(findTechnique(before.panes[0].technique)->key, "steep");
    window.assets().openDocument(writeImage("wall_height.png"));
    settle();
    State expected;
    expected.name = state().name, expected.slots = state().slots, expected.camera = before.camera;
    expected.parameters.lightYaw = 12.f, expected.parameters.lightSize = 3.f;
    expected.panes = {Pane{"steep", {{"lightPitch", 20.f}}}};
    EXPECT_EQ(heights(), file("wall_height.png").toStdString());
    EXPECT_EQ(state(), expected);
}

TEST_F(OpeningTest, DepthAndTilingCanBeKept)
{
    edit([](State& s) { s.parameters.depth = 0.3f, s.parameters.tiling = 4.f; });
    drop(window, writeImage("wall_height.png"));
    settle();
    EXPECT_FLOAT_EQ(state().parameters.tiling, 1.f);
    EXPECT_EQ(choices(), QStringList{"Keep depth and tiling"});
    choose("Keep depth and tiling");
    EXPECT_FLOAT_EQ(state().parameters.depth, 0.3f);
    EXPECT_FLOAT_EQ(state().parameters.tiling, 4.f);
    EXPECT_EQ(heights(), file("wall_height.png").toStdString());
    EXPECT_EQ(steps(), 3);
    EXPECT_TRUE(choices().isEmpty());
    window.assets().openDocument("sample:bricks@32");
    settle();
    window.assets().openDocument(file("wall_height.png"));
    settle();
    EXPECT_TRUE(choices().isEmpty()) << "nothing had been changed";
}

TEST_F(OpeningTest, ADropOnWorkKeepsItsMesh)
{
    edit([](State& s) { s.mesh = "torus"; });
    settle();
    drop(window, writeImage("wall_height.png"));
    settle();
    EXPECT_EQ(state().mesh, "torus");
    EXPECT_EQ(steps(), 2);
}

TEST_F(OpeningTest, ADroppedGltfFileIsAskedAbout)
{
    const QString own = exported();
    edit([](State& s) { s.mesh = "torus", s.parameters.tiling = 4.f; });
    settle();
    const State before = state();
    drop(window, own);
    EXPECT_EQ(choices(), (QStringList{"Both", "Material", "Mesh"}));
    EXPECT_TRUE(window.messageLine().text().contains("own.glb"));
    settle();
    EXPECT_EQ(state(), before) << "nothing before the answer";
    choose("Both");
    EXPECT_EQ(state().mesh, own.toStdString());
    EXPECT_TRUE(QString::fromStdString(heights()).startsWith(folder.path()));
    EXPECT_FLOAT_EQ(state().parameters.tiling, 1.f);
    EXPECT_EQ(steps(), 2);
    EXPECT_FALSE(choices().contains("Both"));
    window.action("undo")->trigger();
    settle();
    EXPECT_EQ(state(), before);
    drop(window, own);
    choose("Material");
    EXPECT_EQ(state().mesh, "torus");
    EXPECT_NE(state().slots, before.slots);
    window.action("undo")->trigger();
    settle();
    drop(window, own);
    choose("Mesh");
    EXPECT_EQ(state().mesh, own.toStdString());
    EXPECT_EQ(state().slots, before.slots);
    EXPECT_FLOAT_EQ(state().parameters.tiling, 4.f);
}

TEST_F(OpeningTest, AFolderOfManySetsOffersAList)
{
    QDir(folder.path()).mkpath("sets/deep");
    for (const char* name : {"wall_height.png", "wall_color.png", "roof_height.png", "roof_color.png", "roof_roughness.png"})
        writeImage((QByteArray("sets/deep/") + name).constData());
    window.files().open(file("sets/deep"));
    auto* dialog = window.findChild<QDialog*>("choose-one");
    ASSERT_NE(dialog, nullptr);
    auto* list = dialog->findChild<QListWidget*>();
    ASSERT_EQ(list->count(), 2);
    EXPECT_EQ(list->item(0)->text(), "roof") << "the most complete one";
    const std::string before = heights();
    dialog->reject();
    settle();
    EXPECT_EQ(heights(), before);
    drop(window, file("sets/deep"));
    dialog = window.findChildren<QDialog*>("choose-one").back();
    dialog->findChild<QListWidget*>()->setCurrentRow(1);
    dialog->accept();
    settle();
    EXPECT_EQ(heights(), file("sets/deep/wall_height.png").toStdString());
    EXPECT_TRUE(QDir(folder.path()).mkpath("sets/other"));
    writeImage("sets/other/door_height.png");
    window.files().open(file("sets")); // folders below, of which one holds several again
    ASSERT_TRUE(waitFor([&] { return window.findChildren<QDialog*>("choose-one").size() == 1; }));
    dialog = window.findChild<QDialog*>("choose-one");
    dialog->findChild<QListWidget*>()->setCurrentRow(1);
    dialog->accept();
    settle();
    EXPECT_EQ(heights(), file("sets/other/door_height.png").toStdString());
}
