// Meshes in the window: the animation bar and the choice of a part, driven by real events.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels/animation_bar.h"
#include "app/window/viewport/mesh_reference.h"
#include "app/window/viewport/overlays.h"
#include "tests/app/window_support.h"
#include <QBuffer>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <algorithm>

using namespace relievo;

TEST_F(WindowTest, AnimationPlaysPausesAndScrubsWithoutUndoSteps)
{
    AnimationBar& bar = window.animation();
    EXPECT_TRUE(bar.isHidden());
    window.maps().setMesh("character");
    ASSERT_TRUE(waitFor([&] { return !bar.isHidden(); }));
    const int before = steps();
    auto* play = bar.findChild<QToolButton*>("play");
    play->click();
    ASSERT_TRUE(waitFor([&] { return state().parameters.time > 0.05f; }));
    play->click();
    EXPECT_FALSE(bar.isPlaying());
    auto* slider = bar.findChild<Slider*>("time");
    const float paused = state().parameters.time;
    const QPoint from = slider->handle();
    drag(*slider, {from, from + QPoint(60, 0)});
    EXPECT_NE(state().parameters.time, paused);
    EXPECT_EQ(steps(), before);
    EXPECT_NE(bar.findChild<QLabel*>()->text().indexOf("1.20 s"), -1);
    window.maps().setMesh("plane");
    ASSERT_TRUE(waitFor([&] { return bar.isHidden(); }));
}

// In one undo step with it; deeper is the artist's to choose, and is told.
TEST_F(WindowTest, ANewMeshStartsWithADepthThatFitsIt)
{
    const float before = 0.4f;
    window.document().edit("deep", [](State& s) { s.parameters.depth = 0.4f; });
    const int stepsBefore = steps();
    window.maps().setMesh("character");
    ASSERT_TRUE(waitFor([&] { return state().mesh == "character" && window.assets().upToDate(); }));
    EXPECT_EQ(steps(), stepsBefore + 1);
    EXPECT_LT(state().parameters.depth, before);
    const Resources& resources = window.assets().resources();
    const float fits = fittingDepth(state().parameters, resources.mesh->metresPerUV, resources.fit);
    EXPECT_LE(state().parameters.depth, fits);
    EXPECT_GT(state().parameters.depth, 0.85f * fits);
    const auto isTold = [&] {
        return std::ranges::any_of(window.messages().all(), [](const Message& m) { return m.text.contains("deeper than the mesh"); });
    };
    EXPECT_FALSE(isTold());
    window.document().edit("deeper", [](State& s) { s.parameters.depth = 0.5f; });
    EXPECT_TRUE(isTold());
    window.document().undoStack().undo();
    EXPECT_FALSE(isTold());
    window.document().undoStack().undo();
    EXPECT_EQ(state().parameters.depth, before);
}

TEST_F(WindowTest, ALoadThatIsNoLongerWantedIsDropped)
{
    window.maps().setMesh("torus");
    ASSERT_TRUE(waitFor([&] { return state().mesh == "torus" && !window.assets().background().busy(); }));
    window.document().undoStack().undo(); // the plane begins to load
    EXPECT_TRUE(window.assets().background().busy());
    window.document().undoStack().redo();
    settle();
    EXPECT_EQ(window.assets().resources().meshName, "torus");
}

TEST_F(WindowTest, TheErrorViewAtRestIsThatOfTheDisplacedMesh)
{
    window.maps().setMesh("sphere");
    ASSERT_TRUE(waitFor([&] { return state().mesh == "sphere"; }));
    const MeshReference* reference = &window.viewport().reference();
    settle();
    EXPECT_FALSE(reference->exactOf(0)); // nothing is made for other views
    window.document().edit("view", [](State& s) { setView(s, "error-mesh"); });
    ASSERT_TRUE(waitFor([&] { return window.viewport().isSettled() && reference->exactOf(0); }));
    const QImage seen = window.viewport().picture();
    EXPECT_EQ(reference->exactOf(0)->pixels.width, seen.width());
    EXPECT_EQ(reference->exactOf(0)->pixels.height, seen.height());
    const auto caption = [&] { return window.viewport().findChild<PaneCaption*>()->accessibleName(); };
    ASSERT_TRUE(waitFor([&] { return caption().contains("wrong"); }));
    EXPECT_TRUE(caption().contains("fetches/px") && caption().contains("RMSE 0.")) << caption().toStdString();
    window.document().edit("view", [](State& s) { s.camera.yaw += 10.f; });
    EXPECT_FALSE(reference->exactOf(0)); // what is seen changed
    ASSERT_TRUE(waitFor([&] { return caption().contains("tracing"); })) << caption().toStdString();
    ASSERT_TRUE(waitFor([&] { return window.viewport().isSettled() && reference->exactOf(0); }));
    window.document().edit("view", [](State& s) { setView(s, "shaded"); });
    EXPECT_FALSE(reference->busy());
    EXPECT_FALSE(reference->exactOf(0));
    window.document().edit("view", [](State& s) { setView(s, "error"); }); // of the search: nothing has to be traced
    ASSERT_TRUE(waitFor([&] { return caption().contains("wrong"); }));
    EXPECT_FALSE(reference->exactOf(0));
}

TEST_F(WindowTest, APartOfAMeshTakesItsOwnMaps)
{
    const auto write = [&](const char* name, const QByteArray& text) {
        QFile file(folder.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    };
    ASSERT_TRUE(window.viewport().picture().scaled(8, 8).save(folder.filePath("wood.png")));
    write("m.mtl", "newmtl wood\nmap_Kd wood.png\nnewmtl iron\nKd 1 1 1\n");
    write("m.obj",
        "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nusemtl wood\nf 1/1 2/2 3/3\nusemtl iron\nf 2/2 "
        "4/4 3/3\n");
    window.maps().setMesh(folder.filePath("m.obj"));
    auto* parts = window.maps().findChild<QComboBox*>("parts");
    ASSERT_TRUE(waitFor([&] { return parts->count() == 3; }));
    EXPECT_FALSE(parts->isHidden());
    window.maps().choosePart("wood");
    ASSERT_TRUE(waitFor([&] { return state().part == "wood"; }));
    EXPECT_NE(state().slots[std::size_t(MapKind::Color)].file.find("wood.png"), std::string::npos);
    EXPECT_NE(state().slots[std::size_t(MapKind::Height)].file, ""); // the file has none
    window.action("undo")->trigger();
    EXPECT_EQ(state().part, "");
}

TEST_F(WindowTest, PicturesInsideAMeshFileAreItsMaps)
{
    QByteArray png;
    QBuffer buffer(&png);
    ASSERT_TRUE(window.viewport().picture().scaled(8, 8).save(&buffer, "PNG"));
    const float corners[] = {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f}; // positions, then UVs
    const QByteArray bytes(reinterpret_cast<const char*>(corners), sizeof corners);
    QFile gltf(folder.filePath("a mesh of a name that is far too long for the panel at its side, by any measure.gltf"));
    ASSERT_TRUE(gltf.open(QIODevice::WriteOnly));
    gltf.write(
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":)"
        R"({"POSITION":0,"TEXCOORD_0":1},"material":0}]}],"materials":[{"name":"m","pbrMetallicRoughness":{"baseColorTexture":{)"
        R"("index":0}}}],"textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)"
        + png.toBase64() + R"("}],"buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,)" + bytes.toBase64()
        + R"("}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24}],"accessors":[{"bufferView":0,)"
          R"("componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},{"bufferView":1,"componentType":5126,"count":3,)"
          R"("type":"VEC2"}]})");
    gltf.close();
    window.assets().openDocument(gltf.fileName());
    ASSERT_TRUE(waitFor([&] { return state().mesh == gltf.fileName().toStdString() && !window.assets().background().busy(); }));
    EXPECT_TRUE(window.assets().resources().material->map(MapKind::Color));
    EXPECT_FALSE(mapRow("color").isMissing());
    const auto* scroll = window.maps().findChild<QScrollArea*>();
    EXPECT_LE(scroll->widget()->width(), scroll->viewport()->width()); // nothing is cut off at the side
}
