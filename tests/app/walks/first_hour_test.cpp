// The walk of a first hour with a real set: open, tune, compare, a mesh with prisms, export, open that again, a change outside.
// RELIEVO_WALK=FOLDER keeps a picture of each step, to be looked at.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/files/image_file.h"
#include "tests/app/export_support.h"
#include <QDir>
#include <QLabel>

using namespace relievo;

namespace {
class FirstHourTest : public ExportingTest {
protected:
    // When everything that a step began has ended.
    void see(const char* step)
    {
        settle();
        ASSERT_TRUE(waitFor([&] { return window.assets().ready() && window.viewport().isFull(); })) << step;
        QTest::qWait(50);
        if (const QString pictures = qEnvironmentVariable("RELIEVO_WALK"); !pictures.isEmpty()) {
            EXPECT_TRUE(window.grab().save(pictures + '/' + step + ".png"));
        }
    }
    QStringList told()
    {
        QStringList texts;
        for (const Message& one : window.messages().all())
            texts << one.text;
        return texts;
    }
};
} // namespace

TEST_F(FirstHourTest, EachStepFollowsFromTheOneBefore)
{
    const QDir real(QDir(RELIEVO_TEST_DATA).filePath("materials/ambientcg_ground037_packed"));
    if (!real.exists())
        GTEST_SKIP() << "there is no " << real.path().toStdString();
    window.resize(1280, 800);
    ASSERT_TRUE(QDir().mkdir(file("ground")));
    for (const QString& name : real.entryList(QDir::Files))
        ASSERT_TRUE(QFile::copy(real.filePath(name), file("ground") + '/' + name));
    for (const QString& name : QDir(file("ground")).entryList(QDir::Files))
        QFile::setPermissions(file("ground") + '/' + name, QFile::ReadOwner | QFile::WriteOwner);

    drop(window, file("ground"));
    see("1-opened");
    ASSERT_TRUE(window.assets().resources().material->height);
    EXPECT_NE(window.assets().resources().material->map(MapKind::Color), nullptr);
    EXPECT_EQ(steps(), 0) << "what was opened is where undo ends";

    Slider& depth = slider("depth");
    drag(depth, {QPoint(depth.width() / 3, depth.height() / 2), QPoint(depth.width() / 2, depth.height() / 2)});
    see("2-tuned");
    EXPECT_EQ(steps(), 1);

    window.action("two-panes")->trigger();
    chooseInCaption("technique", "cell-cone", 1);
    see("3-compared");
    ASSERT_EQ(state().panes.size(), 2u);
    EXPECT_EQ(state().panes[1].technique, "cell-cone");

    window.maps().setMesh("torus");
    window.document().edit("Silhouettes", [](State& s) { s.parameters.silhouettes = Silhouettes::Prisms; });
    see("4-prisms");
    EXPECT_EQ(window.assets().resources().meshName, "torus");

    ExportDialog& dialog = exportTo("gltf");
    dialog.setOut(file("out/ground.glb"));
    dialog.run();
    finish(dialog);
    EXPECT_TRUE(QFile::exists(file("out/ground.glb"))) << result(dialog).text().toStdString();
    see("5-exported");
    dialog.close();

    const Parameters before = effectiveParameters(state(), 0);
    const float unit = window.assets().resources().mesh->metresPerUV;
    window.assets().openDocument(file("out/ground.glb"));
    see("6-opened-again");
    const Parameters again = effectiveParameters(state(), 0);
    EXPECT_NEAR(physicalDepth(again, window.assets().resources().mesh->metresPerUV), physicalDepth(before, unit), 1e-5f);
    EXPECT_FLOAT_EQ(again.midlevel, before.midlevel);

    window.assets().openDocument(file("ground"));
    see("7-the-set-again");
    const auto old = window.assets().resources().material;
    const std::string color = state().slots[std::size_t(MapKind::Color)].file;
    Image image = readImage(color)->image;
    for (std::byte& value : image.data)
        value = ~value;
    ASSERT_TRUE(relievo::writeImage(color, image, true));
    ASSERT_TRUE(waitFor([&] { return window.assets().resources().material != old; }));
    see("8-changed-outside");
    EXPECT_TRUE(told().join('\n').contains("changed outside")) << told().join('\n').toStdString();
}
