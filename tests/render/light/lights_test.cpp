// Up to four lights, far or near: what arrives of them, and what hides them, against rays and formulas of the test's own.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.h"
#include "core/state/camera_view.h"
#include "core/state/lights.h"
#include "core/state/techniques.h"
#include "core/trace/displaced_mesh.h"
#include "core/trace/reference.h"
#include "tests/render/mesh_support.h"
#include <array>
#include <cstring>
#include <glm/glm.hpp>

using namespace relievo;
using namespace relievo::test;

namespace {
constexpr int kWidth = 160, kHeight = 120;
constexpr std::array kLit = {LightKind::Directional, LightKind::Point, LightKind::Spot};

void setLight(Parameters& p, std::size_t number, LightKind kind, float yaw, float pitch, float distance)
{
    const LightMembers& light = kLights[number];
    p.*light.kind = kind, p.*light.yaw = yaw, p.*light.pitch = pitch, p.*light.distance = distance;
}

// What the plane's pixels see.
class PlaneView {
public:
    PlaneView(const State& state, const Resources& resources)
        : m_camera(cameraView(state.camera, resources.mesh->boundsMin, resources.mesh->boundsMax, float(kWidth) / kHeight))
        , m_forward(glm::normalize(glm::dvec3(m_camera.target) - glm::dvec3(m_camera.eye)))
        , m_tangent(std::tan(double(state.camera.fov) * 3.14159265358979 / 360.))
    {
    }
    // Where the pixel's ray meets the plane y = 0, and its way.
    std::pair<glm::dvec3, glm::dvec3> top(int x, int y) const
    {
        const double px = (2. * (x + 0.5) / kWidth - 1.) * m_tangent * kWidth / kHeight, py = (1. - 2. * (y + 0.5) / kHeight) * m_tangent;
        const glm::dvec3 way = glm::normalize(m_forward + px * glm::dvec3(m_camera.right) + py * glm::dvec3(m_camera.up));
        return {glm::dvec3(m_camera.eye) - way * (double(m_camera.eye.y) / way.y), way};
    }

private:
    CameraView m_camera;
    glm::dvec3 m_forward;
    double m_tangent;
};

void addColors(Image& sum, const Image& image)
{
    ASSERT_EQ(sum.type, PixelType::F32);
    ASSERT_EQ(sum.data.size(), image.data.size());
    for (std::size_t i = 0; i < sum.data.size() / sizeof(float); ++i) {
        const int texel = int(i) / sum.channels, channel = int(i) % sum.channels, x = texel % sum.width, y = texel / sum.width;
        const float value = channel < 3 ? sum.value(x, y, channel) + image.value(x, y, channel) : sum.value(x, y, channel);
        std::memcpy(sum.data.data() + i * sizeof value, &value, sizeof value);
    }
}

// A matt white plane without surroundings.
State mattPlane()
{
    State state = stateOn("plane", "flat");
    Parameters& p = state.parameters;
    p.shading = Shading::BlinnPhong, p.specular = 0.f, p.environmentIntensity = 0.f, p.lightColor = glm::vec3(1.f), p.shadows = false;
    state.slots = {};
    state.camera.pitch = 70.f, state.camera.distance = 1.2f, state.camera.target = glm::vec3(0.f);
    return state;
}

// Shares of pixels: wrongly lit or dark, of those that should be in shadow and in light.
struct Wrong {
    int wrong = 0, hidden = 0, lit = 0;
};
Wrong againstRays(Renderer& renderer, const State& state, const Resources& resources, const LightMembers& light)
{
    const Parameters& p = state.parameters;
    const Image shadow = picture(renderer, state, resources, "shadow", kWidth, kHeight);
    const HeightField& field = *resources.material->height;
    const PlaneView view(state, resources);
    const double depth = double(p.depth);
    const glm::dvec3 towards(directionTo(p, light)), place = towards * double(p.*light.distance) * std::sqrt(0.5);
    const double edge = std::cos(0.5 * double(p.*light.cone) * 3.14159265358979 / 180.);
    Wrong counted;
    for (int i = 0; i < kWidth * kHeight; ++i) {
        const auto [top, way] = view.top(i % kWidth, i / kWidth);
        const SearchHit seen = exactHit(field, {{top.x + 0.5, top.z + 0.5}, glm::dvec2(way.x, way.z) * (depth / -way.y)});
        const glm::dvec3 point(seen.uv.x - 0.5, -seen.t * depth, seen.uv.y - 0.5);
        const glm::dvec3 toLight = isNear(p, light) ? glm::normalize(place - point) : towards;
        const double cosine = glm::dot(toLight, towards);
        if (p.*light.kind == LightKind::Spot && std::abs(cosine - edge) < 1e-3)
            continue;
        const glm::dvec2 shift = glm::dvec2(toLight.x, toLight.z) * (depth / toLight.y); // over the whole depth
        const bool outside = p.*light.kind == LightKind::Spot && cosine < edge;
        const bool hidden = outside || exactHit(field, {seen.uv + shift * seen.t, -shift}).t < seen.t - 1e-4;
        ++(hidden ? counted.hidden : counted.lit);
        counted.wrong += hidden != (shadow.value(i % kWidth, i / kWidth, 0) < 0.5f);
    }
    return counted;
}
} // namespace

// Each light of each kind, by every exact technique, alone.
TEST(Lights, ShadowsAreThoseOfRaysToEachLight)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    for (const TechniqueRow& row : kTechniques) {
        if (!row.isExact || row.file.empty() || row.isEngine())
            continue;
        for (const char* source : {"hard:ridges@32", "sample:cobblestones@128"})
            for (std::size_t number = 0; number < kLights.size(); ++number)
                for (const LightKind kind : kLit) {
                    State state = openSource(source, State())->state;
                    state.panes = {Pane{std::string(row.key), {}}};
                    state.camera.pitch = 50.f, state.camera.distance = 0.55f, state.camera.target = glm::vec3(0.05f, 0.f, 0.08f);
                    Parameters& p = state.parameters;
                    p.depth = 0.1f, p.heightMips = false, p.lightKind = LightKind::Off;
                    setLight(p, number, kind, 70.f, 30.f, 0.8f);
                    p.*kLights[number].cone = 50.f, p.*kLights[number].softness = 0.f;
                    const Wrong counted = againstRays(renderer, state, resourcesOf(state), kLights[number]);
                    const double all = counted.hidden + counted.lit;
                    EXPECT_GT(counted.hidden, 1000) << source << row.key << number << wordOf(kind);
                    EXPECT_GT(counted.lit, 1000) << source << row.key << number << wordOf(kind);
                    EXPECT_LT(counted.wrong / all, 0.005) << source << row.key << number << wordOf(kind);
                }
    }
}

// On a mesh as it is, from prism to prism.
TEST(Lights, APointLightIsHiddenByWhatStandsBeforeItOnAMesh)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    State state = stateOn("sphere");
    Parameters& p = state.parameters;
    p.silhouettes = Silhouettes::Prisms, p.depth = 0.04f, p.heightMips = false, p.lightKind = LightKind::Off;
    setLight(p, 1, LightKind::Point, 60.f, 30.f, 1.6f);
    const Resources resources = resourcesOf(state);
    p.tiling = 4.f * resources.mesh->metresPerUV;
    const CameraView camera = cameraView(state.camera, resources.mesh->boundsMin, resources.mesh->boundsMax, float(kWidth) / kHeight);
    const auto surface = DisplacedMesh::build(
        *resources.mesh, *resources.material->height, p, DisplacedMesh::detailFor(*resources.mesh, camera, state.camera.fov, kHeight));
    ASSERT_TRUE(surface);
    const Around mesh = around(resources.mesh->boundsMin, resources.mesh->boundsMax);
    const glm::vec3 light = mesh.middle + directionTo(p, kLights[1]) * distanceOf(p, kLights[1], mesh);
    const float depth = physicalDepth(p, resources.mesh->metresPerUV);
    Renderer renderer;
    const Image position = picture(renderer, state, resources, "position", kWidth, kHeight);
    const Image shadow = picture(renderer, state, resources, "shadow", kWidth, kHeight);
    const auto isHidden = [&](glm::vec3 point, float off) { // the light sees something nearer
        const glm::vec3 way = point - light;
        return surface->hit(light, glm::normalize(way)).distance < glm::length(way) - off * depth;
    };
    const glm::vec3 aside = glm::normalize(glm::cross(light - mesh.middle, glm::vec3(0.f, 1.f, 0.f)));
    const glm::vec3 up = glm::normalize(glm::cross(aside, light - mesh.middle));
    const auto isEdge = [&](glm::vec3 point, bool truth) { // of a shadow
        for (const glm::vec3 way : {aside, -aside, up, -up})
            if (isHidden(point + way * (0.05f * depth), 0.15f) != truth)
                return true;
        return isHidden(point, 0.15f) != truth;
    };
    int compared = 0, wrong = 0, dark = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const glm::vec3 point(position.value(x, y, 0), position.value(x, y, 1), position.value(x, y, 2));
            if (position.value(x, y, 3) < 0.5f)
                continue;
            const float far = glm::distance(camera.eye, point);
            const float off = std::abs(surface->hit(camera.eye, (point - camera.eye) / far).distance - far);
            const bool truth = isHidden(point, 0.02f);
            if (off > 0.02f * depth || isEdge(point, truth))
                continue; // on the reference's own triangles, or at the edge of a shadow
            ++compared;
            dark += truth;
            wrong += truth != (shadow.value(x, y, 0) < 0.5f);
        }
    EXPECT_GT(compared, 1500);
    EXPECT_GT(dark, 0.1 * compared);
    EXPECT_LT(double(wrong) / compared, 0.01) << wrong << " of " << compared;
}

TEST(Lights, WhatArrivesFollowsDistanceAngleAndCone)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = mattPlane();
    const Resources resources = resourcesOf(state);
    const PlaneView view(state, resources);
    for (const LightKind kind : kLit) {
        Parameters& p = state.parameters;
        setLight(p, 0, kind, 20.f, 55.f, 0.9f);
        p.lightIntensity = 0.8f, p.lightCone = 60.f, p.lightSoftness = 0.5f;
        const Image image = picture(renderer, state, resources, "shaded", kWidth, kHeight);
        const glm::dvec3 towards(directionTo(p, kLights[0]));
        const double distance = 0.9 * std::sqrt(0.5), outer = std::cos(glm::radians(30.)), inner = std::cos(glm::radians(15.));
        double most = 0.;
        for (int y = 20; y < kHeight - 20; ++y)
            for (int x = 20; x < kWidth - 20; ++x) {
                const glm::dvec3 way = towards * distance - view.top(x, y).first;
                double expected = 0.8 * towards.y;
                if (kind != LightKind::Directional)
                    expected = 0.8 * distance * distance / glm::dot(way, way) * way.y / glm::length(way);
                if (kind == LightKind::Spot)
                    expected *= glm::smoothstep(outer, inner, glm::dot(glm::normalize(way), towards));
                most = std::max(most, std::abs(double(image.value(x, y, 0)) - double(kColorWithoutMap) * expected));
            }
        EXPECT_LT(most, 0.004) << wordOf(kind);
    }
}

// One directional light is drawn by a shorter text, to the same picture; and several add up, each with its shadows.
TEST(Lights, AddUpAndOneIsNoOtherThanTheFirst)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    for (const float size : {0.f, 3.f}) {
        State state = stateOn("plane");
        Parameters& p = state.parameters;
        p.environmentIntensity = 0.f, p.heightMips = false, p.lightSize = size, p.lightPitch = 25.f;
        const Resources resources = resourcesOf(state);
        const Image one = picture(renderer, state, resources, "shaded");
        const Image shadowOfOne = picture(renderer, state, resources, "shadow");
        State second = state; // stands in for the first
        setLight(second.parameters, 2, LightKind::Directional, p.lightYaw, p.lightPitch, 1.f);
        second.parameters.light3Intensity = p.lightIntensity, second.parameters.light3Color = p.lightColor,
        second.parameters.light3Size = size;
        second.parameters.lightKind = LightKind::Off;
        EXPECT_LT(differing(one, picture(renderer, second, resources, "shaded"), 1e-3f), 0.002) << size;
        EXPECT_LT(differing(shadowOfOne, picture(renderer, second, resources, "shadow"), 1e-3f), 0.002) << size;

        Image sum = one;
        State all = state;
        for (std::size_t number = 1; number < kLights.size(); ++number) {
            State alone = state;
            for (State* each : {&alone, &all})
                setLight(each->parameters, number, kLit[number - 1], 70.f * float(number), 30.f, 1.5f);
            alone.parameters.lightKind = LightKind::Off;
            const Image image = picture(renderer, alone, resources, "shaded");
            addColors(sum, image);
        }
        EXPECT_LT(differing(sum, picture(renderer, all, resources, "shaded"), 2e-3f), 0.002) << size;
    }
}

// Within the mesh, behind its surface, without a size, at no distance: pictures stay finite.
TEST(Lights, NoPlaceOfALightMakesAPictureInvalid)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    for (const char* mesh : {"sphere", "plane", "character"})
        for (const Shading shading : {Shading::MetallicRoughness, Shading::BlinnPhong})
            for (const float distance : {0.01f, 0.5f, 1.f, 20.f})
                for (const float size : {0.f, 20.f}) {
                    State state = stateOn(mesh);
                    Parameters& p = state.parameters;
                    p.shading = shading, p.lightIntensity = 20.f;
                    setLight(p, 0, LightKind::Point, 0.f, 90.f, distance);
                    setLight(p, 1, LightKind::Spot, 180.f, -90.f, distance);
                    setLight(p, 2, LightKind::Point, -90.f, 0.f, distance);
                    setLight(p, 3, LightKind::Spot, 30.f, 0.f, distance);
                    for (const LightMembers& light : kLights)
                        p.*light.size = size, p.*light.softness = size > 0.f ? 1.f : 0.f, p.*light.cone = size > 0.f ? 170.f : 1.f;
                    const Resources resources = resourcesOf(state);
                    const Image invalid = picture(renderer, state, resources, "invalid"),
                                lit = picture(renderer, state, resources, "shaded");
                    for (int i = 0; i < lit.width * lit.height; ++i) {
                        ASSERT_EQ(invalid.value(i % lit.width, i / lit.width, 0), 0.f) << mesh << distance;
                        ASSERT_TRUE(std::isfinite(lit.value(i % lit.width, i / lit.width, 1))) << mesh << distance;
                    }
                }
}

// The lights turn with one value, as their directions would.
TEST(Lights, TurnTogether)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("sphere");
    setLight(state.parameters, 1, LightKind::Point, 170.f, 20.f, 2.f);
    State turned = state;
    turned.parameters.lightTurn = 40.f;
    State directed = state;
    directed.parameters.lightYaw += 40.f, directed.parameters.light2Yaw = -150.f;
    const Resources resources = resourcesOf(state);
    const Image first = picture(renderer, turned, resources, "shaded");
    EXPECT_LT(differing(first, picture(renderer, directed, resources, "shaded"), 1e-3f), 0.002);
    EXPECT_GT(differing(first, picture(renderer, state, resources, "shaded"), 1e-2f), 0.1);
}
