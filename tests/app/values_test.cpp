// What needs no window: slider scales, editing for panes, camera moves, the frame pacer, messages, and the action table.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions.h"
#include "app/window/document/editing.h"
#include "app/window/document/messages.h"
#include "app/window/document/recent_files.h"
#include "app/window/viewport/frame_pacer.h"
#include "app/window/viewport/navigation.h"
#include "app/window/widgets/slider_scale.h"
#include "core/state/techniques.h"
#include <QFile>
#include <QSettings>
#include <cmath>
#include <gtest/gtest.h>

using namespace relievo;

namespace {
const ParameterRow& row(const char* key)
{
    return *findParameter(key);
}
bool isNumber(const ParameterRow& p)
{
    return kindOf(p) == ValueKind::Number || kindOf(p) == ValueKind::Whole;
}
} // namespace

TEST(SliderScale, GoesThereAndBackForEveryRow)
{
    for (const ParameterRow& p : kParameters) {
        if (!isNumber(p))
            continue;
        const SliderScale scale = scaleOf(p);
        EXPECT_NEAR(scale.value(0), p.min, 1e-6 * std::abs(p.max)) << p.key;
        EXPECT_NEAR(scale.value(1), p.max, 1e-6 * std::abs(p.max)) << p.key;
        for (double at = 0.05; at < 1; at += 0.1)
            EXPECT_NEAR(scale.position(scale.value(at)), at, 1e-9) << p.key;
        for (auto grain : {SliderScale::Grain::Fine, SliderScale::Grain::Normal, SliderScale::Grain::Coarse})
            for (double at = 0; at <= 1; at += 0.01) {
                const double v = scale.rounded(scale.value(at), grain);
                EXPECT_GE(v, p.min) << p.key;
                EXPECT_LE(v, p.max) << p.key;
            }
    }
}

TEST(SliderScale, WideRangesAreNotLinear)
{
    EXPECT_EQ(scaleOf(row("tiling")).kind, SliderScale::Kind::Logarithmic);
    EXPECT_EQ(scaleOf(row("maxSteps")).kind, SliderScale::Kind::Logarithmic);
    EXPECT_EQ(scaleOf(row("depth")).kind, SliderScale::Kind::Cubic);
    EXPECT_EQ(scaleOf(row("midlevel")).kind, SliderScale::Kind::Linear);
    EXPECT_NEAR(scaleOf(row("tiling")).position(1.), 0.4, 1e-6);
}

TEST(SliderScale, NumbersOfARowHaveEqualDigits)
{
    EXPECT_EQ(numberText(row("depth"), 0.08), "0.080");
    EXPECT_EQ(numberText(row("maxSteps"), 32), "32");
    EXPECT_EQ(numberText(row("rotation"), -0.0), "0.0");
    EXPECT_EQ(numberText(row("errorRange"), 0.0001), "0.0001");
}

TEST(Editing, APanesOwnValueReachesOnlyThatPane)
{
    State state;
    setPaneCount(state, 2);
    assign(state, row("depth"), 0.3f, Scope(1));
    EXPECT_FLOAT_EQ(effectiveParameters(state, 0).depth, Parameters{}.depth);
    EXPECT_FLOAT_EQ(effectiveParameters(state, 1).depth, 0.3f);
    EXPECT_TRUE(isOverridden(state, row("depth"), Scope(1)));
    EXPECT_FALSE(isOverridden(state, row("depth"), Scope(0)));
    reset(state, row("depth"), Scope(1));
    EXPECT_FALSE(isOverridden(state, row("depth"), kAllPanes));
    assign(state, row("depth"), 0.3f, Scope(0));
    assign(state, row("depth"), 0.2f, kAllPanes);
    EXPECT_FLOAT_EQ(effectiveParameters(state, 0).depth, 0.2f);
}

TEST(Editing, OnlyWhatIsUsedIsShown)
{
    State state;
    state.panes[0].technique = "flat";
    EXPECT_FALSE(isShown(state, row("maxSteps")));
    EXPECT_FALSE(isShown(state, row("shadowStrength"))) << "flat casts no shadows";
    EXPECT_TRUE(isShown(state, row("depth")));
    setPaneCount(state, 2);
    state.panes[1].technique = "relief";
    EXPECT_TRUE(isShown(state, row("maxSteps"))) << "the other pane searches";
    EXPECT_TRUE(isShown(state, row("shadowBias")));
    state.panes[1].technique = "cell-cone";
    EXPECT_TRUE(isShown(state, row("shadowStrength")));
    EXPECT_FALSE(isShown(state, row("shadowBias"))) << "exact techniques need none";
    state.panes[1].technique = "relief";
    state.parameters.shadows = false;
    EXPECT_FALSE(isShown(state, row("shadowStrength")));
    EXPECT_FALSE(isShown(state, row("shadowBias")));
    EXPECT_TRUE(isShown(state, row("roughness")));
    state.parameters.shading = Shading::BlinnPhong;
    EXPECT_FALSE(isShown(state, row("roughness")));
    EXPECT_TRUE(isShown(state, row("shininess")));
}

TEST(Navigation, OrbitKeepsTheDistanceAndPitchStopsAtThePoles)
{
    Camera camera;
    camera = orbited(camera, 10, 10000);
    EXPECT_FLOAT_EQ(camera.pitch, 90.f);
    EXPECT_FALSE(camera.distance.has_value());
    for (int i = 0; i < 500; ++i)
        camera = orbited(camera, 7, 0);
    EXPECT_LE(std::abs(camera.yaw), 180.f);
}

TEST(Navigation, LookingAroundKeepsTheEye)
{
    const Camera camera;
    const CameraView before = cameraView(camera, glm::vec3(-1), glm::vec3(1), 1.5f);
    const CameraView after = cameraView(lookedAround(camera, before, 30, -12), glm::vec3(-1), glm::vec3(1), 1.5f);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(before.eye[i], after.eye[i], 1e-5f);
}

TEST(Navigation, PanMovesTheTargetWithTheHand)
{
    const Camera camera;
    const CameraView before = cameraView(camera, glm::vec3(-1), glm::vec3(1), 1.f);
    const CameraView after = cameraView(panned(camera, before, 100, 0, 500), glm::vec3(-1), glm::vec3(1), 1.f);
    const auto across = [&](const CameraView& view) { // where the old target stands in the picture, in pixels
        const glm::vec4 clip = view.clipFromView * view.viewFromWorld * glm::vec4(before.target, 1.f);
        return clip.x / clip.w * 250.f;
    };
    EXPECT_NEAR(across(after) - across(before), 100.f, 0.5f);
}

TEST(Navigation, EveryGestureOfTheTableIsReached)
{
    for (const GestureRow& gesture : kGestures)
        EXPECT_EQ(gestureFor(gesture.button, Qt::KeyboardModifiers(gesture.modifiers), gesture.lightKey), gesture.gesture) << gesture.text;
    EXPECT_FALSE(gestureFor(Qt::BackButton, Qt::NoModifier, false));
}

TEST(FramePacer, StaysWithinItsScalesAndFindsTheTarget)
{
    FramePacer slow, fast;
    for (int i = 0; i < 20; ++i) {
        slow.took(500 * slow.scale() * slow.scale(), slow.scale());
        fast.took(1 * fast.scale() * fast.scale(), fast.scale());
    }
    EXPECT_NEAR(slow.scale(), 1. / 6, 1e-9) << "never below a sixth each way";
    EXPECT_GE(fast.scale(), 11. / 12);
}

TEST(Messages, AreWithdrawnWhenCured)
{
    Messages messages;
    messages.set("maps", Warnings{{"a", "One."}, {"b", "Two."}});
    messages.set("load", Error{"it is broken", "x.png", ""});
    ASSERT_EQ(messages.all().size(), 3);
    EXPECT_TRUE(messages.all().front().isError);
    messages.set("maps", Warnings{{"b", "Two."}});
    messages.clear("load");
    ASSERT_EQ(messages.all().size(), 1);
    EXPECT_EQ(messages.all().front().text, "Two.");
}

TEST(RecentFiles, NewestFirstWithoutRepeats)
{
    QSettings().clear();
    for (int i = 0; i < kRecentFiles + 3; ++i)
        addRecentFile(QString("/f%1").arg(i));
    addRecentFile("/f9");
    EXPECT_EQ(recentFiles().size(), kRecentFiles);
    EXPECT_EQ(recentFiles().front(), "/f9");
    EXPECT_EQ(recentFiles().count("/f9"), 1);
    removeRecentFile("/f9");
    EXPECT_FALSE(recentFiles().contains("/f9"));
}

TEST(Actions, HaveIconsThatExist)
{
    for (const ActionRow& action : kActions) {
        const QString file = QString(":/resources/icons/%1.svg").arg(QString::fromStdString(std::string(action.icon)));
        EXPECT_TRUE(action.icon.empty() || QFile::exists(file)) << action.key;
    }
}
