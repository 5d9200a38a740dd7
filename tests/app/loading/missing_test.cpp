// Projects whose files have moved: they open, say what is missing, keep its name, and show it again when it is back.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/export_dialog.h"
#include "core/mesh/mesh.h"
#include "core/state/state_json.h"
#include "tests/app/window_support.h"
#include <QImage>
#include <QLabel>
#include <algorithm>

using namespace relievo;

namespace {
class MissingTest : public WindowTest {
protected:
    void write(const char* name, const QByteArray& text)
    {
        QFile out(file(name));
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(text);
    }
    // A project of one triangle under a grey sky, closed again.
    void saveProject()
    {
        write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nusemtl wood\nf 1/1/1 2/2/1 3/3/1\n");
        write("sky.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 128\n" + QByteArray(64 * 128 * 4, char(128)));
        window.maps().setMesh(file("one.obj"));
        window.maps().setEnvironment(file("sky.hdr"));
        settle();
        window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.123f, s.part = "wood"; });
        window.setTechnique("bump");
        ASSERT_EQ(state().environment, file("sky.hdr").toStdString()) << window.messageLine().text().toStdString();
        ASSERT_TRUE(window.document().save(file("p.relievo")));
        window.assets().openDocument("sample:bricks@64", State{});
        settle();
    }
    void move(const char* from, const char* to) { ASSERT_TRUE(QFile::rename(file(from), file(to))); }
    void openProject()
    {
        window.files().open(file("p.relievo"));
        settle();
    }
    bool says(const QString& text, const QString& too = {})
    {
        const auto all = window.messages().all();
        return std::ranges::any_of(all, [&](const Message& one) { return one.text.contains(text) && one.text.contains(too); });
    }
    void comeBackToTheWindow()
    {
        QEvent event(QEvent::ActivationChange);
        QApplication::sendEvent(&window, &event);
        settle();
    }
    std::size_t triangles() { return window.assets().resources().mesh->indices.size() / 3; }
};
} // namespace

TEST_F(MissingTest, AProjectWithoutItsMeshAndPanoramaOpens)
{
    saveProject();
    const std::size_t planes = triangles();
    move("one.obj", "away.obj");
    move("sky.hdr", "away.hdr");
    openProject();
    EXPECT_EQ(window.document().file(), file("p.relievo"));
    EXPECT_FLOAT_EQ(state().parameters.depth, 0.123f);
    EXPECT_EQ(state().panes[0].technique, "bump");
    EXPECT_FALSE(window.document().isModified());
    EXPECT_EQ(triangles(), planes) << "the plane stands in";
    EXPECT_TRUE(says("one.obj", "put it back")) << window.messageLine().text().toStdString();
    EXPECT_TRUE(says("sky.hdr", "put it back"));
    EXPECT_EQ(window.messages().all().size(), 2);
    EXPECT_EQ(window.maps().findChild<QLabel*>("mesh-name")->text(), "missing: one.obj");
    EXPECT_EQ(window.maps().findChild<QLabel*>("environment-name")->text(), "missing: sky.hdr");
    EXPECT_FALSE(window.viewport().picture().isNull());
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.2f; });
    ASSERT_TRUE(window.document().save(file("p.relievo")));
    const auto saved = readState(State{}, file("p.relievo").toStdString());
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->state.mesh, file("one.obj").toStdString());
    EXPECT_EQ(saved->state.part, "wood");
    EXPECT_EQ(saved->state.environment, file("sky.hdr").toStdString());
}

TEST_F(MissingTest, WhatIsPutBackIsShown)
{
    saveProject();
    move("one.obj", "away.obj");
    move("sky.hdr", "away.hdr");
    openProject();
    comeBackToTheWindow();
    EXPECT_EQ(window.messages().all().size(), 2);
    move("away.obj", "one.obj");
    move("away.hdr", "sky.hdr");
    comeBackToTheWindow();
    EXPECT_TRUE(waitFor([&] { return triangles() == 1u; }));
    EXPECT_TRUE(waitFor([&] { return window.messages().all().isEmpty(); })) << window.messageLine().text().toStdString();
    EXPECT_FALSE(window.document().isModified());
}

TEST_F(MissingTest, AnotherMeshIsAStepAndCures)
{
    saveProject();
    move("one.obj", "away.obj");
    openProject();
    window.maps().setMesh("torus");
    settle();
    EXPECT_TRUE(window.messages().all().isEmpty()) << window.messageLine().text().toStdString();
    EXPECT_EQ(steps(), 1);
    window.action("undo")->trigger();
    settle();
    EXPECT_TRUE(says("one.obj"));
    EXPECT_EQ(state().mesh, file("one.obj").toStdString());
    window.maps().setMesh(file("not-there.obj"));
    settle();
    EXPECT_TRUE(says("not-there.obj"));
    EXPECT_EQ(state().mesh, file("one.obj").toStdString()) << "the choice was refused";
}

TEST_F(MissingTest, AMeshThatIsLocatedKeepsItsPart)
{
    saveProject();
    QDir(folder.path()).mkdir("new");
    move("one.obj", "new/one.obj");
    openProject();
    window.maps().setMesh(file("new/one.obj"));
    settle();
    EXPECT_EQ(state().mesh, file("new/one.obj").toStdString());
    EXPECT_EQ(state().part, "wood");
    EXPECT_EQ(triangles(), 1u);
    window.action("undo")->trigger();
    settle();
    EXPECT_TRUE(says("one.obj"));
    drop(window, file("new/one.obj"));
    settle();
    EXPECT_EQ(state().mesh, file("new/one.obj").toStdString());
    EXPECT_EQ(state().part, "wood");
}

TEST_F(MissingTest, AMapThatIsPutBackIsShown)
{
    drop(window, writeImage("a_height.png"));
    settle();
    ASSERT_TRUE(window.document().save(file("a.relievo")));
    window.assets().openDocument("sample:bricks@64", State{});
    settle();
    move("a_height.png", "away.png");
    window.files().open(file("a.relievo"));
    settle();
    EXPECT_TRUE(mapRow("height").isMissing());
    move("away.png", "a_height.png");
    comeBackToTheWindow();
    EXPECT_TRUE(waitFor([&] { return !mapRow("height").isMissing(); }));
    EXPECT_TRUE(waitFor([&] { return window.messages().all().isEmpty(); })) << window.messageLine().text().toStdString();
}

TEST_F(MissingTest, AMeshThatIsBrokenIsStoodInForToo)
{
    saveProject();
    write("one.obj", "no mesh at all");
    openProject();
    EXPECT_EQ(window.document().file(), file("p.relievo"));
    EXPECT_TRUE(says("one.obj", "cannot be read")) << window.messageLine().text().toStdString();
    EXPECT_FALSE(window.assets().background().busy());
}

TEST_F(MissingTest, NothingIsExportedInTheScaleOfAnotherMesh)
{
    saveProject();
    move("one.obj", "away.obj");
    openProject();
    window.action("export")->trigger();
    auto& dialog = *window.findChild<ExportDialog*>();
    dialog.setOut(file("out.glb"));
    dialog.run();
    EXPECT_FALSE(dialog.busy());
    EXPECT_FALSE(QFile::exists(file("out.glb")));
    EXPECT_TRUE(dialog.findChild<QLabel*>("result")->text().contains("one.obj"));
}

// Names that contain each other are told apart: the one that is there is not the one that is missing.
TEST_F(MissingTest, ANameWithinAnotherIsNotIt)
{
    for (const char* name : {"a.png", "a.png.old"})
        ASSERT_TRUE(QImage(2, 2, QImage::Format_Grayscale8).save(file(name), "PNG"));
    State base;
    base.slots[std::size_t(MapKind::Roughness)].file = file("a.png").toStdString();
    base.slots[std::size_t(MapKind::Color)].file = file("a.png.old").toStdString();
    window.assets().openState(base, {});
    settle();
    ASSERT_TRUE(QFile::remove(file("a.png.old")));
    window.assets().openState(base, {});
    settle();
    window.assets().openDocument("sample:bricks@32", State{});
    settle();
    window.assets().openState(base, {});
    settle();
    EXPECT_TRUE(says("a.png.old"));
    EXPECT_TRUE(window.assets().upToDate());
}
