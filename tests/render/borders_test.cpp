// Where relief ends on meshes with borders, against the displaced mesh.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/source.h"
#include "core/shader_text/program_text.h"
#include "core/shader_text/scene_uniforms.h"
#include "core/trace/displaced_mesh.h"
#include "render/measure/mesh_errors.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

using namespace relievo;

namespace {

State onMesh(const char* mesh)
{
    State state = openSource("sample:cobblestones@256", State())->state;
    state.mesh = mesh;
    state.parameters.depth = 0.08f, state.parameters.shadows = false, state.parameters.heightMips = false,
    state.parameters.background = Backdrop::Transparent;
    state.panes = {Pane{"cell-cone", {}}};
    return state;
}

// Pixels with relief where the displaced mesh has nothing, and those without where it has some.
struct Outline {
    int beyond = 0, missing = 0;
};

Outline outline(Renderer& renderer, const State& state, Resources resources, const ExactDistances& traced)
{
    const PixelDistances& exact = traced.pixels;
    const int width = exact.width;
    const Image image = *drawPicture(renderer, state, 0, resources, "position", width, exact.height, 1, true);
    Outline result;
    for (int i = 0; i < width * exact.height; ++i) {
        const bool covered = image.value(i % width, i / width, 3) > 0.5f, truth = std::isfinite(exact.metres[std::size_t(i)]);
        result.beyond += covered && !truth;
        result.missing += !covered && truth;
    }
    return result;
}

struct Sums {
    Outline flat, cut;
};

Sums overViews(const char* mesh)
{
    constexpr int kWidth = 240, kHeight = 180;
    constexpr float kViews[][2] = {{30.f, 35.f}, {120.f, 10.f}, {210.f, 20.f}, {300.f, 3.f}, {0.f, 60.f}};
    State state = onMesh(mesh);
    auto resources = *loadResources(state, {}, {});
    Renderer renderer;
    Sums sums;
    Warnings warnings;
    for (const auto& view : kViews) {
        state.camera.yaw = view[0], state.camera.pitch = view[1];
        const auto exact = exactDistances(state, 0, resources, kWidth, kHeight, warnings);
        EXPECT_TRUE(exact) << mesh;
        if (!exact)
            break;
        for (const Silhouettes silhouettes : {Silhouettes::Off, Silhouettes::Quadric}) {
            state.parameters.silhouettes = silhouettes;
            const Outline found = outline(renderer, state, resources, **exact);
            Outline& sum = silhouettes == Silhouettes::Off ? sums.flat : sums.cut;
            sum.beyond += found.beyond, sum.missing += found.missing;
        }
    }
    return sums;
}

} // namespace

TEST(Borders, ReliefEndsWhereTheDisplacedMeshDoes)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    for (const char* mesh : {"plane", "box", "cylinder"}) {
        const Sums sums = overViews(mesh);
        RecordProperty(mesh, std::to_string(sums.cut.beyond) + " of " + std::to_string(sums.flat.beyond));
        EXPECT_GT(sums.flat.beyond, 1000) << mesh;
        EXPECT_LE(sums.cut.beyond, sums.flat.beyond / 5) << mesh;
        if (std::string_view(mesh) != "plane") // whose front edge is seen through no polygon
            EXPECT_LE(sums.cut.beyond + sums.cut.missing, (sums.flat.beyond + sums.flat.missing) / 5) << mesh;
        else
            EXPECT_LE(sums.cut.missing, sums.flat.missing + sums.flat.beyond / 20) << mesh;
    }
}

// On coarse meshes, over seams of the texture, at hard edges and in a pose that the file does not store.
TEST(Prisms, FollowTheMesh)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    for (const char* mesh : {"torus", "box", "teapot", "character"}) {
        State state = onMesh(mesh);
        state.parameters.time = 0.4f, state.parameters.depth = 0.04f;
        auto resources = *loadResources(state, {}, {});
        const glm::vec3 size = resources.mesh->boundsMax - resources.mesh->boundsMin;
        state.parameters.tiling = 4.f * resources.mesh->metresPerUV / std::max({size.x, size.y, size.z});
        MeshRow none{}, quadric{}, prisms{};
        Warnings warnings;
        for (const float yaw : {30.f, 300.f}) {
            state.camera.yaw = yaw;
            const auto exact = exactDistances(state, 0, resources, 400, 300, warnings);
            ASSERT_TRUE(exact) << mesh;
            for (const auto& [kind, sum] :
                {std::pair{Silhouettes::Off, &none}, {Silhouettes::Quadric, &quadric}, {Silhouettes::Prisms, &prisms}}) {
                state.parameters.silhouettes = kind;
                const auto errors = meshErrors(renderer, state, resources, *exact);
                ASSERT_TRUE(errors) << mesh;
                sum->coverage += errors->coverage, sum->depthRmse += errors->depthRmse, sum->invalid += errors->invalid;
            }
        }
        EXPECT_LT(prisms.coverage, 0.2 * none.coverage) << mesh;
        EXPECT_LT(prisms.coverage, quadric.coverage + 1e-4) << mesh;
        EXPECT_LT(prisms.depthRmse, quadric.depthRmse + 0.01) << mesh;
        EXPECT_EQ(prisms.invalid, 0.) << mesh;
    }
}

// Relief whose tops are white touches the polygons everywhere; below them the walls between prisms show whether they are right.
TEST(Prisms, FollowReliefThatStaysBelowWhite)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    for (const char* mesh : {"torus", "teapot"}) {
        State state = onMesh(mesh);
        auto resources = *loadResources(state, {}, {});
        const glm::vec3 size = resources.mesh->boundsMax - resources.mesh->boundsMin;
        state.parameters.tiling = 4.f * resources.mesh->metresPerUV / std::max({size.x, size.y, size.z});
        const HeightField field = *resources.material->height;
        const auto errorsOf = [&](float scale, float shift) {
            std::vector<float> heights(field.texels().begin(), field.texels().end());
            for (float& h : heights)
                h = h * scale + shift;
            Material material = *resources.material;
            material.height = HeightField(field.width(), field.height(), std::move(heights), field.wrap(), field.storedBits());
            resources.material = std::make_shared<const Material>(std::move(material));
            Warnings coarse;
            return measurePrisms(renderer, state, resources, 240, 180, coarse).value_or(MeshRow{{}, 1., 1e9, 0., 0.});
        };
        const MeshRow white = errorsOf(1.f, 0.f), half = errorsOf(0.5f, 0.f), constant = errorsOf(0.f, 0.5f);
        for (const MeshRow& row : {half, constant}) {
            EXPECT_LE(row.coverage, std::max(2. * white.coverage, 0.001)) << mesh;
            EXPECT_LT(row.depthRmse, 3.) << mesh;
            EXPECT_EQ(row.invalid, 0.) << mesh;
        }
    }
}

// What pictures say of the light, and what lies between the light and the point on the displaced mesh.
TEST(Prisms, ShadowsAreThoseOfTheDisplacedMesh)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    constexpr int kWidth = 240, kHeight = 180;
    Renderer renderer;
    for (const char* mesh : {"sphere", "box", "cylinder"}) { // convex: what hides the light is relief
        State state = onMesh(mesh);
        Parameters& p = state.parameters;
        p.shadows = true, p.depth = 0.04f, p.lightPitch = 20.f;
        auto resources = *loadResources(state, {}, {});
        p.tiling = 4.f * resources.mesh->metresPerUV;
        const CameraView camera = cameraView(state.camera, resources.mesh->boundsMin, resources.mesh->boundsMax, float(kWidth) / kHeight);
        const glm::vec3 toLight = sceneUniforms(p, camera, resources.mesh->metresPerUV).lightDirection;
        const auto surface = DisplacedMesh::build(
            *resources.mesh, *resources.material->height, p, DisplacedMesh::detailFor(*resources.mesh, camera, state.camera.fov, kHeight));
        ASSERT_TRUE(surface) << mesh;
        const float depth = physicalDepth(p, resources.mesh->metresPerUV);
        const auto isHidden = [&](glm::vec3 point, float off) { // seen from the light
            return surface->hit(point + toLight * 4.f, -toLight).distance < 4.f - off * depth;
        };
        const glm::vec3 aside = glm::normalize(glm::cross(toLight, glm::vec3(0.f, 1.f, 0.f))), up = glm::cross(aside, toLight);
        const auto isEdge = [&](glm::vec3 point, bool truth) { // of a shadow
            for (const glm::vec3 way : {aside, -aside, up, -up})
                if (isHidden(point + way * (0.05f * depth), 0.15f) != truth)
                    return true;
            return isHidden(point, 0.15f) != truth;
        };
        PerChoice<Silhouettes, double> wrong;
        double sure = 0., hidden = 0.;
        for (const Silhouettes kind : {Silhouettes::Quadric, Silhouettes::Prisms}) {
            p.silhouettes = kind;
            const auto draw = [&](const char* view) { return *drawPicture(renderer, state, 0, resources, view, kWidth, kHeight, 1, true); };
            const Image position = draw("position"), shadow = draw("shadow");
            for (int i = 0; i < kWidth * kHeight; ++i) {
                const int x = i % kWidth, y = i / kWidth;
                if (position.value(x, y, 3) < 0.5f)
                    continue;
                const glm::vec3 point(position.value(x, y, 0), position.value(x, y, 1), position.value(x, y, 2));
                const glm::vec3 sight = glm::normalize(point - camera.eye);
                const float off = std::abs(surface->hit(camera.eye, sight).distance - glm::distance(camera.eye, point));
                const bool truth = isHidden(point, 0.02f);
                if (off > 0.02f * depth || isEdge(point, truth))
                    continue; // on the reference's own triangles, or at the edge of a shadow
                wrong[kind] += truth != (shadow.value(x, y, 0) < 0.5f);
                sure += kind == Silhouettes::Prisms, hidden += kind == Silhouettes::Prisms && truth;
            }
        }
        EXPECT_GT(hidden, 0.1 * sure) << mesh;
        EXPECT_LT(wrong[Silhouettes::Prisms], 0.01 * sure) << mesh;
        EXPECT_LE(wrong[Silhouettes::Prisms], wrong[Silhouettes::Quadric]) << mesh;
    }
}

// Relief ends where the material does, also for a ray that comes from inside.
TEST(Prisms, EndAtPlainParts)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    State state = onMesh("plane");
    state.parameters.silhouettes = Silhouettes::Prisms;
    state.camera.pitch = 10.f;
    auto resources = *loadResources(state, {}, {});
    Mesh halves = *resources.mesh;
    const std::uint32_t half = std::uint32_t(halves.indices.size() / 6 * 3);
    halves.parts = {{"near", "stone", 0, half, 1.f}, {"far", "glass", half, std::uint32_t(halves.indices.size()) - half, 1.f}};
    resources.mesh = std::make_shared<const Mesh>(halves);
    const auto cutOff = [&](const char* part) {
        state.part = part;
        Renderer renderer;
        const Image image = *drawPicture(renderer, state, 0, resources, "outline", 240, 180, 1, true);
        int count = 0;
        for (int i = 0; i < 240 * 180; ++i)
            count += image.value(i % 240, i / 240, 3) > 0.5f && image.value(i % 240, i / 240, 0) > 2.f * image.value(i % 240, i / 240, 1);
        return count;
    };
    EXPECT_GT(cutOff("stone") + cutOff("glass"), cutOff("") + 20);
}

// Nearly closed meshes are cut off as closed ones are: their inside does not show behind the front.
TEST(Borders, AHoleAtTheBackDoesNotFillTheOutline)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    State state = onMesh("sphere");
    state.camera.yaw = 0.f, state.camera.pitch = 20.f;
    state.parameters.silhouettes = Silhouettes::Quadric;
    auto resources = *loadResources(state, {}, {});
    const auto covered = [&] {
        Renderer renderer;
        const Image image = *drawPicture(renderer, state, 0, resources, "position", 240, 180, 1, true);
        int count = 0;
        for (int i = 0; i < 240 * 180; ++i)
            count += image.value(i % 240, i / 240, 3) > 0.5f;
        return count;
    };
    const int whole = covered();
    Mesh open = *resources.mesh;
    open.indices.resize(open.indices.size() - 3); // at the south pole
    resources.mesh = std::make_shared<const Mesh>(open);
    EXPECT_EQ(covered(), whole);
    state.parameters.silhouettes = Silhouettes::Off;
    EXPECT_GT(covered(), whole);
}

// A mesh without borders pays nothing for them.
TEST(Borders, OnlyMeshesWithBordersReadThem)
{
    ProgramFeatures features;
    features.technique = "cell-cone", features.maps = {MapKind::Height}, features.curved = true;
    EXPECT_FALSE(meshProgram(features, embeddedReader())->fragment.mentions("borderMap"));
    EXPECT_FALSE(meshProgram(features, embeddedReader())->fragment.mentions("prismMap"));
    features.borders = true;
    EXPECT_TRUE(meshProgram(features, embeddedReader())->fragment.mentions("borderMap"));
    features.prisms = true;
    EXPECT_TRUE(meshProgram(features, embeddedReader())->fragment.mentions("prismMap"));
    EXPECT_FALSE(meshProgram(features, embeddedReader())->fragment.mentions("borderMap"));
    features.curved = false;
    EXPECT_FALSE(meshProgram(features, embeddedReader())->fragment.mentions("borderMap"));
}
