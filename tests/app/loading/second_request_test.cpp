// Second requests in the window itself: what load_queue_test.cpp holds as a table, with files and a document.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/window_support.h"

using namespace relievo;

namespace {
class SecondRequest : public WindowTest {
protected:
    Assets& assets() { return window.assets(); }
    const std::string& height() { return state().slots[std::size_t(MapKind::Height)].file; }
    const std::string& color() { return state().slots[std::size_t(MapKind::Color)].file; }
    void edit(int maxSteps)
    {
        window.document().edit("Steps", [maxSteps](State& s) { s.parameters.maxSteps = maxSteps; });
    }
};
} // namespace

TEST_F(SecondRequest, AnEditComesToTheDocumentThatIsBeingOpened)
{
    assets().openDocument("sample:terrain@256", State{});
    drop(mapRow("color"), writeImage("a_color.png"));
    settle();
    EXPECT_EQ(height(), "sample:terrain@256");
    EXPECT_EQ(color(), file("a_color.png").toStdString());
    EXPECT_EQ(steps(), 1);
    EXPECT_TRUE(assets().upToDate());
}

TEST_F(SecondRequest, ADocumentIsOpenedAfterTheEditBeforeIt)
{
    drop(mapRow("height"), writeImage("a_height.png", 256));
    assets().askFirst = {};
    assets().openDocument("sample:terrain@64", State{});
    EXPECT_TRUE(assets().changesPending());
    settle();
    EXPECT_EQ(height(), "sample:terrain@64");
    EXPECT_EQ(steps(), 0);
    EXPECT_FALSE(window.document().isModified());
}

TEST_F(SecondRequest, TheMapsThatWereOpenedLastAreShown)
{
    edit(77);
    assets().openInto("sample:terrain@512");
    assets().openInto("sample:cobblestones@64");
    settle();
    EXPECT_EQ(height(), "sample:cobblestones@64");
    EXPECT_EQ(steps(), 2) << "the terrain was overtaken";
    window.action("undo")->trigger();
    settle();
    EXPECT_EQ(state().parameters.maxSteps, 77);
}

TEST_F(SecondRequest, CancellingEndsAllThatWaits)
{
    const MapSlots before = state().slots;
    assets().openDocument("sample:terrain@512", State{});
    drop(mapRow("color"), writeImage("a_color.png"));
    assets().background().cancel();
    settle();
    EXPECT_EQ(state().slots, before);
    EXPECT_EQ(steps(), 0);
    EXPECT_FALSE(assets().changesPending());
}

TEST_F(SecondRequest, AMapThatWasPutOffIsMadeAfterTheEdit)
{
    assets().openDocument("sample:bricks@256");
    settle();
    window.setTechnique("cone-relaxed");
    ASSERT_TRUE(assets().background().busy());
    drop(mapRow("color"), writeImage("a_color.png"));
    settle();
    EXPECT_EQ(color(), file("a_color.png").toStdString());
    EXPECT_TRUE(missingMaps().empty());
    EXPECT_TRUE(window.messages().all().isEmpty()) << window.messageLine().text().toStdString();
}

TEST_F(SecondRequest, WhatIsOverAtOnceStopsWhatItMakesPointless)
{
    edit(77);
    window.maps().setMesh("teapot");
    ASSERT_TRUE(assets().background().busy());
    window.maps().setMesh("plane");
    EXPECT_FALSE(assets().background().busy());
    EXPECT_EQ(steps(), 1);
}

TEST_F(SecondRequest, ARefusedOpeningDoesNotFailTheEditAfterIt)
{
    bool all = false;
    QObject::connect(&assets(), &Assets::changesEnded, &window, [&](bool made) { all = made; });
    assets().openDocument("/no/such/wall.relievo");
    drop(mapRow("color"), writeImage("a_color.png"));
    settle();
    EXPECT_EQ(color(), file("a_color.png").toStdString());
    EXPECT_TRUE(all);
}

TEST_F(SecondRequest, WhatIsOpenedAfterAFirstSourceThatFailsStays)
{
    MainWindow other;
    other.show();
    other.assets().openDocument("/no/such/wall.relievo");
    other.assets().openDocument("sample:terrain@64");
    ASSERT_TRUE(waitFor([&] { return other.assets().ready() && !other.assets().background().busy(); }));
    EXPECT_EQ(other.document().state().name, "Terrain");
}
