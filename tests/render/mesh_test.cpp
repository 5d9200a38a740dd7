// Relief on meshes: poses on the GPU, shadows between objects, interpenetration, parts, fine meshes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/files/image_file.h"
#include "core/mesh/animation/pose.h"
#include "core/state/views.h"
#include "render/measure/mesh_errors.h"
#include "tests/render/mesh_support.h"
#include <cmath>
#include <cstdlib>
#include <epoxy/gl.h>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

using namespace relievo;
using namespace relievo::test;
namespace fs = std::filesystem;

namespace {

// The mesh as the CPU poses it, which no longer moves.
Resources posedResources(const State& state, Resources resources)
{
    Resources still = resources;
    Mesh mesh = posed(*resources.mesh, poseOf(*resources.mesh, state.parameters));
    mesh.deformation = nullptr;
    mesh.boundsMin = resources.mesh->boundsMin, mesh.boundsMax = resources.mesh->boundsMax; // the camera's framing
    still.mesh = std::make_shared<Mesh>(std::move(mesh));
    return still;
}

// Each triangle in four, until there are more than `triangles`; of a mesh of one part.
Mesh finer(Mesh fine, std::size_t triangles)
{
    while (fine.indices.size() / 3 <= triangles) {
        std::vector<std::uint32_t> indices;
        for (std::size_t i = 0; i < fine.indices.size(); i += 3) {
            const std::uint32_t corner[3] = {fine.indices[i], fine.indices[i + 1], fine.indices[i + 2]};
            std::uint32_t middle[3];
            for (std::size_t k = 0; k < 3; ++k) {
                Vertex v = fine.vertices[corner[k]];
                const Vertex& next = fine.vertices[corner[(k + 1) % 3]];
                v.position = (v.position + next.position) * 0.5f, v.uv = (v.uv + next.uv) * 0.5f;
                middle[k] = std::uint32_t(fine.vertices.size());
                fine.vertices.push_back(v);
            }
            indices.insert(indices.end(),
                {corner[0], middle[0], middle[2], middle[0], corner[1], middle[1], middle[2], middle[1], corner[2], middle[0], middle[1],
                    middle[2]});
        }
        fine.indices = std::move(indices);
    }
    fine.parts[0].indexCount = std::uint32_t(fine.indices.size());
    return fine;
}

} // namespace

TEST(Deforming, TheGpuPosesAsTheCpuDoes)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer, second;
    std::vector<std::string> meshes = {"character"};
    for (const char* file : {"SimpleMorph.gltf", "AnimatedMorphCube.glb", "CesiumMan.glb", "RiggedSimple.glb"})
        if (fs::exists(kMeshes / "animated" / file))
            meshes.push_back((kMeshes / "animated" / file).string());
    for (const std::string& mesh : meshes) {
        State state = stateOn(mesh, "flat");
        Resources resources = resourcesOf(state);
        ASSERT_TRUE(resources.mesh && resources.mesh->deformation) << mesh;
        Image first;
        for (const float share : {0.f, 0.37f, 0.8f}) {
            state.parameters.time = share * resources.mesh->deformation->clips.front().seconds;
            const Resources still = posedResources(state, resources);
            const Image moved = picture(renderer, state, resources, "position");
            const float size = glm::length(resources.mesh->boundsMax - resources.mesh->boundsMin);
            EXPECT_LT(differing(moved, picture(second, state, still, "position"), 1e-4f * size), 0.005) << mesh << " at " << share;
            EXPECT_LT(differing(picture(renderer, state, resources, "normal"), picture(second, state, still, "normal"), 0.02f), 0.01)
                << mesh << " at " << share;
            State deep = state; // the linear part of the skin is not the whole Jacobian where it bends
            deep.panes = {Pane{"cell-cone", {}}};
            EXPECT_LT(
                differing(picture(renderer, deep, resources, "position"), picture(second, deep, still, "position"), 0.01f * size), 0.12)
                << mesh << " at " << share;
            if (share == 0.f)
                first = moved;
            else
                EXPECT_GT(differing(moved, first, 0.002f * size), 0.05) << mesh << " does not move";
        }
    }
}

TEST(Interpenetration, ReliefMeetsPlainSpheresWhereTheyDo)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("spheres");
    state.parameters.depth = 0.15f;
    state.camera.pitch = 50.f;
    Resources resources = resourcesOf(state);
    Warnings warnings;
    const auto exact = exactDistances(state, 0, resources, 320, 240, warnings);
    ASSERT_TRUE(exact);
    state.parameters.silhouettes = Silhouettes::Quadric;
    const auto without = meshErrors(renderer, state, resources, *exact);
    state.parameters.depthOfHit = true;
    const auto with = meshErrors(renderer, state, resources, *exact);
    ASSERT_TRUE(without && with);
    EXPECT_LT(with->depthRmse, 0.5 * without->depthRmse) << without->depthRmse;
}

namespace {
// Of the covered pixels of a view of errors.
double meanOf(Renderer& renderer, const State& state, Resources& resources, const char* view,
    const std::shared_ptr<const ExactDistances>& exact = nullptr)
{
    State plain = state;
    plain.parameters.background = Backdrop::Transparent;
    const Image image = *drawPicture(renderer, plain, 0, resources, view, 320, 240, 1, true, exact);
    double sum = 0., pixels = 0.;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (image.value(x, y, 3) > 0.5f)
                sum += double(std::abs(image.value(x, y, 0))), pixels += 1.;
    EXPECT_GT(pixels, 5000.) << view;
    return sum / std::max(pixels, 1.);
}
} // namespace

// Against the displaced mesh: what silhouettes and frames get wrong, not the search alone.
TEST(ErrorView, MeasuresAgainstTheDisplacedMesh)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("torus");
    Resources resources = resourcesOf(state);
    std::shared_ptr<const ExactDistances> exact;
    const auto mean = [&](Silhouettes silhouettes) {
        state.parameters.silhouettes = silhouettes;
        return meanOf(renderer, state, resources, "error-mesh", exact);
    };
    EXPECT_LT(mean(Silhouettes::Off), 0.001); // cell-cone's search alone
    Warnings coarse;
    const auto traced = exactDistances(state, 0, resources, 320, 240, coarse);
    ASSERT_TRUE(traced);
    exact = *traced;
    const double none = mean(Silhouettes::Off), quadric = mean(Silhouettes::Quadric), prisms = mean(Silhouettes::Prisms);
    EXPECT_GT(none, 0.05);
    EXPECT_LT(quadric, 0.6 * none);
    EXPECT_LT(prisms, 0.02);
    state.camera.yaw += 1.f; // the answer is another picture's: not used
    EXPECT_LT(mean(Silhouettes::Off), 0.001);
}

// Against the exact search along the same ray: techniques can be ranked on any mesh, whatever bends the ray.
TEST(ErrorView, RanksSearchesOnCurvedMeshes)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    for (const Silhouettes silhouettes : {Silhouettes::Off, Silhouettes::Quadric, Silhouettes::Prisms}) {
        State state = stateOn("torus");
        Parameters& p = state.parameters;
        p.silhouettes = silhouettes, p.refineSteps = 0;
        Resources resources = resourcesOf(state);
        Renderer renderer;
        const auto mean = [&](const char* technique, int steps) {
            p.minSteps = p.maxSteps = steps;
            state.panes = {Pane{technique, {}}};
            return meanOf(renderer, state, resources, "error");
        };
        const double exact = mean("cell-cone", 8), fine = mean("relief", 128), coarse = mean("relief", 6);
        EXPECT_LT(exact, 0.0005) << wordOf(silhouettes);
        EXPECT_LT(exact, fine) << wordOf(silhouettes);
        EXPECT_LT(3. * fine, coarse) << wordOf(silhouettes);
        EXPECT_GT(coarse, 0.02) << wordOf(silhouettes);
    }
}

// What a search misses is an error, not a hole that is passed over.
TEST(ErrorView, ShowsWhatASearchMisses)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    for (const Silhouettes silhouettes : {Silhouettes::Quadric, Silhouettes::Prisms}) {
        State state = stateOn("sphere", "steep");
        Parameters& p = state.parameters;
        p.silhouettes = silhouettes, p.minSteps = p.maxSteps = 2, p.depth = 0.15f, p.heightMips = false,
        p.background = Backdrop::Transparent;
        Resources resources = resourcesOf(state);
        Renderer renderer;
        const Image seen = picture(renderer, state, resources, "position"), error = picture(renderer, state, resources, "error");
        int missed = 0, shown = 0;
        for (int y = 0; y < seen.height; ++y)
            for (int x = 0; x < seen.width; ++x)
                if (seen.value(x, y, 3) < 0.5f && error.value(x, y, 3) > 0.5f)
                    ++missed, shown += error.value(x, y, 0) > 0.99f;
        EXPECT_GT(missed, silhouettes == Silhouettes::Prisms ? 2 : 20) << wordOf(silhouettes);
        EXPECT_EQ(shown, missed) << wordOf(silhouettes);
    }
}

// The numbers beside the fetches are those of the picture; where the displaced mesh cannot tell, none count.
TEST(ErrorView, IsSummedUp)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("torus", "relief");
    Parameters& p = state.parameters;
    p.silhouettes = Silhouettes::Prisms, p.minSteps = p.maxSteps = 6, p.background = Backdrop::Transparent;
    setView(state, "error");
    Resources resources = resourcesOf(state);
    const auto numbersOf = [&](const std::shared_ptr<const ExactDistances>& exact) {
        DrawRequest request(state, 0, resources, {.width = 320, .height = 240});
        request.compareWith(exact);
        const auto numbers = renderer.measureView(request);
        return numbers ? numbers->error : ErrorNumbers{-1., -1., -1.};
    };
    const Image image = picture(renderer, state, resources, "error", 320, 240);
    double squares = 0., wrong = 0., pixels = 0.;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (image.value(x, y, 3) > 0.5f) {
                const double off = double(image.value(x, y, 0));
                squares += off * off, wrong += off > knownView("error").wrongFrom, pixels += 1.;
            }
    const ErrorNumbers search = numbersOf(nullptr);
    EXPECT_NEAR(search.rmse, std::sqrt(squares / pixels), 1e-5);
    EXPECT_NEAR(search.wrong, wrong / pixels, 1e-5);
    EXPECT_EQ(search.uncertain, 0.);
    setView(state, "error-mesh");
    Warnings coarse;
    const auto traced = *sureDistances(state, 0, resources, 320, 240, coarse);
    ASSERT_EQ(traced->pixels.uncertain.size(), traced->pixels.metres.size());
    const ErrorNumbers sure = numbersOf(traced);
    EXPECT_GT(sure.rmse, 0.005);
    EXPECT_LT(sure.uncertain, 0.1);
    auto doubtful = std::make_shared<ExactDistances>(*traced);
    std::ranges::fill(doubtful->pixels.uncertain, INFINITY);
    EXPECT_GT(numbersOf(doubtful).uncertain, 0.95);
    EXPECT_EQ(numbersOf(doubtful).rmse, 0.);
}

// A mesh too large to be cut as finely as wanted says so pixel by pixel.
TEST(ErrorView, ADisplacedMeshThatIsTooCoarseIsNotSure)
{
    State state = stateOn("torus", "relief");
    state.parameters.tiling = 64.f, state.parameters.depth = 0.5f;
    const Resources resources = resourcesOf(state);
    Warnings coarse;
    const auto traced = sureDistances(state, 0, resources, 1600, 1200, coarse);
    ASSERT_TRUE(traced);
    EXPECT_FALSE(coarse.empty());
    const float depth = physicalDepth(state.parameters, resources.mesh->metresPerUV);
    const auto& uncertain = (*traced)->pixels.uncertain;
    EXPECT_GT(std::ranges::count_if(uncertain, [&](float off) { return off > 0.01f * depth; }), 10000);
}

TEST(ObjectShadows, SpheresShadeThePlane)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("spheres");
    state.parameters.shadows = false;
    state.parameters.lightPitch = 30.f;
    Resources resources = resourcesOf(state);
    const auto dark = [&] {
        const Image image = picture(renderer, state, resources, "shadow");
        double count = 0.;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                count += image.value(x, y, 3) > 0.5f && image.value(x, y, 0) < 0.5f;
        return count / (double(image.width) * image.height);
    };
    EXPECT_EQ(dark(), 0.);
    state.parameters.objectShadows = true;
    EXPECT_GT(dark(), 0.02);
    state.parameters.lightPitch = 89.f; // from above the shadows lie under the spheres
    EXPECT_LT(dark(), 0.02);
}

// A plane alone shades nothing but itself: no acne from the map.
TEST(ObjectShadows, NoAcneOnAReliefAlone)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    for (const char* mesh : {"plane", "sphere"}) {
        State state = stateOn(mesh);
        state.parameters.shadows = true;
        Resources resources = resourcesOf(state);
        const Image alone = picture(renderer, state, resources, "shadow");
        state.parameters.objectShadows = true;
        // On the sphere what the search cannot see lies in shadow by the map: the far side of the terminator's stones.
        EXPECT_LT(differing(picture(renderer, state, resources, "shadow"), alone, 0.3f), mesh == std::string("plane") ? 0.03 : 0.1) << mesh;
    }
}

// The map is kept while nothing that it shows changes, and no longer.
TEST(ObjectShadows, FollowWhatMovesAndTheLight)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("character");
    state.parameters.objectShadows = true;
    Resources resources = resourcesOf(state);
    const auto fresh = [&] {
        Renderer other;
        return picture(other, state, resources, "shadow");
    };
    for (const auto& change : std::initializer_list<void (*)(State&)>{[](State&) {}, [](State& s) { s.parameters.time = 0.5f; },
             [](State& s) { s.camera.yaw = 100.f; }, [](State& s) { s.parameters.lightYaw = 40.f; },
             [](State& s) { s.panes.front().technique = "flat"; }, [](State& s) { s.parameters.depth = 0.2f; }}) {
        change(state);
        EXPECT_LT(differing(picture(renderer, state, resources, "shadow"), fresh(), 0.01f), 1e-6);
    }
}

// A part that the mesh does not have chooses none.
TEST(Parts, OnlyTheChosenOneShowsRelief)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("plane");
    Resources resources = resourcesOf(state);
    const Image all = picture(renderer, state, resources, "depth");
    const auto deepest = [](const Image& image) {
        float depth = 0.f;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                depth = std::max(depth, image.value(x, y, 0));
        return depth;
    };
    EXPECT_GT(deepest(all), 0.5f);
    state.part = "of another mesh";
    EXPECT_EQ(differing(picture(renderer, state, resources, "depth"), all, 0.f), 0.);
    Resources two = resources;
    Mesh mesh = *resources.mesh;
    mesh.parts.push_back({"other", "other", std::uint32_t(mesh.indices.size()), 0});
    two.mesh = std::make_shared<Mesh>(std::move(mesh));
    state.part = "other";
    EXPECT_EQ(deepest(picture(renderer, state, two, "depth")), 0.f);
    EXPECT_EQ(deepest(picture(renderer, state, two, "error")), 0.f);
}

// A mesh that brings a colour map is a material; without heights it is not shown as relief.
TEST(Parts, AMeshFileWithTexturesIsASource)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    std::string name = (fs::temp_directory_path() / "relievo-mesh-source-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    const fs::path folder = name;
    Image red{2, 2, 3, PixelType::U8, 8, false, std::vector<std::byte>(12)};
    for (std::size_t i = 0; i < 12; i += 3)
        red.data[i] = std::byte(255);
    ASSERT_TRUE(writeImage(folder / "red.png", red, true));
    std::ofstream(folder / "m.mtl") << "newmtl paint\nmap_Kd red.png\n";
    std::ofstream(folder / "m.obj") << "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl paint\nf 1/1 2/2 3/3\n";
    const auto opened = openSource((folder / "m.obj").string(), State());
    ASSERT_TRUE(opened) << message(opened.error());
    EXPECT_EQ(opened->state.panes.front().technique, "bump");
    auto resources = loadResources(opened->state, opened->images, {});
    ASSERT_TRUE(resources);
    State state = opened->state;
    state.camera.yaw = state.camera.pitch = 0.f;
    const Image color = picture(renderer, state, *resources, "color");
    EXPECT_GT(color.value(color.width / 2 - 10, color.height / 2 + 10, 0), 0.9f);
    EXPECT_LT(color.value(color.width / 2 - 10, color.height / 2 + 10, 1), 0.1f);
    fs::remove_all(folder);
}

// On a plane the derivatives are exact; where u and v are skewed the thesis' unit vectors slide.
// With more triangles than pixels both sides are drawn at once; the nearer one shows all the same, here on a box without its first
// triangles.
TEST(FineMeshes, LookAsCoarseOnes)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    const State state = stateOn("box");
    Resources resources = resourcesOf(state);
    Mesh open = *resources.mesh;
    open.indices.erase(open.indices.begin(), open.indices.begin() + 6);
    open.parts = {{"box", "", 0, std::uint32_t(open.indices.size()), 1.f}};
    const Mesh fine = finer(open, 160 * 120);
    const auto drawn = [&](const Mesh& mesh) {
        Renderer renderer;
        resources.mesh = std::make_shared<const Mesh>(mesh);
        return picture(renderer, state, resources, "position");
    };
    EXPECT_LT(differing(drawn(fine), drawn(open), 1e-3f), 0.01);
    EXPECT_GT(differing(drawn(*resourcesOf(state).mesh), drawn(open), 1e-3f), 0.1); // the inside is seen
}

// While the eye moves a mesh of more triangles than pixels is drawn with fewer: almost the same picture.
TEST(FineMeshes, PassingPicturesAreAlmostTheSame)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    constexpr int kWidth = 80, kHeight = 60;
    State state = stateOn("sphere", "flat");
    state.parameters.background = Backdrop::Transparent;
    Resources resources = resourcesOf(state);
    resources.mesh = std::make_shared<const Mesh>(finer(*resources.mesh, 200000));
    Renderer renderer;
    const auto drawn = [&](bool passing) {
        Framebuffer framebuffer;
        framebuffer.resize(kWidth, kHeight, true);
        const auto done = renderer.draw({state, 0, resources,
            {.framebuffer = framebuffer.handle(), .width = kWidth, .height = kHeight, .linear = true, .isPassing = passing}, "position"});
        EXPECT_TRUE(done);
        std::vector<glm::vec4> pixels(kWidth * kHeight);
        glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_FLOAT, pixels.data());
        return pixels;
    };
    const std::vector<glm::vec4> whole = drawn(false), passing = drawn(true);
    EXPECT_FALSE(whole == passing);
    int off = 0, covered = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        covered += whole[i].w > 0.5f;
        off += (whole[i].w > 0.5f) != (passing[i].w > 0.5f) || (whole[i].w > 0.5f && glm::distance(whole[i], passing[i]) > 0.02f);
    }
    EXPECT_GT(covered, 500);
    EXPECT_LT(off, covered / 25);
}
