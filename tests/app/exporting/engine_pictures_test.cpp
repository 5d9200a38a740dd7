// The two small pictures of the export dialog: the material here and as an engine draws it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/engine_pictures.h"
#include "app/window/widgets/switch.h"
#include "tests/app/export_support.h"
#include <cmath>

using namespace relievo;

namespace {
class EnginePicturesTest : public ExportingTest {
protected:
    void SetUp() override
    {
        ExportingTest::SetUp();
        window.document().edit("Camera", [](State& s) { s.camera.pitch = 25.f, s.parameters.depth = 0.15f; });
    }
    EnginePictures& pictures() { return *window.findChild<EnginePictures*>(); }
    QImage picture(const char* name) { return pictures().findChild<QLabel*>(name)->pixmap().toImage(); }
    QImage ours() { return picture("our-picture"); }
    QImage engines() { return picture("engine-picture"); }
    void drawn()
    {
        ASSERT_TRUE(waitFor([&] { return !pictures().busy(); }));
    }
    QStringList captions()
    {
        QStringList texts;
        for (const QLabel* label : pictures().findChildren<QLabel*>())
            if (!label->text().isEmpty())
                texts << label->text();
        return texts;
    }
    // Mean absolute difference of the green of two pictures, 0 to 255.
    static double difference(const QImage& a, const QImage& b)
    {
        EXPECT_EQ(a.size(), b.size());
        double sum = 0.;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                sum += std::abs(qGreen(a.pixel(x, y)) - qGreen(b.pixel(x, y)));
        return sum / (double(a.width()) * a.height());
    }
};
} // namespace

TEST_F(EnginePicturesTest, TheEnginesStandsBesideOurs)
{
    exportTo("unity-urp");
    drawn();
    ASSERT_FALSE(ours().isNull() || engines().isNull()) << captions().join('\n').toStdString();
    EXPECT_TRUE(captions().contains("Relievo"));
    EXPECT_TRUE(captions().contains("Unity URP (as drawn)")) << captions().join('\n').toStdString();
    EXPECT_GT(difference(ours(), engines()), 1.) << "one step of parallax is not the relief";
    const QImage unity = engines();
    window.findChild<ExportDialog*>()->setTarget("godot4");
    drawn();
    EXPECT_GT(difference(unity, engines()), 0.5) << "another engine";
    EXPECT_TRUE(captions().contains("Godot 4 (as drawn)"));
}

TEST_F(EnginePicturesTest, TheyFollowTheCameraAndTheDocument)
{
    exportTo("godot4");
    drawn();
    const QImage before = ours(), engineBefore = engines();
    window.document().edit({}, [](State& s) { s.camera.yaw += 60.f; });
    drawn();
    const QImage turned = ours();
    EXPECT_GT(difference(before, turned), 1.);
    EXPECT_GT(difference(engineBefore, engines()), 1.);
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.02f; });
    drawn();
    EXPECT_GT(difference(turned, ours()), 1.);
}

TEST_F(EnginePicturesTest, WhereNoEngineIsBehindATargetThereAreNoneAndTheirRoomStays)
{
    ExportDialog& dialog = exportTo("godot4");
    drawn();
    const QRect room = pictures().geometry();
    dialog.setTarget("usd");
    drawn();
    EXPECT_TRUE(ours().isNull() && engines().isNull());
    EXPECT_EQ(pictures().geometry(), room);
    dialog.setTarget("godot4");
    drawn();
    EXPECT_FALSE(engines().isNull());
}

TEST_F(EnginePicturesTest, NothingIsDrawnWhileNobodySeesThem)
{
    exportTo("godot4").close();
    EXPECT_FALSE(pictures().busy());
    window.document().edit("Depth", [](State& s) { s.parameters.depth = 0.02f; });
    EXPECT_FALSE(pictures().busy());
    window.action("export")->trigger();
    EXPECT_TRUE(pictures().busy());
    drawn();
    EXPECT_FALSE(engines().isNull());
}

// White lies on the mesh in Godot: heights that never are white sink in unless they are stretched on their way out.
TEST_F(EnginePicturesTest, TheEngineGetsTheHeightsThatAreWritten)
{
    QImage low(32, 32, QImage::Format_Grayscale8);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            low.setPixel(x, y, qRgb(40 + 2 * x, 40 + 2 * x, 40 + 2 * x));
    low.save(file("low_height.png"));
    window.assets().assign("Height", MapKind::Height, file("low_height.png").toStdString());
    settle();
    exportTo("godot4");
    drawn();
    const QImage stretched = engines(), before = ours();
    window.findChild<Switch*>("cure-full-range")->click();
    drawn();
    EXPECT_GT(difference(stretched, engines()), 0.5);
    EXPECT_LT(difference(before, ours()), 0.01) << "ours has nothing to do with it";
}
