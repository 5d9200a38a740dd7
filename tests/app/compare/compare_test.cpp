// Two panes in one place, the loupe and the enlarged pixels.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/compare/compare_bar.h"
#include "app/window/compare/loupe.h"
#include "core/analysis/image_metrics.h"
#include "tests/app/window_support.h"
#include <QComboBox>
#include <QLabel>
#include <cmath>

using namespace relievo;

namespace {
Image asImage(const QImage& picture)
{
    const QImage rgba = picture.convertToFormat(QImage::Format_RGBA8888);
    Image image{.width = rgba.width(), .height = rgba.height(), .channels = 4, .data = {}};
    for (int y = 0; y < rgba.height(); ++y) {
        const auto* line = reinterpret_cast<const std::byte*>(rgba.constScanLine(y));
        image.data.insert(image.data.end(), line, line + rgba.width() * 4);
    }
    return image;
}

int furthestApart(QColor a, QColor b)
{
    return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
}
} // namespace

class CompareTest : public WindowTest {
protected:
    void SetUp() override
    {
        WindowTest::SetUp();
        window.document().edit("Two", [](State& state) {
            state.panes = {Pane{"flat", {}, "normal"}, Pane{"cell-cone", {}, "color"}};
            state.camera.pitch = 60.f;
        });
        rest();
    }
    void rest()
    {
        settle();
        ASSERT_TRUE(waitFor([&] { return missingMaps().empty() && picture.isSettled(); }));
    }
    QImage shown()
    {
        QTest::qWait(30);
        return picture.grabFramebuffer();
    }
    // The picture of one pane alone, in the whole viewport.
    QImage alone(std::size_t pane)
    {
        picture.places().inPlace().setPair(1 - pane, pane);
        QTest::keyPress(&picture, Qt::Key_V); // holds the second of them
        rest();
        const QImage taken = shown();
        QTest::keyRelease(&picture, Qt::Key_V);
        picture.places().inPlace().setPair(0, 1);
        return taken;
    }
    void pointAt(QPoint at)
    {
        QMouseEvent move(QEvent::MouseMove, at, picture.mapToGlobal(QPointF(at)), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(&picture, &move);
    }
    Viewport& picture = window.viewport();
};

TEST_F(CompareTest, AWipeShowsEachPictureOnItsSideOfTheLine)
{
    const QImage first = alone(0), second = alone(1);
    ASSERT_NE(first, second);
    window.action("wipe")->trigger();
    rest();
    const int y = picture.height() / 2, quarter = picture.width() / 4;
    QImage wipe = shown();
    EXPECT_LE(furthestApart(wipe.pixelColor(quarter, y), first.pixelColor(quarter, y)), 1);
    EXPECT_LE(furthestApart(wipe.pixelColor(3 * quarter, y), second.pixelColor(3 * quarter, y)), 1);

    const Camera camera = state().camera;
    const QPoint middle(picture.width() / 2, y);
    drag(picture, {middle, middle + QPoint(quarter + 20, 0)});
    wipe = shown();
    EXPECT_EQ(state().camera, camera) << "the line was dragged, not the mesh";
    EXPECT_LE(furthestApart(wipe.pixelColor(3 * quarter, y), first.pixelColor(3 * quarter, y)), 1);
    EXPECT_EQ(picture.places().under(QPointF(3 * quarter, y)), 0u);
    EXPECT_EQ(picture.places().under(QPointF(3 * quarter + 40, y)), 1u);

    // Turned by Shift until it lies: the first picture is above or below, the second on the other side.
    const QPoint line = middle + QPoint(quarter + 20, 0);
    drag(picture, {line, line + QPoint(-60, 0)}, Qt::LeftButton, Qt::ShiftModifier);
    const float angle = picture.places().inPlace().composition().angle;
    EXPECT_NEAR(std::abs(angle), 90.f, 1.f);
    EXPECT_NE(picture.places().under(QPointF(quarter, 20)), picture.places().under(QPointF(quarter, picture.height() - 20)));
    EXPECT_EQ(steps(), 1) << "ways of looking are no steps";
}

TEST_F(CompareTest, DifferencesAreThoseOfThePixels)
{
    const QImage first = alone(0), second = alone(1);
    window.action("difference")->trigger();
    EXPECT_TRUE(window.action("difference")->isChecked());
    EXPECT_FALSE(window.action("blink")->isChecked());
    rest();
    auto* gain = window.comparing().findChild<QComboBox*>("gain");
    Q_EMIT gain->activated(1);
    EXPECT_EQ(picture.places().inPlace().gain(), 2.f);
    const QImage difference = shown();
    InPlace& inPlace = picture.places().inPlace();
    inPlace.setSigned(true);
    const QImage signedly = shown();
    int compared = 0;
    for (int y = 5; y < picture.height(); y += 41)
        for (int x = 5; x < picture.width(); x += 37, ++compared) {
            const QColor a = first.pixelColor(x, y), b = second.pixelColor(x, y);
            const QColor apart(std::min(255, 2 * std::abs(a.red() - b.red())), std::min(255, 2 * std::abs(a.green() - b.green())),
                std::min(255, 2 * std::abs(a.blue() - b.blue())));
            const auto around = [](int one, int other) { return std::clamp(128 + other - one, 0, 255); };
            const QColor grey(around(a.red(), b.red()), around(a.green(), b.green()), around(a.blue(), b.blue()));
            EXPECT_LE(furthestApart(difference.pixelColor(x, y), apart), 2) << x << ' ' << y;
            EXPECT_LE(furthestApart(signedly.pixelColor(x, y), grey), 2) << x << ' ' << y;
        }
    EXPECT_GT(compared, 100);
}

TEST_F(CompareTest, FlipIsThatOfTheTwoPictures)
{
    const QImage first = alone(0), second = alone(1);
    window.action("flip")->trigger();
    const FlipMap& flip = picture.places().flip();
    ASSERT_TRUE(waitFor([&] { return picture.isSettled() && flip.picture() && !flip.busy(); }));
    EXPECT_NEAR(flip.picture()->mean, Flip(asImage(first)).mean(asImage(second)), 1e-3);
    EXPECT_GT(flip.picture()->mean, 0.01);
    EXPECT_EQ(flip.picture()->heat.width, picture.width());
    auto* number = window.comparing().findChild<QLabel*>("compare-number");
    EXPECT_TRUE(number->isVisible());
    ASSERT_TRUE(waitFor([&] { return number->text().contains(QString::number(flip.picture()->mean, 'f', 4)); }));
    // The corner is the background of both: nothing differs there, and the map says so in its first colour.
    EXPECT_LE(furthestApart(shown().pixelColor(2, picture.height() - 3), QColor(68, 1, 84)), 8);
}

TEST_F(CompareTest, BlinkingAlternatesAndVHoldsTheOther)
{
    InPlace& inPlace = picture.places().inPlace();
    window.action("blink")->trigger();
    const auto how = [&] { return inPlace.composition().how; };
    EXPECT_EQ(how(), Composition::How::First);
    ASSERT_TRUE(waitFor([&] { return how() == Composition::How::Second; }));
    ASSERT_TRUE(waitFor([&] { return how() == Composition::How::First; }));
    window.action("blink")->trigger();
    EXPECT_EQ(inPlace.mode(), InPlaceMode::SideBySide);
    EXPECT_FALSE(inPlace.isOn());
    QTest::keyPress(&picture, Qt::Key_V);
    EXPECT_TRUE(inPlace.isOn());
    EXPECT_EQ(how(), Composition::How::Second);
    QTest::keyRelease(&picture, Qt::Key_V);
    EXPECT_FALSE(inPlace.isOn());
}

TEST_F(CompareTest, AnyTwoOfSeveralAndWithOneAloneNothingIsCompared)
{
    window.document().edit("Four", [](State& state) { setPaneCount(state, 4); });
    window.action("wipe")->trigger();
    InPlace& inPlace = picture.places().inPlace();
    auto* second = window.comparing().findChild<QComboBox*>("second");
    EXPECT_TRUE(second->isVisible());
    Q_EMIT second->activated(3);
    EXPECT_EQ(inPlace.pair(), std::pair(std::size_t(0), std::size_t(3)));
    Q_EMIT second->activated(0);
    EXPECT_EQ(inPlace.pair(), std::pair(std::size_t(3), std::size_t(0))) << "they change places";
    const auto areas = picture.places().areas();
    EXPECT_TRUE(areas[1].isEmpty() && areas[2].isEmpty());
    EXPECT_EQ(areas[3].width, picture.width());
    const std::string technique = state().panes[3].technique;
    window.action("swap-panes")->trigger();
    EXPECT_EQ(state().panes[0].technique, technique);
    window.action("two-panes")->trigger();
    EXPECT_EQ(state().panes.size(), 1u);
    EXPECT_FALSE(inPlace.isOn());
    rest();
    EXPECT_FALSE(picture.places().areas()[0].isEmpty());
    window.action("wipe")->trigger(); // its tick went with the other panes
    EXPECT_GT(state().panes.size(), 1u) << "a wipe of one picture brings a second";
    EXPECT_TRUE(inPlace.isOn());
}

TEST_F(CompareTest, PixelsAreEnlargedTheSameInAllPictures)
{
    rest();
    const QImage before = shown();
    PixelZoom& zoom = picture.places().zoom();
    const PaneArea area = picture.places().areas()[0];
    const QPoint at(area.width / 2, area.height / 2);
    const auto wheel = [&](int delta) {
        QWheelEvent event(
            at, picture.mapToGlobal(QPointF(at)), {}, {0, delta}, Qt::NoButton, Qt::ControlModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&picture, &event);
    };
    const Camera camera = state().camera;
    for (int i = 0; i < 9; ++i)
        wheel(120);
    EXPECT_EQ(zoom.factor(), PixelZoom::kMost);
    EXPECT_EQ(state().camera, camera);
    const QImage large = shown();
    for (std::size_t pane = 0; pane < 2; ++pane) {
        const PaneArea own = picture.places().areas()[pane];
        for (int y = 40; y < own.height; y += 97)
            for (int x = 10; x < own.width; x += 61) {
                const glm::vec2 share = picture.places().toPicture(pane, QPointF(own.x + x + 0.5, own.y + y + 0.5));
                const int px = own.x + int(std::floor(share.x * float(own.width))),
                          py = own.y + int(std::floor(share.y * float(own.height)));
                EXPECT_EQ(large.pixelColor(own.x + x, own.y + y), before.pixelColor(px, py)) << pane << ": " << x << ' ' << y;
            }
    }
    const glm::vec2 corner = zoom.corner();
    drag(picture, {at, at + QPoint(-64, 0)}, Qt::MiddleButton);
    EXPECT_NEAR((zoom.corner().x - corner.x) * float(area.width), 2.f, 0.01f) << "two pixels of 32";
    EXPECT_EQ(state().camera, camera);
    QTest::keyClick(&picture, Qt::Key_Escape);
    EXPECT_EQ(zoom.factor(), 1);
    EXPECT_EQ(shown(), before);
}

TEST_F(CompareTest, ALegendTellsThePixelsAndFitsItsScaleToThem)
{
    window.document().edit("Fetches", [](State& state) { state.panes = {Pane{"relief", {}, "fetches"}, Pane{"flat"}}; });
    rest();
    auto* legend = picture.findChild<HeatLegend*>();
    ASSERT_TRUE(waitFor([&] { return !legend->summary().isEmpty(); }));
    const int low = legend->height();
    QEnterEvent enter({}, {}, {});
    QApplication::sendEvent(legend, &enter);
    EXPECT_GT(legend->height(), low) << "the histogram";
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(legend, &leave);
    EXPECT_EQ(legend->height(), low);
    const int steps = this->steps();
    QTest::mouseDClick(legend, Qt::LeftButton);
    EXPECT_EQ(this->steps(), steps + 1);
    EXPECT_GT(state().parameters.fetchRange, 5.f);
    EXPECT_LT(state().parameters.fetchRange, 40.f) << "relief of 32 steps seldom needs them all here";
    EXPECT_EQ(legend->max(), double(state().parameters.fetchRange));
    window.action("undo")->trigger();
    EXPECT_EQ(state().parameters.fetchRange, 40.f);
}

TEST_F(CompareTest, TheLoupeTellsThePixelsAndTheSearchOfEachPicture)
{
    window.setView("shaded");
    window.document().edit("Two", [](State& state) {
        state.panes = {Pane{"flat"}, Pane{"cell-cone"}};
        state.mesh = "plane";
        state.parameters.silhouettes = Silhouettes::Off;
    });
    rest();
    window.action("loupe")->trigger();
    const PaneArea area = picture.places().areas()[0];
    const QPoint at(area.width / 2, area.height / 2);
    pointAt(at);
    const auto glasses = picture.findChildren<LoupeGlass*>();
    ASSERT_EQ(glasses.size(), 2);
    ASSERT_TRUE(waitFor([&] { return glasses[1]->lines().size() == 5; }));
    const QImage pixels = shown();
    for (std::size_t pane = 0; pane < 2; ++pane) {
        const PaneArea own = picture.places().areas()[pane];
        EXPECT_TRUE(glasses[qsizetype(pane)]->isVisible());
        EXPECT_LE(furthestApart(glasses[qsizetype(pane)]->color(), pixels.pixelColor(own.x + at.x(), own.y + at.y())), 1);
    }
    const auto inspected = inspect(state(), window.assets().resources(), {0, picture.places().toPicture(0, at), area.aspect()}, {});
    ASSERT_EQ(inspected.panes.size(), 2u);
    EXPECT_TRUE(glasses[1]->lines()[1].endsWith(QString::number(inspected.panes[1].view->hit.t, 'f', 4)))
        << qPrintable(glasses[1]->lines()[1]);
    EXPECT_TRUE(glasses[1]->lines()[3].endsWith(QString::number(inspected.panes[1].view->hit.fetches)));
    EXPECT_TRUE(glasses[1]->lines()[4].endsWith("0.0000")) << "cell cones are exact";
    EXPECT_FALSE(glasses[0]->lines().value(4).endsWith("0.0000")) << "flat is not";
    pointAt({3, picture.height() - 3}); // where no mesh is
    EXPECT_EQ(glasses[0]->lines().size(), 1);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&picture, &leave);
    EXPECT_FALSE(glasses[0]->isVisible());
    window.action("loupe")->trigger();
    pointAt(at);
    EXPECT_FALSE(glasses[0]->isVisible());
}
