// Pictures of techniques that draw as engines do: measured from the engine's own mesh, which no midlevel moves, on the finest level.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure/picture_errors.h"
#include "tests/render/mesh_support.h"
#include <numbers>

using namespace relievo;
using namespace relievo::test;

namespace {

// A plane with cobblestones, or with one height everywhere.
struct Plane {
    Expected<WindowlessContext> context = WindowlessContext::create();
    Renderer renderer;
    State state = stateOn("plane");
    Resources resources = resourcesOf(state);

    void setHeight(float height)
    {
        Material material = *resources.material;
        material.height = HeightField(4, 4, std::vector<float>(16, height), Wrap::Repeat, 32);
        resources.material = std::make_shared<const Material>(std::move(material));
    }
    State seen(const char* technique, double angle) const
    {
        State view = fillingView(state, angle);
        view.panes = {Pane{technique, {}}};
        view.parameters.depth = 0.05f; // that Unity takes as it is
        return view;
    }
    Image shown(const State& view, const char* what) { return picture(renderer, view, resources, what, 96, 64); }
};

constexpr float kCosine = 0.5f; // of 60 degrees

} // namespace

TEST(EnginePictures, ErrorsAreOfTheDepthDrawn)
{
    Plane plane;
    plane.setHeight(0.25f);
    const auto errors
        = [&](const char* technique) { return *pictureErrors(plane.renderer, plane.seen(technique, 60.), plane.resources, 48, 32); };
    EXPECT_NEAR(errors("as-godot4").rmse, 0.75f * (1.f - kCosine), 2e-3);
    EXPECT_NEAR(errors("as-godot4-simple").rmse, 0.75f * (1.f - kCosine), 2e-3);
    EXPECT_NEAR(errors("as-bevy").rmse, 0., 1e-3);
    const float unity = kCosine / (kCosine + 0.42f); // counted from mid-grey
    EXPECT_NEAR(errors("as-unity-urp").rmse, 0.25f * (1.f - unity), 2e-3);
    plane.setHeight(0.5f);
    EXPECT_NEAR(errors("as-unity-builtin").rmse, 0., 1e-3);
}

// Where mid-grey lies on the mesh, mid-grey is seen there.
TEST(EnginePictures, PointsLieWhereTheEyeSeesThem)
{
    Plane plane;
    for (const auto& [height, technique, below] :
        {std::tuple{0.5f, "as-unity-urp", 0.f}, {1.f, "as-godot4", 0.f}, {0.f, "as-godot4", kCosine}, {0.f, "as-unreal", 1.f}}) {
        plane.setHeight(height);
        const State view = plane.seen(technique, 60.);
        const Image point = plane.shown(view, "position");
        const float depth = physicalDepth(view.parameters, plane.resources.mesh->metresPerUV);
        EXPECT_NEAR(point.value(48, 32, 1), -depth * below, 2e-3f * depth) << technique << height;
    }
}

// The engine's mesh stays where it is; Unreal and PlayCanvas are told the midlevel.
TEST(EnginePictures, TheMidlevelMovesThoseThatAreToldOfIt)
{
    Plane plane;
    for (const TechniqueRow& row : kTechniques) {
        if (!row.isEngine())
            continue;
        State view = plane.seen(std::string(row.key).c_str(), 45.);
        const Image inward = plane.shown(view, "color");
        view.parameters.midlevel = 0.4f;
        EXPECT_EQ(plane.shown(view, "color").data != inward.data, row.displaces) << row.key;
        EXPECT_EQ(row.displaces, row.key == "as-unreal" || row.key == "as-playcanvas") << row.key;
    }
}

TEST(EnginePictures, AreOfTheFinestLevel)
{
    Plane plane;
    for (const char* technique : {"as-godot4", "relief"}) {
        State view = plane.seen(technique, 60.);
        view.parameters.tiling = 64.f;
        const Image finest = plane.shown(view, "depth");
        view.parameters.heightMips = true;
        EXPECT_EQ(plane.shown(view, "depth").data == finest.data, std::string_view(technique) == "as-godot4") << technique;
    }
}
