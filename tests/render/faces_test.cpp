// Which faces of a mesh a picture shows: not those behind the fronts, all from inside, and none cut away that the eye sees.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/camera_view.h"
#include "tests/render/mesh_support.h"
#include <glm/geometric.hpp>

using namespace relievo;
using namespace relievo::test;

namespace {

constexpr auto kConvex = std::to_array<const char*>({"box", "cylinder", "sphere"});

// Share of the picture that the mesh covers.
double covered(const Image& image)
{
    double pixels = 0.;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            pixels += image.value(x, y, 3) > 0.5f;
    return pixels / double(image.texelCount());
}

// Flat heights all over.
Resources withHeight(Resources resources, float height)
{
    Material material = *resources.material;
    material.height = HeightField(16, 16, std::vector<float>(256, height));
    resources.material = std::make_shared<const Material>(std::move(material));
    resources.accelerationMaps = {};
    return resources;
}

// The plane in cells * cells squares.
Mesh gridOf(const Mesh& plane, std::uint32_t cells)
{
    Mesh grid = plane;
    const Vertex corner = plane.vertices.front();
    grid.vertices.clear(), grid.indices.clear();
    for (std::uint32_t j = 0; j <= cells; ++j)
        for (std::uint32_t i = 0; i <= cells; ++i) {
            Vertex vertex = corner;
            vertex.uv = glm::vec2(float(i), float(j)) / float(cells);
            vertex.position = glm::vec3(vertex.uv.x - 0.5f, 0.f, vertex.uv.y - 0.5f);
            grid.vertices.push_back(vertex);
        }
    for (std::uint32_t j = 0; j < cells; ++j)
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = j * (cells + 1) + i, b = a + cells + 1;
            grid.indices.insert(grid.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    grid.parts = {{"grid", "", 0, std::uint32_t(grid.indices.size()), 1.f}};
    return grid;
}

} // namespace

// The relief of a front reaches behind the faces at the back, which do not show for it.
TEST(Faces, BacksStayHiddenByTheDepthOfTheRelief)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    for (const char* mesh : kConvex) {
        State state = stateOn(mesh);
        state.parameters.depth = 0.3f, state.parameters.heightMips = false;
        Resources resources = resourcesOf(state);
        const Image without = picture(renderer, state, resources, "position");
        state.parameters.depthOfHit = true;
        EXPECT_LT(differing(picture(renderer, state, resources, "position"), without, 1e-4f), 0.001) << mesh;
        Resources open = resources; // its back hides nothing and is hidden
        Mesh without1 = *resources.mesh;
        without1.indices.resize(without1.indices.size() - 3), without1.parts.back().indexCount -= 3;
        open.mesh = std::make_shared<const Mesh>(std::move(without1));
        state.parameters.depthOfHit = false;
        const Image opened = picture(renderer, state, open, "position");
        state.parameters.depthOfHit = true;
        EXPECT_LT(differing(picture(renderer, state, open, "position"), opened, 1e-4f), 0.001) << mesh;
    }
}

// Through the holes of a material the inside is seen, whatever depth is written.
TEST(Faces, HolesShowTheInside)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("sphere");
    Resources resources = resourcesOf(state);
    Material material = *resources.material;
    Image holes{2, 2, 1, PixelType::U8, 8, false, std::vector<std::byte>(4)};
    holes.data[0] = holes.data[3] = std::byte(255);
    material.maps[std::size_t(MapKind::Opacity)] = std::make_shared<const Image>(holes);
    resources.material = std::make_shared<const Material>(std::move(material));
    const double share = covered(picture(renderer, state, resources, "position"));
    state.parameters.depthOfHit = true;
    EXPECT_NEAR(covered(picture(renderer, state, resources, "position")), share, 0.01);
}

// The same as the light sees it: faces away from it take no light from those that face it.
TEST(Faces, BacksDoNotShadeTheReliefInFrontOfThem)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    for (const char* mesh : {"box", "cylinder"}) { // without faces that the light only grazes
        State state = stateOn(mesh);
        Parameters& p = state.parameters;
        p.depth = 0.4f, p.heightMips = false, p.shadows = false, p.objectShadows = true;
        state.camera.yaw = p.lightYaw, state.camera.pitch = p.lightPitch;
        Resources resources = resourcesOf(state);
        Mesh lit = *resources.mesh;
        std::vector<std::uint32_t> facing;
        for (std::size_t i = 0; i < lit.indices.size(); i += 3) {
            const auto at = [&](std::size_t k) { return lit.vertices[lit.indices[i + k]].position; };
            if (glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), directionTo(p.lightYaw, p.lightPitch)) > 0.f)
                facing.insert(facing.end(), {lit.indices[i], lit.indices[i + 1], lit.indices[i + 2]});
        }
        ASSERT_LT(facing.size(), lit.indices.size());
        lit.indices = facing, lit.parts = {{"lit", "", 0, std::uint32_t(facing.size()), 1.f}};
        Resources half = resources;
        half.mesh = std::make_shared<const Mesh>(std::move(lit));
        Renderer renderer, other;
        EXPECT_LT(differing(picture(renderer, state, resources, "shadow"), picture(other, state, half, "shadow"), 0.1f), 0.001) << mesh;
    }
}

TEST(Faces, AClosedMeshIsSeenFromInside)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    for (const Silhouettes silhouettes : {Silhouettes::Off, Silhouettes::Axes, Silhouettes::Quadric, Silhouettes::Prisms}) {
        State state = stateOn("sphere");
        state.parameters.silhouettes = silhouettes;
        state.parameters.depthOfHit = silhouettes == Silhouettes::Off;
        state.camera.distance = 0.1f, state.camera.target = glm::vec3(0.f);
        EXPECT_GT(covered(picture(renderer, state, resourcesOf(state), "position")), 0.95) << wordOf(silhouettes);
    }
}

// On a fine mesh a ray goes through many prisms before it comes to the floor, and sees it all the same.
TEST(Faces, PrismsOfAFineMeshCutNothingAway)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    State state = stateOn("plane");
    Parameters& p = state.parameters;
    p.silhouettes = Silhouettes::Prisms, p.depth = 0.1f, p.heightMips = false;
    state.camera = {0.f, 12.f, 35.f, 1.2f, glm::vec3(0.f)};
    const Resources flat = withHeight(resourcesOf(state), 0.f);
    const auto drawn = [&](std::uint32_t cells) {
        Resources resources = flat;
        resources.mesh = std::make_shared<const Mesh>(gridOf(*flat.mesh, cells));
        Renderer renderer;
        return picture(renderer, state, resources, "position", 96, 72);
    };
    const Image coarse = drawn(4);
    EXPECT_LT(differing(drawn(150), coarse, 2e-3f), 0.01); // up to 140 of them
    p.depth = 0.2f;
    const Image deeper = drawn(4), finer = drawn(600); // more than are walked through
    int seen = 0, cut = 0;
    for (int y = 0; y < deeper.height; ++y)
        for (int x = 0; x < deeper.width; ++x)
            if (deeper.value(x, y, 3) > 0.5f)
                ++seen, cut += finer.value(x, y, 3) < 0.5f;
    EXPECT_GT(seen, 500);
    EXPECT_LT(cut, seen / 100);
}

// Plain parts lie on the mesh, and so do their wires.
TEST(Faces, WiresOfPlainPartsAreNotPushedOut)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("sphere");
    state.parameters.wireframe = true, state.parameters.depth = 0.3f;
    Resources resources = resourcesOf(state);
    Mesh mesh = *resources.mesh;
    mesh.parts.front().relief = 0.f;
    resources.mesh = std::make_shared<const Mesh>(std::move(mesh));
    state.parameters.midlevel = 1.f;
    const Image on = picture(renderer, state, resources, "normal");
    state.parameters.midlevel = 0.f;
    EXPECT_EQ(picture(renderer, state, resources, "normal").data, on.data);
}

// Fading follows the eye; the light sees the relief in its whole depth.
TEST(Faces, FadingIsNotOfTheLight)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    State state = stateOn("plane");
    Parameters& p = state.parameters;
    p.depth = 0.2f, p.shadows = false, p.lightPitch = 20.f;
    state.camera.pitch = 80.f;
    Resources resources = resourcesOf(state);
    const auto dark = [&](float edgeFade) {
        p.edgeFade = edgeFade;
        p.objectShadows = false;
        Renderer renderer; // the maps of two could be the same
        const Image lit = picture(renderer, state, resources, "shadow");
        p.objectShadows = true;
        return differing(picture(renderer, state, resources, "shadow"), lit, 0.3f);
    };
    const auto plain = dark(0.f), faded = dark(0.9f);
    EXPECT_GT(plain, 0.01); // there are shadows
    EXPECT_GT(faded, 0.3 * plain);
    EXPECT_LT(faded, plain + 0.02);
}
