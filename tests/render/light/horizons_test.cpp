// Shadows and light of the surroundings by the map of horizons, in pictures: against searched shadows, and what they must never do.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/render/mesh_support.h"

using namespace relievo;
using namespace relievo::test;

namespace {
class Horizons : public ::testing::Test {
protected:
    void SetUp() override
    {
        auto made = WindowlessContext::create();
        ASSERT_TRUE(made);
        m_context.emplace(std::move(*made));
        m_renderer.emplace();
    }
    Image drawn(const State& state, std::string_view view) { return picture(*m_renderer, state, resourcesOf(state), view); }
    Renderer& renderer() { return *m_renderer; }

private:
    std::optional<WindowlessContext> m_context;
    std::optional<Renderer> m_renderer;
};

State by(State state, ShadowSearch search, HorizonAzimuths azimuths = HorizonAzimuths::Sixteen)
{
    state.parameters.shadowSearch = search, state.parameters.horizonAzimuths = azimuths;
    return state;
}

// Smooth cobblestones, all of them searched at full resolution.
State cobblestones(const char* mesh)
{
    State state = stateOn(mesh);
    state.parameters.heightMips = false;
    return state;
}

State wavesFromNear()
{
    State state = openSource("hard:waves@128", State())->state;
    state.mesh = "plane", state.panes = {Pane{"cell-cone", {}}};
    state.camera.pitch = 60.f, state.camera.distance = 0.6f, state.camera.target = glm::vec3(0.05f, 0.f, 0.08f);
    Parameters& p = state.parameters;
    p.depth = 0.15f, p.heightMips = p.mipMapping = false;
    return state;
}

// On any turn and stretch of the texture: the map's azimuths are the texture's, not the mesh's.
TEST_F(Horizons, ShadowsAreNearlyThoseOfTheSearch)
{
    for (const float rotation : {0.f, 65.f})
        for (const LightKind second : {LightKind::Off, LightKind::Point})
            for (const float pitch : {15.f, 30.f}) {
                State state = wavesFromNear();
                Parameters& p = state.parameters;
                p.rotation = rotation, p.tiling = 1.5f, p.offsetU = 0.3f, p.lightPitch = pitch, p.light2Kind = second;
                const Image searched = drawn(state, "shadow");
                const double eight = differing(searched, drawn(by(state, ShadowSearch::Horizon, HorizonAzimuths::Eight), "shadow"), 0.4f),
                             sixteen = differing(searched, drawn(by(state, ShadowSearch::Horizon), "shadow"), 0.4f);
                p.shadows = false, p.light2Shadows = false;
                const double none = differing(searched, drawn(state, "shadow"), 0.4f);
                EXPECT_GT(none, 0.05) << rotation << ' ' << wordOf(second) << ' ' << pitch;
                EXPECT_LT(eight, 0.4 * none) << rotation << ' ' << wordOf(second) << ' ' << pitch;
                EXPECT_LT(sixteen, 0.25 * none) << rotation << ' ' << wordOf(second) << ' ' << pitch;
            }
}

TEST_F(Horizons, SoftShadowsAreNearlyThoseOfManySearches)
{
    State state = wavesFromNear();
    state.parameters.lightSize = 6.f, state.parameters.lightPitch = 25.f;
    Resources resources = resourcesOf(state);
    const auto smooth = [&](const State& of) { return *drawPicture(renderer(), of, 0, resources, "shadow", 160, 120, 16, true); };
    const Image searched = smooth(state), horizon = smooth(by(state, ShadowSearch::Horizon));
    double sum = 0.;
    int penumbra = 0;
    for (int i = 0; i < 160 * 120; ++i) {
        const float s = searched.value(i % 160, i / 160, 0), h = horizon.value(i % 160, i / 160, 0);
        sum += double(std::abs(s - h));
        penumbra += h > 0.1f && h < 0.9f;
    }
    EXPECT_LT(sum / (160 * 120), 0.05);
    EXPECT_GT(penumbra, 500);
}

TEST_F(Horizons, LevelHeightsChangeNothing)
{
    State state = openSource("hard:high@32", State()).value_or(Opened{}).state;
    ASSERT_FALSE(state.slots == MapSlots());
    state.mesh = "sphere", state.panes = {Pane{"relief", {}}};
    state.parameters.shadows = false;
    const Image plain = drawn(state, "shaded");
    for (const AmbientRelief ambient : {AmbientRelief::Occlusion, AmbientRelief::Bent}) {
        state.parameters.ambientRelief = ambient, state.parameters.specularOcclusion = true;
        EXPECT_EQ(differing(plain, drawn(state, "shaded"), 2e-3f), 0.) << wordOf(ambient);
    }
}

// In light that comes alike from everywhere the relief only darkens; where from it comes does not matter there. Deeper relief is darker.
TEST_F(Horizons, EvenLightIsOnlyTakenAway)
{
    State state = cobblestones("sphere");
    Parameters& p = state.parameters;
    state.environment = "grey", p.lightIntensity = 0.f, p.environmentIntensity = 1.f, p.aoStrength = 0.f, p.roughness = 0.3f;
    const auto brightness = [&](AmbientRelief ambient, bool specular, float depth) {
        p.ambientRelief = ambient, p.specularOcclusion = specular, p.depth = depth;
        return drawn(state, "shaded");
    };
    const Image off = brightness(AmbientRelief::Off, false, 0.1f), share = brightness(AmbientRelief::Occlusion, false, 0.1f),
                bent = brightness(AmbientRelief::Bent, false, 0.1f), whole = brightness(AmbientRelief::Bent, true, 0.1f);
    EXPECT_EQ(differing(share, bent, 4e-3f), 0.);
    double sums[3] = {};
    for (int i = 0; i < off.width * off.height; ++i) {
        const int x = i % off.width, y = i / off.width;
        const float a = off.value(x, y, 1), b = share.value(x, y, 1), c = whole.value(x, y, 1);
        ASSERT_LE(b, a + 1e-3f);
        ASSERT_LE(c, b + 1e-2f);
        sums[0] += double(a), sums[1] += double(b), sums[2] += double(c);
    }
    EXPECT_LT(sums[1], 0.95 * sums[0]);
    EXPECT_LT(sums[2], 0.99 * sums[1]);
    const Image shallow = brightness(AmbientRelief::Occlusion, false, 0.02f);
    double shallows = 0.;
    for (int i = 0; i < off.width * off.height; ++i)
        shallows += double(shallow.value(i % off.width, i / off.width, 1));
    EXPECT_GT(shallows, sums[1]) << "it follows the depth";
}

TEST_F(Horizons, LightFromOneSideComesFromThere)
{
    State state = cobblestones("plane");
    Parameters& p = state.parameters;
    state.environment = "sunset", p.lightIntensity = 0.f, p.environmentIntensity = 1.f;
    p.ambientRelief = AmbientRelief::Occlusion;
    const Image share = drawn(state, "shaded");
    p.ambientRelief = AmbientRelief::Bent;
    EXPECT_GT(differing(share, drawn(state, "shaded"), 0.02f), 0.05);
}

TEST_F(Horizons, EveryModelTechniqueAndMeshStaysValid)
{
    for (const char* mesh : {"sphere", "torus", "spheres"})
        for (const Shading shading : {Shading::MetallicRoughness, Shading::BlinnPhong, Shading::Thesis})
            for (const char* technique : {"bump", "relief", "pyramid"}) {
                State state = by(stateOn(mesh, technique), ShadowSearch::Horizon);
                Parameters& p = state.parameters;
                p.silhouettes = Silhouettes::Quadric, p.shading = shading, p.ambientRelief = AmbientRelief::Bent;
                p.specularOcclusion = true, p.sheen = 0.5f, p.clearcoat = 0.3f, p.lightSize = 3.f, p.light2Kind = LightKind::Spot;
                const Image invalid = drawn(state, "invalid");
                for (int i = 0; i < invalid.width * invalid.height; ++i)
                    ASSERT_LE(invalid.value(i % invalid.width, i / invalid.width, 0), 0.f) << mesh << technique << wordOf(shading);
            }
}

TEST_F(Horizons, AreUploadedOnlyWhenReadAndGoAgain)
{
    State state = cobblestones("plane");
    Resources resources = resourcesOf(by(state, ShadowSearch::Horizon));
    picture(renderer(), state, resources, "shaded");
    const int without = renderer().textureCount();
    picture(renderer(), by(state, ShadowSearch::Horizon), resources, "depth");
    EXPECT_EQ(renderer().textureCount(), without) << "unlit";
    picture(renderer(), by(state, ShadowSearch::Horizon), resources, "shaded");
    EXPECT_EQ(renderer().textureCount(), without + 1);
    resources = loadResources(state, {}, resources).value_or(resources);
    picture(renderer(), state, resources, "shaded");
    EXPECT_EQ(renderer().textureCount(), without);
}

} // namespace
