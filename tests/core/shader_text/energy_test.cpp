// The shading texts, run on the CPU: what falls on a surface leaves it or is absorbed, and their fits against the integrals they stand for.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace {
using namespace glm;

// White light from all around on a white surface whose normal is +z.
struct WhiteFurnace {
    struct Hit {
        vec2 uv{0.f};
    };
    struct Surface {
        Hit hit;
        vec3 toEye;
        float footprint = 0.f;
    };
    struct Sky { };
    vec3 tint{1.f};
    float roughness = 1.f, metallic = 0.f, ior = 1.5f;
    static float spreadRoughness(float rough, const Surface&) { return rough; }
    static vec3 reliefNormal(const Surface&) { return {0.f, 0.f, 1.f}; }
    static vec3 colorAt(vec2, float) { return vec3(1.f); }
    static float roughnessAt(vec2, float) { return 1.f; }
    static float metallicAt(vec2, float) { return 1.f; }
    static Sky skyOver(const Surface&, vec3) { return {}; }
    static vec3 skyLight(Sky) { return vec3(1.f); }
    static float reflectedShare(Sky, float, float) { return 1.f; }
    static vec3 reflection(vec3, float) { return vec3(1.f); }
#include "shaders/shading/metallic_roughness.glsl"
};

vec3 leaning(float cosine, float yaw = 0.f)
{
    const float sine = std::sqrt(std::max(0.f, 1.f - cosine * cosine));
    return {sine * std::cos(yaw), sine * std::sin(yaw), cosine};
}

constexpr float kRoughnesses[] = {0.05f, 0.1f, 0.2f, 0.3f, 0.45f, 0.6f, 0.8f, 1.f};

// Share that GGX with height-correlated Smith reflects once of light from all around: of a Fresnel term of 1, and of (1 - v . h)^5. The sum
// over half vectors as they are seen (Heitz 2018, Sampling the GGX Distribution of Visible Normals), a lattice of 65536 of them.
dvec2 integrated(double nv, double roughness)
{
    const double alpha = roughness * roughness;
    const dvec3 v(std::sqrt(1. - nv * nv), 0., nv), stretched = normalize(dvec3(alpha * v.x, 0., v.z));
    const dvec3 side(0., 1., 0.), up = cross(stretched, side);
    const auto lambda = [alpha](double cosine) { return 0.5 * (std::sqrt(1. + alpha * alpha * (1. / (cosine * cosine) - 1.)) - 1.); };
    constexpr int kCount = 65536;
    dvec2 sum(0.);
    for (int i = 0; i < kCount; ++i) {
        const double radius = std::sqrt((i + 0.5) / kCount), turn = 2. * std::numbers::pi * std::fmod(i * 0.6180339887498949, 1.);
        const double a = radius * std::cos(turn), s = 0.5 * (1. + stretched.z);
        const double b = (1. - s) * std::sqrt(1. - a * a) + s * radius * std::sin(turn);
        const dvec3 n = a * side + b * up + std::sqrt(std::max(0., 1. - a * a - b * b)) * stretched;
        const dvec3 h = normalize(dvec3(alpha * n.x, alpha * n.y, std::max(n.z, 1e-9)));
        const double vh = dot(v, h), nl = 2. * vh * h.z - v.z;
        if (nl > 0.) {
            const double share = (1. + lambda(nv)) / (1. + lambda(nv) + lambda(nl));
            sum += share * dvec2(1., std::pow(1. - vh, 5.));
        }
    }
    return sum / double(kCount);
}
} // namespace

TEST(Energy, WhiteSurroundingsLeaveAWhiteSurfaceWhite)
{
    for (const float metallic : {0.f, 0.5f, 1.f})
        for (const float roughness : kRoughnesses)
            for (const float nv : {1.f, 0.7f, 0.4f, 0.1f, 0.01f}) {
                WhiteFurnace furnace;
                furnace.metallic = metallic, furnace.roughness = roughness;
                const auto point = furnace.shadingPointOf({.hit = {}, .toEye = leaning(nv)});
                EXPECT_NEAR(furnace.reflectedSurroundings(point).y, 1.f, 0.01f) << metallic << ' ' << roughness << ' ' << nv;
            }
}

// A thousand lights are surroundings.
TEST(Energy, LightsGiveWhatTheSameSurroundingsWould)
{
    for (const float metallic : {0.f, 1.f})
        for (const float roughness : {0.3f, 0.45f, 0.6f, 0.8f, 1.f})
            for (const float nv : {1.f, 0.7f, 0.4f}) {
                WhiteFurnace furnace;
                furnace.metallic = metallic, furnace.roughness = roughness;
                const auto point = furnace.shadingPointOf({.hit = {}, .toEye = leaning(nv)});
                constexpr int kRings = 400, kTurns = 800;
                double sum = 0.;
                for (int ring = 0; ring < kRings; ++ring)
                    for (int turn = 0; turn < kTurns; ++turn) {
                        const float yaw = 2.f * std::numbers::pi_v<float> * (float(turn) + 0.5f) / kTurns;
                        sum += double(furnace.reflected(point, leaning((float(ring) + 0.5f) / kRings, yaw)).y);
                    }
                EXPECT_NEAR(2. * sum / (kRings * kTurns), 1., 0.02) << metallic << ' ' << roughness << ' ' << nv;
            }
}

TEST(Energy, TheFitIsAsNearToTheIntegralsAsItSays)
{
    WhiteFurnace furnace;
    for (float roughness = 0.045f; roughness <= 1.f; roughness += 0.0597f)
        for (const float nv : {0.07f, 0.1f, 0.15f, 0.2f, 0.3f, 0.4f, 0.55f, 0.7f, 0.85f, 1.f}) {
            const dvec2 exact = integrated(double(nv), double(roughness));
            const vec2 fit = furnace.reflectedOnce(nv, roughness);
            EXPECT_NEAR(double(fit.x), exact.x, 0.0065) << roughness << ' ' << nv;
            EXPECT_NEAR(double(fit.y), exact.y, 0.01) << roughness << ' ' << nv;
        }
}

TEST(Energy, ABlackSurfaceReflectsNothingStrange)
{
    WhiteFurnace furnace;
    furnace.metallic = 1.f, furnace.tint = vec3(0.f);
    for (const float roughness : kRoughnesses)
        for (float nv = 0.f; nv <= 1.f; nv += 0.005f) {
            const auto point = furnace.shadingPointOf({.hit = {}, .toEye = leaning(nv)});
            for (const float share : {furnace.reflectedSurroundings(point).y, furnace.reflected(point, leaning(1.f)).y}) {
                EXPECT_TRUE(share >= 0.f && share <= 2.f) << roughness << ' ' << nv << ' ' << share;
            }
        }
}
