// Lights in the window: handles that are dragged, a section for each in the panel, and turning by itself.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/lights/light_handles.h"
#include "app/window/lights/turning.h"
#include "app/window/widgets/section.h"
#include "window_support.h"

namespace relievo {
namespace {
constexpr Around kBall{{0.f, 0.2f, 0.1f}, 0.8f};

CameraView cameraAt(float yaw, float pitch)
{
    Camera camera;
    camera.yaw = yaw, camera.pitch = pitch, camera.distance = 6.f;
    return cameraView(camera, kBall.middle - 0.46f, kBall.middle + 0.46f, 1.5f);
}

class LightsTest : public WindowTest {
protected:
    std::vector<LightHandle> handlesOf(std::size_t light)
    {
        std::vector<LightHandle> found;
        for (const LightHandle& handle : window.lights().handles())
            if (handle.light == light)
                found.push_back(handle);
        return found;
    }
    void setKind(const char* key, LightKind kind)
    {
        window.document().edit("Kind", [&](State& state) { assign(state, *findParameter(key), int(kind), kAllPanes); });
    }
};
} // namespace

TEST(LightPlaces, AHandleIsWhereTheHandBringsItsLight)
{
    for (const LightKind kind : {LightKind::Directional, LightKind::Point, LightKind::Spot})
        for (const float turn : {0.f, 200.f})
            for (const bool behind : {false, true})
                for (const glm::vec2 share : {glm::vec2(0.5f, 0.4f), glm::vec2(0.42f, 0.55f), glm::vec2(0.56f, 0.6f)}) {
                    Parameters p;
                    p.light3Kind = kind, p.light3Distance = 1.1f, p.lightTurn = turn;
                    const CameraView camera = cameraAt(140.f, 25.f);
                    moveLight(p, kLights[2], kBall, camera, share, behind);
                    const LightPlace place = lightPlace(p, kLights[2], kBall, camera);
                    EXPECT_TRUE(place.isThere);
                    EXPECT_EQ(place.isBehind, behind);
                    EXPECT_NEAR(place.share.x, share.x, 1e-3f);
                    EXPECT_NEAR(place.share.y, share.y, 1e-3f);
                    EXPECT_EQ(p.light3Distance, 1.1f);
                    EXPECT_EQ(p.lightYaw, Parameters().lightYaw) << "no other light moves";
                }
}

TEST(LightPlaces, PulledPastTheOutlineALightGoesRound)
{
    Parameters p;
    const CameraView camera = cameraAt(0.f, 0.f);
    moveLight(p, kLights[0], kBall, camera, {0.72f, 0.5f}, false);
    EXPECT_TRUE(lightPlace(p, kLights[0], kBall, camera).isBehind);
    EXPECT_GT(p.lightYaw, 90.f);
    for (const glm::vec2 share : {glm::vec2(-4.f, 0.5f), glm::vec2(0.5f, 40.f), glm::vec2(0.5f)}) {
        moveLight(p, kLights[0], kBall, camera, share, false);
        EXPECT_TRUE(inRange(*findParameter("lightYaw"), p.lightYaw) && inRange(*findParameter("lightPitch"), p.lightPitch));
    }
}

TEST(LightPlaces, WhatIsOutsideThePictureIsShownAtItsEdge)
{
    Parameters p;
    p.lightKind = LightKind::Point, p.lightDistance = 15.f;
    for (const float yaw : {0.f, 90.f, 170.f, -60.f}) {
        p.lightYaw = yaw;
        const LightPlace place = lightPlace(p, kLights[0], kBall, cameraAt(10.f, 20.f));
        EXPECT_FALSE(place.isThere) << yaw;
        EXPECT_GE(std::min(place.share.x, place.share.y), 0.03f) << yaw;
        EXPECT_LE(std::max(place.share.x, place.share.y), 0.97f) << yaw;
    }
}

TEST_F(LightsTest, HandlesStandWhileShiftIsHeldAndAreDraggedAsOneStep)
{
    EXPECT_TRUE(window.lights().handles().empty());
    setKind("light2Kind", LightKind::Point);
    const int before = steps();
    QTest::keyPress(&window.viewport(), Qt::Key_Shift);
    ASSERT_EQ(handlesOf(0).size(), 1u);
    ASSERT_EQ(handlesOf(1).size(), 1u);
    EXPECT_TRUE(window.lights().isVisible());
    const Camera camera = state().camera;
    const Parameters was = state().parameters;
    const QPoint from = handlesOf(1).front().at.toPoint();
    drag(window.viewport(), {from, from + QPoint(12, 6), from + QPoint(25, 15)}, Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_EQ(steps(), before + 1);
    EXPECT_NE(state().parameters.light2Yaw, was.light2Yaw);
    EXPECT_EQ(state().parameters.lightYaw, was.lightYaw);
    EXPECT_EQ(state().camera, camera) << "the picture does not move with it";
    QTest::keyRelease(&window.viewport(), Qt::Key_Shift);
    EXPECT_FALSE(window.lights().isVisible());
    window.document().undoStack().undo();
    EXPECT_EQ(state().parameters.light2Yaw, was.light2Yaw);

    // Beside the handles Shift moves the picture as ever.
    const QPoint middle = window.viewport().rect().center();
    drag(window.viewport(), {middle, middle + QPoint(30, 0)}, Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_TRUE(state().camera.target.has_value());
}

TEST_F(LightsTest, TheWheelBringsAHeldLightNearer)
{
    setKind("lightKind", LightKind::Spot);
    QTest::keyPress(&window.viewport(), Qt::Key_Shift);
    const QPoint from = handlesOf(0).front().at.toPoint();
    QTest::mousePress(&window.viewport(), Qt::LeftButton, Qt::ShiftModifier, from);
    QWheelEvent wheel(
        from, window.viewport().mapToGlobal(QPointF(from)), {}, {0, 120}, Qt::LeftButton, Qt::ShiftModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&window.viewport(), &wheel);
    QTest::mouseRelease(&window.viewport(), Qt::LeftButton, Qt::ShiftModifier, from);
    EXPECT_FLOAT_EQ(state().parameters.lightDistance, 0.875f * Parameters().lightDistance);
    EXPECT_FALSE(state().camera.distance.has_value());
}

TEST_F(LightsTest, ALightWhoseSectionIsOpenShowsItsHandleAndRows)
{
    EXPECT_TRUE(isShown(state(), *findParameter("light3Kind")));
    EXPECT_FALSE(isShown(state(), *findParameter("light3Yaw"))) << "it is off";
    setKind("light3Kind", LightKind::Directional);
    EXPECT_TRUE(isShown(state(), *findParameter("light3Yaw")));
    EXPECT_FALSE(isShown(state(), *findParameter("light3Distance")) || isShown(state(), *findParameter("light3Cone")));
    setKind("light3Kind", LightKind::Spot);
    EXPECT_TRUE(isShown(state(), *findParameter("light3Distance")) && isShown(state(), *findParameter("light3Cone")));
    EXPECT_TRUE(window.lights().handles().empty()) << "the section is closed at first";
    for (Section* section : window.parameters().findChildren<Section*>())
        if (section->findChild<ParameterEditor*>("light3Kind"))
            section->setOpen(true);
    EXPECT_EQ(window.lights().handles().size(), 1u);
    EXPECT_EQ(handlesOf(2).size(), 1u);
}

TEST_F(LightsTest, AnUnlinkedPanesLightsAreItsOwn)
{
    setKind("light2Kind", LightKind::Point);
    window.document().edit("Panes", [](State& state) { setPaneCount(state, 2), setLinked(state, 1, false); });
    EXPECT_TRUE(ownValues(state(), 1).empty()) << "its lights go with its camera";
    const Parameters was = effectiveParameters(state(), 0);
    QTest::keyPress(&window.viewport(), Qt::Key_Shift);
    ASSERT_EQ(handlesOf(1).size(), 2u);
    const QPoint from = handlesOf(1)[1].at.toPoint();
    drag(window.viewport(), {from, from + QPoint(10, 8)}, Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NE(effectiveParameters(state(), 1).light2Yaw, was.light2Yaw);
    EXPECT_EQ(effectiveParameters(state(), 0), was);
    window.document().edit("Link", [](State& state) { setLinked(state, 1, true); });
    EXPECT_EQ(effectiveParameters(state(), 1).light2Yaw, was.light2Yaw);
}

TEST_F(LightsTest, LightsAndCameraTurnByThemselvesWithoutSteps)
{
    const Parameters was = state().parameters;
    const float yaw = state().camera.yaw;
    window.viewport().setFocus();
    QTest::keyClick(&window.viewport(), Qt::Key_L, Qt::ControlModifier);
    EXPECT_TRUE(window.turning().turnsLights());
    EXPECT_TRUE(waitFor([&] { return state().parameters.lightTurn > 0.f; }));
    EXPECT_EQ(state().camera.yaw, yaw);
    window.action("turn-lights")->trigger();
    const float stopped = state().parameters.lightTurn;
    QTest::qWait(120);
    EXPECT_EQ(state().parameters.lightTurn, stopped);
    window.action("turntable")->trigger();
    EXPECT_TRUE(waitFor([&] { return state().camera.yaw != yaw; }));
    window.action("turntable")->trigger();
    EXPECT_EQ(steps(), 0);
    EXPECT_FALSE(window.document().isModified());
    Parameters same = state().parameters;
    same.lightTurn = 0.f;
    EXPECT_EQ(same, was) << "but the moment nothing has changed";
    EXPECT_TRUE(waitFor([&] { return window.viewport().isFull(); })) << "at rest again";
}

} // namespace relievo
