// Files that other programs change while they are shown: read again in place, kept when they cannot be read, marked when they are gone.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/file_watch.h"
#include "core/exporters/exporters.h"
#include "core/image/files/image_file.h"
#include "core/mesh/mesh.h"
#include "tests/app/window_support.h"
#include <QImage>
#include <QLabel>
#include <algorithm>

using namespace relievo;

namespace {
class OutsideTest : public WindowTest {
protected:
    void write(const char* name, const QByteArray& bytes)
    {
        QFile out(file(name));
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(bytes);
    }
    QByteArray bytesOf(const char* name)
    {
        QFile in(file(name));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    // A document of a height map, 16 texels wide, with one edit.
    void openWall()
    {
        drop(window, writeImage("wall.png"));
        settle();
        ASSERT_EQ(width(), 16);
        window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.123f; });
    }
    int width()
    {
        const auto& height = window.assets().resources().material->height;
        return height ? height->width() : 0;
    }
    bool says(const QString& text)
    {
        const auto all = window.messages().all();
        return std::ranges::any_of(all, [&](const Message& one) { return one.text.contains(text); });
    }
    std::size_t triangles() { return window.assets().resources().mesh->indices.size() / 3; }
};
const char* const kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl wood\nf 1/1 2/2 3/3\n";
} // namespace

TEST_F(OutsideTest, AMapThatIsOverwrittenIsReadAgain)
{
    openWall();
    const State before = state();
    writeImage("wall.png", 32);
    ASSERT_TRUE(waitFor([&] { return width() == 32; }));
    EXPECT_EQ(state(), before);
    EXPECT_EQ(steps(), 1) << "no change of the document";
    ASSERT_TRUE(waitFor([&] { return window.viewport().isFull(); }));
    ASSERT_EQ(window.messages().all().size(), 1);
    EXPECT_EQ(window.messages().all()[0].text, "wall.png was changed outside and has been read again.");
    EXPECT_TRUE(window.messages().all()[0].isNote);
    window.action("undo")->trigger();
    settle();
    EXPECT_NE(state().parameters.depth, 0.123f);
    EXPECT_EQ(width(), 32);
    EXPECT_TRUE(window.messages().all().isEmpty()) << "the work went on";
}

// As many programs save: a new file takes the name of the old one. Its size and time may be the old ones.
TEST_F(OutsideTest, AMapThatIsReplacedIsReadAgain)
{
    openWall();
    for (const int size : {32, 8, 24}) { // the system's watch of the old file ends each time
        writeImage("new.png", size);
        ASSERT_EQ(std::rename(qPrintable(file("new.png")), qPrintable(file("wall.png"))), 0);
        EXPECT_TRUE(waitFor([&] { return width() == size; })) << size;
    }
    writeImage("wall.png", 64);
    EXPECT_TRUE(waitFor([&] { return width() == 64; })) << "overwritten after all that";
}

TEST_F(OutsideTest, AMapThatIsGoneIsMarkedStaysAndComesBack)
{
    openWall();
    window.maps().assign(MapKind::Roughness, writeImage("shine.png"));
    settle();
    ASSERT_TRUE(QFile::rename(file("wall.png"), file("away.png")));
    ASSERT_TRUE(waitFor([&] { return mapRow("height").isMissing(); }));
    EXPECT_FALSE(mapRow("roughness").isMissing());
    EXPECT_EQ(width(), 16) << "shown as it was";
    EXPECT_TRUE(says("wall.png")) << window.messageLine().text().toStdString();
    window.maps().assign(MapKind::Roughness, {}); // loads the maps anew
    settle();
    EXPECT_TRUE(mapRow("height").isMissing());
    ASSERT_TRUE(QFile::rename(file("away.png"), file("wall.png")));
    EXPECT_TRUE(waitFor([&] { return !mapRow("height").isMissing(); }));
    EXPECT_EQ(width(), 16);
    EXPECT_TRUE(waitFor([&] { return window.messages().all().isEmpty(); })) << window.messageLine().text().toStdString();
}

TEST_F(OutsideTest, AFolderThatIsGoneComesBack)
{
    QDir(folder.path()).mkdir("set");
    drop(window, writeImage("set/wall.png"));
    settle();
    ASSERT_TRUE(QDir(folder.path()).rename("set", "away"));
    ASSERT_TRUE(waitFor([&] { return mapRow("height").isMissing(); }));
    ASSERT_TRUE(QDir(folder.path()).rename("away", "set"));
    EXPECT_TRUE(waitFor([&] { return !mapRow("height").isMissing(); }));
}

TEST_F(OutsideTest, AMapThatIsHalfWrittenKeepsTheLastPicture)
{
    openWall();
    writeImage("other.png", 32);
    const QByteArray whole = bytesOf("other.png");
    write("wall.png", whole.left(whole.size() / 2));
    ASSERT_TRUE(waitFor([&] { return says("cannot be read any more"); }));
    EXPECT_EQ(width(), 16);
    EXPECT_FALSE(window.viewport().picture().isNull());
    write("wall.png", whole);
    EXPECT_TRUE(waitFor([&] { return width() == 32; }));
    EXPECT_TRUE(waitFor([&] { return !says("cannot be read"); }));
    EXPECT_FALSE(mapRow("height").isMissing());
}

TEST_F(OutsideTest, MeshAndPanoramaAreReadAgain)
{
    write("one.obj", kTriangle);
    write("sky.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n" + QByteArray(4 * 8 * 4, char(128)));
    window.maps().setMesh(file("one.obj"));
    window.maps().setEnvironment(file("sky.hdr"));
    settle();
    ASSERT_EQ(triangles(), 1u);
    const auto sky = window.assets().resources().environment;
    write("one.obj", QByteArray(kTriangle) + "f 1/1 3/3 2/2\n");
    write("sky.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n" + QByteArray(4 * 8 * 4, char(120)));
    EXPECT_TRUE(waitFor([&] { return triangles() == 2 && window.assets().resources().environment != sky; }));
    write("one.obj", "nothing of use");
    EXPECT_TRUE(waitFor([&] { return says("one.obj: the mesh cannot be read any more"); }));
    EXPECT_EQ(triangles(), 2u) << "shown as it was";
    ASSERT_TRUE(QFile::remove(file("one.obj")));
    EXPECT_TRUE(waitFor([&] { return says("one.obj: the mesh is not there any more"); }));
    EXPECT_EQ(triangles(), 2u);
    EXPECT_EQ(window.maps().findChild<QLabel*>("mesh-name")->text(), "missing: one.obj");
    write("one.obj", kTriangle);
    EXPECT_TRUE(waitFor([&] { return triangles() == 1; }));
    EXPECT_FALSE(says("not there"));
}

TEST_F(OutsideTest, WhatAGltfKeepsBesideItIsReadAgain)
{
    const ExportJob job{state(), window.assets().resources(), file("box.gltf").toStdString(), 16, {}};
    ASSERT_TRUE(findExport("gltf")->run(job));
    window.maps().setMesh(file("box.gltf"));
    settle();
    const auto before = window.assets().resources().mesh;
    ASSERT_EQ(window.assets().resources().meshName, file("box.gltf").toStdString());
    QByteArray numbers = bytesOf("box.bin");
    numbers[3] = char(numbers[3] ^ 0x80); // the sign of the first
    write("box.bin", numbers);
    EXPECT_TRUE(waitFor([&] { return window.assets().resources().mesh != before; }));
    EXPECT_TRUE(waitFor([&] { return says("box.bin was changed outside"); }));
}

TEST_F(OutsideTest, ALayerIsReadAgainWithItsFile)
{
    const auto writeHeights = [this](int size) {
        Image image{.width = size, .height = size, .channels = 1, .type = PixelType::F32, .data = {}};
        image.data.resize(image.texelCount() * 4);
        const ImageLayer layers[] = {{"colour", image}, {"height", image}};
        ASSERT_TRUE(writeLayers(file("wall.exr").toStdString(), layers));
    };
    writeHeights(16);
    window.maps().assign(MapKind::Height, file("wall.exr"));
    settle();
    window.document().edit("Layer", [&](State& s) { s.slots[0].file = file("wall.exr#height").toStdString(); });
    settle();
    ASSERT_EQ(width(), 16) << window.messageLine().text().toStdString();
    writeHeights(32);
    EXPECT_TRUE(waitFor([&] { return width() == 32; }));
}

TEST_F(OutsideTest, ReloadReadsAllFilesAgain)
{
    openWall();
    const auto before = window.assets().resources().material;
    window.action("reload")->trigger();
    EXPECT_TRUE(waitFor([&] { return window.assets().resources().material != before; }));
    EXPECT_TRUE(says("wall.png has been read again"));
    EXPECT_EQ(steps(), 1);
    EXPECT_EQ(window.action("reload")->shortcut(), QKeySequence(Qt::Key_F5));
}

// Where the system does not tell, files are looked at from time to time; and each change is told once.
TEST(FileWatch, LooksWhereTheSystemDoesNotTell)
{
    QTemporaryDir folder;
    const QString name = folder.filePath("a.png");
    const auto write = [&](const char* text) {
        QFile out(name);
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(text);
    };
    write("one");
    FileWatch watch([](const QString&) { return false; });
    int told = 0;
    QObject::connect(&watch, &FileWatch::changed, [&](const FileNames& files) { told += int(files.count(name.toStdString())); });
    watch.watch({{name.toStdString(), stampOf(name.toStdString())}});
    QTest::qWait(500);
    EXPECT_EQ(told, 0);
    write("and more");
    EXPECT_TRUE(waitFor([&] { return told == 1; }));
    QTest::qWait(2500);
    EXPECT_EQ(told, 1);
}
