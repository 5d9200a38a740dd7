// Stretched highlights in pictures: the same text on the GPU and on the CPU.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/lights.h"
#include "tests/render/mesh_support.h"
#include <glm/glm.hpp>

using namespace relievo;
using namespace relievo::test;

namespace {
namespace texts {
using namespace glm;
// A plane of which only the light matters, seen from above its middle; u is +x and v is +z there.
struct OnThePlane {
    struct Hit {
        vec2 uv{0.f};
    };
    struct Frame {
        vec3 normal{0.f, 1.f, 0.f}, gradU{1.f, 0.f, 0.f}, gradV{0.f, 0.f, 1.f};
    };
    struct Surface {
        Frame frame;
        Hit hit;
        vec3 toEye;
        float footprint = 0.f;
    };
    struct Sky { };
    vec3 tint;
    float roughness, metallic, ior, anisotropyStrength, anisotropyRotation;
    static float spreadRoughness(float rough, const Surface&) { return rough; }
    static vec3 reliefNormal(const Surface&) { return {0.f, 1.f, 0.f}; }
    static vec3 colorAt(vec2, float) { return vec3(kColorWithoutMap); }
    static float roughnessAt(vec2, float) { return 1.f; }
    static float metallicAt(vec2, float) { return 0.f; }
    static Sky skyOver(const Surface&, vec3) { return {}; }
    static vec3 skyLight(Sky) { return vec3(0.f); }
    static float reflectedShare(Sky, float, float) { return 1.f; }
    static vec3 reflection(vec3, float) { return vec3(0.f); }
#include "shaders/shading/metallic_roughness.glsl"
    vec3 lit(vec3 toEye, vec3 toLight)
    {
        const Surface surface{.frame = {}, .hit = {}, .toEye = toEye};
        return bodyReflected(surface, shadingPointOf(surface), toLight);
    }
#include "shaders/layers/stretch.glsl"
};
} // namespace texts
} // namespace

TEST(StretchGl, PicturesAreWhatTheTextSaysOnTheCpu)
{
    const auto context = WindowlessContext::create();
    ASSERT_TRUE(context);
    Renderer renderer;
    State state = stateOn("plane", "flat");
    state.slots = {};
    state.camera = {20.f, 60.f, 40.f, 1.2f, glm::vec3(0.f)};
    Parameters& p = state.parameters;
    p.environmentIntensity = 0.f, p.lightYaw = 200.f - 360.f, p.lightPitch = 55.f, p.roughness = 0.3f;
    const Resources resources = resourcesOf(state);
    const Image position = picture(renderer, state, resources, "position");
    const glm::vec3 eye = DrawRequest(state, 0, resources, {.width = 160, .height = 120}).camera().eye;
    double most = 0.;
    for (const float strength : {0.2f, 0.6f, 1.f})
        for (const float rotation : {-70.f, 0.f, 30.f}) {
            p.anisotropyStrength = strength, p.anisotropyRotation = rotation;
            const Image image = picture(renderer, state, resources, "shaded");
            texts::OnThePlane plane{p.tint, p.roughness, p.metallic, p.ior, strength, rotation};
            int compared = 0;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) {
                    if (position.value(x, y, 3) < 0.5f)
                        continue;
                    const glm::vec3 point(position.value(x, y, 0), position.value(x, y, 1), position.value(x, y, 2));
                    const glm::vec3 right
                        = plane.lit(glm::normalize(eye - point), directionTo(p, kLights.front())) * p.lightColor * p.lightIntensity;
                    ++compared;
                    for (int c = 0; c < 3; ++c) {
                        ASSERT_NEAR(image.value(x, y, c), right[c], 2e-3f * right[c] + 1e-5f) << x << ' ' << y << ' ' << rotation;
                        most = std::max(most, double(right[c]));
                    }
                }
            EXPECT_GT(compared, 2000);
        }
    EXPECT_GT(most, 0.5) << "no highlight is seen";
}
