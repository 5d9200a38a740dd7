// Pictures of relief objects against the mesh that they stand for, and against the exact search on the same maps.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exporters/object_files.h"
#include "core/object/object_file.h"
#include "core/object/object_search.h"
#include "core/scene/scene_mesh.h"
#include "core/state/shapes.h"
#include "core/state/techniques.h"
#include "core/state/views.h"
#include "tests/core/mesh/mesh_support.h"
#include "tests/render/mesh_support.h"
#include <glm/geometric.hpp>

using namespace relievo;
using namespace relievo::test;

namespace {
// A shape baked to a folder; the path of its NAME.object.json.
std::string baked(const Scratch& folder, const std::string& shape, const ObjectOptions& options)
{
    const auto mesh = openMesh(shape);
    const auto surface = MeshSurface::load(*mesh, {});
    EXPECT_TRUE(surface);
    const auto written = writeObject({&*surface, options, folder.path / shape, shape, {}});
    EXPECT_TRUE(written) << (written ? "" : message(written.error()));
    return written ? written->files.back().string() : std::string();
}

State stateOfObject(const std::string& file, const char* technique = "object")
{
    State state;
    state.mesh = file;
    state.panes = {Pane{technique}};
    state.parameters.ground = false;
    return state;
}
} // namespace

// Where each pixel's point lies is what the search in double precision says of its ray.
TEST(ObjectPictures, AreWhatTheExactSearchFinds)
{
    const Scratch folder;
    for (const ObjectSides sides : {ObjectSides::One, ObjectSides::Two, ObjectSides::Six}) {
        State state = stateOfObject(baked(folder, "torus", {sides, 1, 64, 1}));
        auto context = WindowlessContext::create();
        ASSERT_TRUE(context);
        Renderer renderer;
        const Resources resources = resourcesOf(state);
        ASSERT_TRUE(resources.mesh && resources.mesh->object);
        for (const float yaw : {20.f, 140.f, 265.f}) {
            state.camera.yaw = yaw;
            state.camera.pitch = yaw / 4.f - 20.f;
            const Image points = picture(renderer, state, resources, "position");
            const glm::dvec3 eye = cameraOnto(*resources.mesh, state.camera, 160.f / 120.f).eye;
            int seen = 0, wrong = 0;
            for (int y = 0; y < points.height; ++y)
                for (int x = 0; x < points.width; ++x) {
                    if (points.value(x, y, 3) < 0.5f)
                        continue;
                    const glm::dvec3 point{points.value(x, y, 0), points.value(x, y, 1), points.value(x, y, 2)};
                    const auto hit = firstHit(resources.mesh->object->object, eye, point - eye);
                    ++seen;
                    wrong += !hit || std::abs(hit->t - 1.) * glm::length(point - eye) > 1e-3;
                }
            EXPECT_GT(seen, 2000) << yaw;
            EXPECT_LE(wrong, seen / 500) << yaw; // at outlines
        }
    }
}

TEST(ObjectPictures, AreThoseOfTheMesh)
{
    const Scratch folder;
    auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State object = stateOfObject(baked(folder, "torus", {ObjectSides::Six, 1, 256, 2})), mesh = stateOfObject("torus", "flat");
    // The same camera for both: boxes have other outlines.
    for (State* state : {&object, &mesh}) {
        state->camera.distance = 2.5f;
        state->camera.target = glm::vec3(0.f);
        state->parameters.tint = glm::vec3(0.8f);
        state->parameters.shadows = true;
    }
    const Resources ofObject = resourcesOf(object), ofMesh = resourcesOf(mesh);
    for (const float yaw : {0.f, 50.f, 170.f}) {
        object.camera.yaw = mesh.camera.yaw = yaw;
        EXPECT_LT(differing(picture(renderer, object, ofObject, "position"), picture(renderer, mesh, ofMesh, "position"), 0.02f), 0.03)
            << yaw;
        EXPECT_LT(differing(picture(renderer, object, ofObject, "normal"), picture(renderer, mesh, ofMesh, "normal"), 0.1f), 0.05) << yaw;
    }
}

TEST(ObjectPictures, EveryTechniqueAndViewDrawsFiniteValues)
{
    const Scratch folder;
    auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    const std::string file = baked(folder, "teapot", {ObjectSides::Six, 2, 48, 1});
    Resources resources = resourcesOf(stateOfObject(file));
    for (const TechniqueRow& technique : kObjectTechniques)
        for (const ViewRow& view : kViews) {
            State state = stateOfObject(file, std::string(technique.key).c_str());
            if (view.isAgainstExact && view.fileOnMesh.empty()) {
                EXPECT_FALSE(drawPicture(renderer, state, 0, resources, view.key, 80, 60, 1, true)) << view.key;
                continue;
            }
            const Image image = picture(renderer, state, resources, view.key, 80, 60);
            double sum = 0.;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x)
                    for (int c = 0; c < 4; ++c)
                        sum += double(image.value(x, y, c));
            EXPECT_TRUE(std::isfinite(sum)) << technique.key << ' ' << view.key;
        }
}

// From within its box it is seen as well, and lights of all kinds are hidden by it.
TEST(ObjectPictures, AreSeenFromInsideAndLitByAllLights)
{
    const Scratch folder;
    auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOfObject(baked(folder, "torus", {ObjectSides::Six, 1, 64, 1}));
    state.camera.target = glm::vec3(0.f, 0.f, 0.f);
    state.camera.distance = 0.05f; // in the hole
    state.camera.pitch = 0.f;
    const Resources resources = resourcesOf(state);
    const Image inside = picture(renderer, state, resources, "fetches");
    double covered = 0.;
    for (int y = 0; y < inside.height; ++y)
        for (int x = 0; x < inside.width; ++x)
            covered += double(inside.value(x, y, 3));
    EXPECT_GT(covered / double(inside.width * inside.height), 0.3);

    state = stateOfObject(state.mesh);
    const auto lit = [&] {
        const Image image = picture(renderer, state, resources, "shadow");
        double sum = 0., all = 0.;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                if (image.value(x, y, 3) > 0.5f)
                    sum += double(image.value(x, y, 0)), all += 1.;
        return sum / all;
    };
    const double hard = lit();
    EXPECT_GT(hard, 0.1);
    EXPECT_LT(hard, 0.95);
    state.parameters.lightSize = 10.f;
    EXPECT_NEAR(lit(), hard, 0.1);
    state.parameters.lightSize = 0.f;
    state.parameters.light2Kind = LightKind::Point;
    EXPECT_GT(lit(), 0.05);
    state.parameters = Parameters();
    state.parameters.ground = false;
    state.parameters.shadows = false;
    EXPECT_NEAR(lit(), 1., 1e-3);
}

// Shapes by formula are baked when they are opened, with as many sides as their name says.
TEST(ObjectPictures, ShapesAreObjectsByTheirNames)
{
    for (const auto& [name, sides] : {std::pair("object:box", 3), std::pair("object:knight@1", 1), std::pair("object:knight@2", 1)}) {
        ASSERT_TRUE(isBuiltInMesh(name)) << name;
        const auto mesh = openSceneMesh(name);
        ASSERT_TRUE(mesh) << message(mesh.error());
        ASSERT_TRUE(mesh->object);
        EXPECT_EQ(std::ranges::count_if(mesh->object->object.axes, &AxisMap::isGiven), sides) << name;
        EXPECT_TRUE(mesh->object->looks[4].color) << name;
    }
    for (const char* name : {"object:none", "object:box@3", "object:", "object:box@"})
        EXPECT_FALSE(isBuiltInMesh(name)) << name;
}

TEST(ObjectPictures, OnlyObjectsAreDrawnByTheirTechniques)
{
    const Scratch folder;
    auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State mesh = stateOfObject("torus");
    Resources ofMesh = resourcesOf(mesh);
    EXPECT_FALSE(drawPicture(renderer, mesh, 0, ofMesh, "shaded", 16, 16, 1, true));
    State object = stateOfObject(baked(folder, "box", {ObjectSides::Six, 1, 4, 1}), "relief");
    Resources ofObject = resourcesOf(object);
    const auto drawn = drawPicture(renderer, object, 0, ofObject, "shaded", 16, 16, 1, true);
    ASSERT_FALSE(drawn);
    EXPECT_NE(message(drawn.error()).find("relief object"), std::string::npos);
    fitTechniques(object);
    EXPECT_EQ(object.panes.front().technique, "object");
    EXPECT_TRUE(drawPicture(renderer, object, 0, ofObject, "shaded", 16, 16, 1, true));
    object.mesh = "torus";
    fitTechniques(object);
    EXPECT_EQ(object.panes.front().technique, Pane().technique);
}
