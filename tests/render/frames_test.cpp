// Frames without tangents, and pixels that are no numbers.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure/mesh_errors.h"
#include "tests/render/mesh_support.h"
#include <glm/geometric.hpp>

using namespace relievo;
using namespace relievo::test;

TEST(Frames, DerivativesAgreeWithVerticesAndTheThesisDoesNot)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("plane");
    state.parameters.depth = 0.2f;
    state.camera.yaw = 55.f, state.camera.pitch = 30.f;
    Resources resources = resourcesOf(state);
    const Image vertex = picture(renderer, state, resources, "color");
    state.parameters.frames = Frames::Derivatives;
    const Image derivatives = picture(renderer, state, resources, "color");
    state.parameters.frames = Frames::Thesis;
    const Image thesis = picture(renderer, state, resources, "color");
    const double off = differing(derivatives, vertex, 0.05f), slid = differing(thesis, vertex, 0.05f);
    EXPECT_LT(off, 0.02);
    EXPECT_GT(slid, 10. * off + 0.1);
}

TEST(Frames, EdgeFadeFlattensWhatIsSeenEdgeOn)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("sphere");
    state.parameters.frames = Frames::Derivatives, state.parameters.depth = 0.15f;
    Resources resources = resourcesOf(state);
    // The largest shift of what is seen, towards the outline and in the middle of the sphere.
    const auto shifts = [&](bool outline) {
        State flat = state;
        flat.panes = {Pane{"flat", {}}};
        const Image polygon = picture(renderer, flat, resources, "position"), relief = picture(renderer, state, resources, "position");
        const CameraView camera = cameraView(state.camera, resources.mesh->boundsMin, resources.mesh->boundsMax, 4.f / 3.f);
        double largest = 0.;
        for (int y = 0; y < relief.height; ++y)
            for (int x = 0; x < relief.width; ++x) {
                const glm::vec3 at(polygon.value(x, y, 0), polygon.value(x, y, 1), polygon.value(x, y, 2));
                const glm::vec3 point(relief.value(x, y, 0), relief.value(x, y, 1), relief.value(x, y, 2));
                const float cosine = glm::dot(glm::normalize(at), glm::normalize(camera.eye - at));
                if (relief.value(x, y, 3) > 0.5f && (cosine < 0.12f) == outline && cosine > 0.02f)
                    largest = std::max(largest, double(glm::distance(at, point)) * double(cosine));
            }
        return largest;
    };
    const double middle = shifts(false), outline = shifts(true);
    EXPECT_GT(outline, 0.2 * middle);
    state.parameters.edgeFade = 0.5f;
    EXPECT_GT(shifts(false), 0.8 * middle);
    EXPECT_LT(shifts(true), 0.4 * outline);
}

TEST(Invalid, NoPixelIsNoNumber)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    std::vector<std::string> meshes = {"sphere", "box", "spheres", "teapot", "character"};
    for (const char* file :
        {"spot.obj", "bunny.ply", "NormalTangentMirrorTest.glb", "TextureCoordinateTest.glb", "obj_quirks/deg_faces.obj"})
        if (std::filesystem::exists(kMeshes / file))
            meshes.push_back((kMeshes / file).string());
    for (const std::string& mesh : meshes)
        for (const Frames frames : {Frames::Vertex, Frames::Derivatives, Frames::Thesis}) {
            State state = stateOn(mesh);
            Parameters& p = state.parameters;
            p.frames = frames, p.silhouettes = frames == Frames::Vertex ? Silhouettes::Prisms : Silhouettes::Quadric,
            p.depthOfHit = p.objectShadows = p.shadows = true, p.edgeFade = frames == Frames::Derivatives ? 0.3f : 0.f;
            Resources resources = resourcesOf(state);
            const Image invalid = picture(renderer, state, resources, "invalid", 96, 72);
            for (int y = 0; y < invalid.height; ++y)
                for (int x = 0; x < invalid.width; ++x)
                    ASSERT_EQ(invalid.value(x, y, 0), 0.f) << mesh << " frames " << wordOf(frames);
        }
}
