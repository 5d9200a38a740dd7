// What takes its time says so while it lasts, can be stopped and begun again, and is kept as long as it holds.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/viewport/mesh_reference.h"
#include "tests/app/window_support.h"
#include <QLabel>
#include <QToolButton>
#include <algorithm>

using namespace relievo;

namespace {
class WaitingTest : public WindowTest {
protected:
    Background& background() { return window.assets().background(); }
    const MeshReference& reference() { return window.viewport().reference(); }
    const ExactDistances* seen() { return reference().exactOf(0).get(); }
    bool says(const char* text) { return window.messageLine().text().contains(text); }
    bool hasError()
    {
        const auto all = window.messages().all();
        return std::ranges::any_of(all, &Message::isError);
    }
    void set(const char* key, Value value)
    {
        window.document().edit(key, [&](State& s) { relievo::set(s.parameters, *findParameter(key), value); });
    }
    void showError()
    {
        window.maps().setMesh("sphere");
        settle();
        window.document().edit("View", [](State& s) { setView(s, "error-mesh"); });
    }
    void traced()
    {
        ASSERT_TRUE(waitFor([&] { return seen() && !reference().busy() && window.viewport().isSettled(); }));
    }
    // The technique, though it is chosen already.
    void chooseAgain() { chooseInCaption("technique", state().panes[0].technique.c_str()); }
};
constexpr const char* kTracing = "against the flat relief until";
} // namespace

TEST_F(WaitingTest, TheErrorSaysThatTheMeshIsBeingTraced)
{
    EXPECT_FALSE(says(kTracing));
    showError();
    EXPECT_TRUE(says(kTracing));
    EXPECT_FALSE(hasError());
    traced();
    EXPECT_FALSE(says(kTracing));
    set("depth", 0.2f);
    EXPECT_TRUE(says(kTracing));
    window.document().edit("View", [](State& s) { setView(s, "shaded"); });
    EXPECT_FALSE(says(kTracing));
}

TEST_F(WaitingTest, WhatWasTracedIsKeptAsLongAsItHolds)
{
    showError();
    traced();
    const ExactDistances* first = seen();
    set("exposure", 1.f);
    set("errorRange", 0.2f);
    set("maxSteps", 64);
    window.setTechnique("cell-cone");
    settle();
    EXPECT_EQ(seen(), first);
    window.document().edit("View", [](State& s) { setView(s, "shaded"); });
    EXPECT_EQ(seen(), nullptr) << "other views pay nothing";
    window.document().edit("View", [](State& s) { setView(s, "error-mesh"); });
    EXPECT_EQ(seen(), first);
    EXPECT_FALSE(reference().busy());
    for (const char* key : {"depth", "tiling", "rotation"}) {
        set(key, 0.3f);
        EXPECT_EQ(seen(), nullptr) << key;
        traced();
    }
}

TEST_F(WaitingTest, AnotherSizeIsTracedAndSaysSo)
{
    showError();
    traced();
    QStringList told;
    QObject::connect(&window.messages(), &Messages::changed, &window.viewport(), [&] { told << window.messageLine().text(); });
    window.resize(window.size() - QSize(0, 60));
    ASSERT_TRUE(waitFor([&] { return seen() && seen()->pixels.height == window.viewport().picture().height(); }));
    EXPECT_FALSE(told.filter(kTracing).isEmpty());
    EXPECT_FALSE(says(kTracing));
}

// A list that grew by the notice would make the picture smaller, which had to be traced anew, for ever.
TEST_F(WaitingTest, NoticesDoNotMoveThePicture)
{
    window.messages().set("test", QList<Message>{{false, "a warning"}});
    window.messageLine().setOpen(true);
    QTest::qWait(50);
    const int height = window.messageLine().height();
    showError();
    EXPECT_TRUE(says(kTracing)) << "also beside the list";
    QTest::qWait(20);
    EXPECT_EQ(window.messageLine().height(), height);
    EXPECT_TRUE(window.findChild<QToolButton*>("message-count")->text().contains("1 warning"));
    traced();
    window.messages().clear("test");
}

TEST_F(WaitingTest, AStoppedBakeSaysSoAndStartsWhenTheTechniqueIsChosenAgain)
{
    window.assets().openDocument("sample:bricks@512");
    settle();
    window.setTechnique("cone");
    ASSERT_TRUE(background().busy());
    EXPECT_TRUE(says("when the cone map has been made")) << window.messageLine().text().toStdString();
    QTest::qWait(50); // in which it is drawn
    EXPECT_FALSE(hasError()) << window.messageLine().text().toStdString();
    ASSERT_TRUE(background().busy());
    window.messageLine().findChild<QToolButton*>("cancel")->click();
    EXPECT_FALSE(background().busy());
    EXPECT_TRUE(says("Making the cone map was stopped; choose the technique again")) << window.messageLine().text().toStdString();
    QTest::qWait(100);
    EXPECT_FALSE(hasError()) << window.messageLine().text().toStdString();
    chooseAgain();
    EXPECT_TRUE(background().busy());
    settle();
    EXPECT_TRUE(missingMaps().empty());
    EXPECT_TRUE(window.messages().all().isEmpty()) << window.messageLine().text().toStdString();
    chooseAgain();
    EXPECT_FALSE(background().busy()) << "all is there";
}

TEST_F(WaitingTest, ABakeHasTheWholeBarAndItsName)
{
    window.assets().openDocument("sample:bricks@256");
    settle();
    QList<float> shares;
    QObject::connect(&background(), &Background::progressed, &window.viewport(), [&](float share) { shares << share; });
    window.setTechnique("cone-relaxed");
    EXPECT_EQ(window.messageLine().findChild<QLabel*>("doing")->text(), "Making the relaxed cone map");
    settle();
    ASSERT_FALSE(shares.isEmpty());
    EXPECT_LT(shares.front(), 0.3f);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    window.maps().setMesh("torus");
    EXPECT_EQ(window.messageLine().findChild<QLabel*>("doing")->text(), "Loading");
    settle();
}

TEST_F(WaitingTest, ARefusalIsForgottenWithTheNextEdit)
{
    drop(window, file("no-such-mesh.obj"));
    settle();
    EXPECT_TRUE(says("no-such-mesh.obj"));
    window.document().edit({}, [](State& s) { s.camera.yaw += 5.f; });
    EXPECT_TRUE(says("no-such-mesh.obj")) << "looking is no edit";
    set("depth", 0.2f);
    EXPECT_TRUE(window.messages().all().isEmpty()) << window.messageLine().text().toStdString();
}

TEST(MessagesTest, TheNewestErrorIsToldFirst)
{
    Messages messages;
    messages.set("b", Error{"old", "", ""});
    messages.set("c", QList<Message>{{false, "warning"}});
    messages.set("a", Error{"older still", "", ""});
    messages.set("b", Error{"new", "", ""});
    messages.setNotice("d", "notice");
    const auto all = messages.all();
    ASSERT_EQ(all.size(), 4);
    EXPECT_TRUE(all[0].text.contains("new"));
    EXPECT_TRUE(all[1].text.contains("older"));
    EXPECT_TRUE(all[3].isNotice);
}
