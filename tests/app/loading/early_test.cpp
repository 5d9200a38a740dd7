// What is drawn while a texture set is being opened: its heights first, in place of the document and no part of it.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/maps_to_come.h"
#include "tests/app/window_support.h"
#include <oneapi/tbb/global_control.h>

using namespace relievo;

namespace {
class EarlyTest : public WindowTest {
protected:
    using global_control = oneapi::tbb::global_control;
    global_control inTurn{global_control::max_allowed_parallelism, 1}; // heights are read first, and nothing beside them

    // A set of three files, of which it answers a folder.
    QString set()
    {
        for (const char* name : {"maps_height.png", "maps_color.png", "maps_roughness.png"})
            writeImage(name, 64);
        return folder.path();
    }
    const MapSlots& drawnSlots()
    {
        drawn = window.assets().drawnState();
        return drawn.slots;
    }
    bool isDrawn(MapKind kind) { return !drawnSlots()[std::size_t(kind)].empty(); }
    State drawn;
};
} // namespace

TEST_F(EarlyTest, HeightsAreDrawnFirstAndTheDocumentStays)
{
    window.document().edit("Edit", [](State& s) { s.parameters.maxSteps = 77; });
    const State before = state();
    QList<QPair<bool, bool>> seen; // height and colour
    QObject::connect(&window.assets(), &Assets::earlyChanged, &window, [&] {
        if (!window.assets().drawsEarly())
            return;
        seen.append({isDrawn(MapKind::Height), isDrawn(MapKind::Color)});
        EXPECT_EQ(state(), before);
        EXPECT_EQ(steps(), 1);
        EXPECT_NE(window.assets().drawnResources().material, window.assets().resources().material);
    });
    window.assets().openInto(set());
    settle();
    EXPECT_EQ(seen, (QList<QPair<bool, bool>>{{true, false}, {true, true}}));
    EXPECT_FALSE(window.assets().drawsEarly());
    EXPECT_EQ(steps(), 2) << "the opening is one step";
    EXPECT_EQ(window.assets().drawnState(), state());
    EXPECT_TRUE(waitFor([&] { return window.viewport().isSettled(); }));
}

TEST_F(EarlyTest, CancelledItIsGone)
{
    const State before = state();
    int told = 0;
    QObject::connect(&window.assets(), &Assets::earlyChanged, &window, [&] {
        ++told;
        if (window.assets().drawsEarly())
            window.assets().background().cancel();
    });
    window.assets().openInto(set());
    settle();
    EXPECT_EQ(told, 2) << "drawn, and gone";
    EXPECT_FALSE(window.assets().drawsEarly());
    EXPECT_EQ(state(), before);
    EXPECT_EQ(window.assets().drawnState(), before);
    EXPECT_TRUE(waitFor([&] { return window.viewport().isSettled(); })) << "the old picture is drawn in full again";
}

TEST_F(EarlyTest, WhatIsEditedMeanwhileIsDrawn)
{
    QObject::connect(&window.assets(), &Assets::earlyChanged, &window, [&] {
        if (!window.assets().drawsEarly())
            return;
        window.document().edit("Steps", [](State& s) { s.parameters.maxSteps = 77; });
        EXPECT_EQ(window.assets().drawnState().parameters.maxSteps, 77);
    });
    window.assets().openInto(set());
    settle();
    EXPECT_EQ(state().parameters.maxSteps, 77);
}

// Maps that are made of the heights would have to be waited for.
TEST_F(EarlyTest, NothingIsDrawnEarlyWithAnAccelerationMap)
{
    window.setTechnique("cone");
    settle();
    int told = 0;
    QObject::connect(&window.assets(), &Assets::earlyChanged, &window, [&] { ++told; });
    window.assets().openInto(set());
    settle();
    EXPECT_EQ(told, 0);
    EXPECT_TRUE(missingMaps().empty());
}

// What stands in is one texel as shaders have it without the map, or normals of the heights; the slots say that it is no map.
TEST(MapsToCome, EachKindHasAStandIn)
{
    Material material;
    std::vector<float> slope(16 * 16);
    for (std::size_t i = 0; i < slope.size(); ++i)
        slope[i] = float(i % 16) / 15.f;
    material.height.emplace(16, 16, slope, Wrap::Clamp);
    EnumSet<MapKind> coming;
    for (const MapKindRow& row : kMapKinds)
        if (row.kind != MapKind::Height)
            coming.insert(row.kind);
    const auto whole = withMapsToCome(material, coming, 0.1f);
    EXPECT_EQ(whole->slots, material.slots);
    EXPECT_EQ(whole->height->identity(), material.height->identity());
    for (const MapKindRow& row : kMapKinds)
        if (row.kind != MapKind::Height) {
            EXPECT_EQ(whole->map(row.kind)->channels, row.channels) << row.key;
        }
    EXPECT_FLOAT_EQ(whole->map(MapKind::Color)->value(0, 0, 2), kColorWithoutMap);
    EXPECT_EQ(whole->map(MapKind::Metallic)->value(0, 0, 0), 0.f);
    EXPECT_EQ(whole->map(MapKind::Roughness)->value(0, 0, 0), 1.f);
    EXPECT_LT(whole->map(MapKind::Normal)->value(8, 8, 0), 0.49f) << "leans against the rise";
    EXPECT_EQ(withMapsToCome(material, {}, 0.1f)->map(MapKind::Color), nullptr);
}
