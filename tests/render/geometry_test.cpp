// The picture's geometry against a march in world space that shares no code with the shaders: what a pixel of the plane sees is where
// its ray, in metres, first goes under the height field; and its shadow is what stands between there and the light.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/source.h"
#include "core/state/camera_view.h"
#include "core/state/techniques.h"
#include "core/trace/reference.h"
#include "render/windowless.h"
#include <cmath>
#include <glm/glm.hpp>
#include <gtest/gtest.h>

using namespace relievo;

namespace {

// The material lying on the plane in world space, y up, the mesh at y = 0.
struct World {
    const HeightField field;
    const Parameters p;
    double depth() const { return double(p.depth) / double(p.tiling) * (p.metresPerUV > 0.f ? double(p.metresPerUV) : 1.); } // m
    double top() const { return (1. - double(p.midlevel)) * depth(); }

    // Height of the surface in metres over a point of the plane. Turned counter-clockwise as seen from above, u to +x and v to +z.
    double surface(double x, double z) const
    {
        const double angle = double(p.rotation) * 3.14159265358979 / 180., u = (x + 0.5) * double(p.tiling),
                     v = (z + 0.5) * double(p.tiling);
        const double c = std::cos(angle), s = std::sin(angle);
        const glm::dvec2 uv(c * u - s * v + double(p.offsetU), s * u + c * v + double(p.offsetV));
        return top() - (1. - double(field.at(glm::vec2(uv)))) * depth();
    }
    // First point at or under the surface on the way from `from` (at the top) down along `direction`.
    glm::dvec3 hit(glm::dvec3 from, glm::dvec3 direction) const
    {
        const glm::dvec3 whole = direction * (depth() / -direction.y);
        for (int i = 0; i <= 4000; ++i) {
            const glm::dvec3 point = from + whole * (double(i) / 4000.);
            if (point.y <= surface(point.x, point.z))
                return point;
        }
        return from + whole;
    }
    bool lit(glm::dvec3 point, glm::dvec3 light) const
    {
        for (int i = 1; i <= 2000; ++i) {
            const glm::dvec3 q = point + light * ((top() - point.y) / light.y * double(i) / 2000.);
            if (q.y - point.y > double(p.shadowBias) * depth() && q.y <= surface(q.x, q.z)) // the bias is of height, as its help says
                return false;
        }
        return true;
    }
};

struct Shares {
    double depthWrong, shadowWrong;
    int compared;
};

Shares compare(const State& state, int width, int height)
{
    auto resources = *loadResources(state, {}, {});
    const Parameters& p = state.parameters;
    const World world{resources.material->height->withWrap(p.wrap), p};
    Renderer renderer;
    const Image depth = *drawPicture(renderer, state, 0, resources, "depth", width, height, 1, true);
    const Image shadow = *drawPicture(renderer, state, 0, resources, "shadow", width, height, 1, true);
    const CameraView camera = cameraView(state.camera, resources.mesh->boundsMin, resources.mesh->boundsMax, float(width) / float(height));
    const double tangent = std::tan(double(state.camera.fov) * 3.14159265358979 / 360.), aspect = double(width) / height;
    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye)),
                     light(directionTo(p.lightYaw, p.lightPitch));
    Shares shares{0., 0., 0};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double px = (2. * (x + 0.5) / width - 1.) * tangent * aspect, py = (1. - 2. * (y + 0.5) / height) * tangent;
            const glm::dvec3 direction = glm::normalize(forward + px * glm::dvec3(camera.right) + py * glm::dvec3(camera.up));
            const glm::dvec3 from = glm::dvec3(camera.eye) + direction * ((world.top() - double(camera.eye.y)) / direction.y);
            if (direction.y >= 0. || std::max(std::abs(from.x), std::abs(from.z)) > 0.49)
                continue;
            const glm::dvec3 hit = world.hit(from, direction);
            ++shares.compared;
            shares.depthWrong += std::abs(double(depth.value(x, y, 0)) - (world.top() - hit.y) / world.depth()) > 0.02;
            shares.shadowWrong += (shadow.value(x, y, 0) > 0.5f) != world.lit(hit, light);
        }
    shares.depthWrong /= shares.compared, shares.shadowWrong /= shares.compared;
    return shares;
}

State plainState()
{
    State state = openSource("sample:cobblestones@128", State())->state;
    Parameters& p = state.parameters;
    p.depth = 0.1f, p.minSteps = p.maxSteps = 256, p.refineSteps = 10, p.heightMips = false, p.shadowBias = 0.03f;
    return state;
}

void expectRight(const char* name, const State& state)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    const Shares shares = compare(state, 72, 54);
    EXPECT_GT(shares.compared, 300) << name;
    EXPECT_LT(shares.depthWrong, 0.01) << name;
    EXPECT_LT(shares.shadowWrong, 0.03) << name; // edges of shadows
}

} // namespace

TEST(Geometry, PlainPlane)
{
    expectRight("plain", plainState());
}

TEST(Geometry, TurnedTiledAndShifted)
{
    State state = plainState();
    state.parameters.rotation = 30.f, state.parameters.tiling = 2.f, state.parameters.offsetU = 0.3f, state.parameters.offsetV = -0.2f;
    state.camera.yaw = 140.f;
    expectRight("turned", state);
}

TEST(Geometry, MidlevelPushesTheMeshOut)
{
    State state = plainState();
    state.parameters.midlevel = 0.5f;
    expectRight("midlevel", state);
}

TEST(Geometry, SizeOfAUVUnitDeepensTheRelief)
{
    State state = plainState();
    state.parameters.metresPerUV = 2.f;
    expectRight("metres", state);
}

TEST(Geometry, LowSunAndGrazingView)
{
    State state = plainState();
    state.camera.pitch = 14.f, state.camera.yaw = -60.f;
    state.parameters.lightPitch = 15.f, state.parameters.lightYaw = 75.f, state.parameters.depth = 0.05f;
    expectRight("grazing", state);
}

TEST(Geometry, ClampedBorders)
{
    State state = plainState();
    state.parameters.wrap = Wrap::Clamp;
    expectRight("clamped", state);
}

// So near that a texel spans fifty pixels: shadows of exact searches reach to what casts them, and no point shades itself.
TEST(Geometry, ExactShadowsMeetWhatCastsThem)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    constexpr int kWidth = 240, kHeight = 180;
    for (const char* source : {"hard:ridges@32", "hard:noise@32", "hard:checker@32", "sample:cobblestones@64"})
        for (const TechniqueRow& row : kTechniques) {
            if (!row.isExact || row.file.empty())
                continue;
            State state = openSource(source, State())->state;
            Parameters& p = state.parameters;
            p.depth = 0.1f, p.heightMips = false, p.lightPitch = 35.f, p.lightYaw = 70.f, p.shadows = true;
            state.panes = {Pane{std::string(row.key), {}}};
            state.camera.pitch = 60.f, state.camera.distance = 0.2f, state.camera.target = glm::vec3(0.05f, 0.f, 0.08f);
            auto resources = *loadResources(state, {}, {});
            Renderer renderer;
            const Image shadow = *drawPicture(renderer, state, 0, resources, "shadow", kWidth, kHeight, 1, true);
            const HeightField& field = *resources.material->height;
            const CameraView camera
                = cameraView(state.camera, resources.mesh->boundsMin, resources.mesh->boundsMax, float(kWidth) / float(kHeight));
            const double tangent = std::tan(double(state.camera.fov) * 3.14159265358979 / 360.), depth = double(p.depth);
            const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye)),
                             light(directionTo(p.lightYaw, p.lightPitch));
            const glm::dvec2 toLight = glm::dvec2(light.x, light.z) * (depth / light.y); // for the whole depth
            const double texel = 1. / field.width() / glm::length(toLight); // along the light, in t
            int hidden = 0, lit = 0, wrongHidden = 0, wrongLit = 0;
            for (int i = 0; i < kWidth * kHeight; ++i) {
                const double px = (2. * (i % kWidth + 0.5) / kWidth - 1.) * tangent * kWidth / kHeight;
                const double py = (1. - 2. * (i / kWidth + 0.5) / kHeight) * tangent;
                const glm::dvec3 way = glm::normalize(forward + px * glm::dvec3(camera.right) + py * glm::dvec3(camera.up));
                const glm::dvec3 top = glm::dvec3(camera.eye) - way * (double(camera.eye.y) / way.y);
                const SearchHit seen = exactHit(field, {{top.x + 0.5, top.z + 0.5}, glm::dvec2(way.x, way.z) * (depth / -way.y)});
                const SearchRay ray{seen.uv + toLight * seen.t, -toLight};
                const auto free = [&](double raise) { return (seen.t - exactHit(field, ray, raise).t) / texel; }; // texels before the point
                if (free(-1e-4) > 0.002) {
                    ++hidden;
                    wrongHidden += shadow.value(i % kWidth, i / kWidth, 0) > 0.5f;
                } else if (free(0.) < 1e-6 && free(1e-4) < 0.05) {
                    ++lit;
                    wrongLit += shadow.value(i % kWidth, i / kWidth, 0) < 0.5f;
                }
            }
            EXPECT_GT(hidden, 1000) << source << row.key;
            EXPECT_GT(lit, 1000) << source << row.key;
            EXPECT_EQ(wrongHidden, 0) << source << ' ' << row.key << " of " << hidden;
            EXPECT_EQ(wrongLit, 0) << source << ' ' << row.key << " of " << lit;
        }
}

// Smooth light shows no step where faces of the environment's cube meet.
TEST(Geometry, EnvironmentHasNoSeams)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    State state = plainState();
    state.mesh = "sphere";
    state.panes = {Pane{"flat", {}}};
    state.slots[std::size_t(MapKind::Color)] = {};
    state.slots[std::size_t(MapKind::Roughness)] = {};
    state.parameters.lightIntensity = 0.f;
    auto resources = *loadResources(state, {}, {});
    Renderer renderer;
    const Image image = *drawPicture(renderer, state, 0, resources, "shaded", 200, 200, 1, true);
    float step = 0.f;
    for (int y = 70; y < 130; ++y)
        for (int x = 70; x < 130; ++x)
            step = std::max({step, std::abs(image.value(x, y, 1) - image.value(x + 1, y, 1)),
                std::abs(image.value(x, y, 1) - image.value(x, y + 1, 1))});
    EXPECT_GT(image.value(100, 100, 1), 0.05f);
    EXPECT_LT(step, 0.03f * image.value(100, 100, 1));
}

// A hard edge must not open when the midlevel pushes the mesh out.
TEST(Geometry, PushedBoxStaysClosed)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    State state = plainState();
    state.mesh = "box";
    state.parameters.midlevel = 0.f;
    auto resources = *loadResources(state, {}, {});
    Renderer renderer;
    const Image image = *drawPicture(renderer, state, 0, resources, "depth", 160, 120, 1, true);
    for (int y = 0; y < 120; ++y) { // along each row the box is one run of covered pixels
        int runs = 0;
        for (int x = 1; x < 160; ++x)
            runs += image.value(x, y, 3) > 0.5f && image.value(x - 1, y, 3) < 0.5f;
        EXPECT_LE(runs, 1) << "row " << y;
    }
}
