// Stretched highlights, run on the CPU: against GGX with two widths in double precision, and what they leave of light from all around.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace {
using namespace glm;

// Metal, or what is not, with the normal +z and the texture's u along +x; v runs down, along -y.
struct Brushed {
    struct Hit {
        vec2 uv{0.f};
    };
    struct Frame {
        vec3 normal{0.f, 0.f, 1.f}, gradU{1.f, 0.f, 0.f}, gradV{0.f, -1.f, 0.f};
    };
    struct Surface {
        Frame frame;
        Hit hit;
        vec3 toEye;
        float footprint = 0.f;
    };
    struct Sky { };
    vec3 tint{1.f}, seen{0.f, 0.f, 1.f}; // seen: whither the surroundings were last looked up
    float roughness = 0.3f, metallic = 1.f, ior = 1.5f, anisotropyStrength = 0.f, anisotropyRotation = 0.f;
    static float spreadRoughness(float rough, const Surface&) { return rough; }
    static vec3 reliefNormal(const Surface&) { return {0.f, 0.f, 1.f}; }
    static vec3 colorAt(vec2, float) { return vec3(1.f); }
    static float roughnessAt(vec2, float) { return 1.f; }
    static float metallicAt(vec2, float) { return 1.f; }
    static Sky skyOver(const Surface&, vec3) { return {}; }
    static vec3 skyLight(Sky) { return vec3(1.f); }
    static float reflectedShare(Sky, float, float) { return 1.f; }
    vec3 reflection(vec3 direction, float)
    {
        seen = direction;
        return vec3(1.f);
    }
#include "shaders/shading/metallic_roughness.glsl"

    float lit(const vec3& toEye, const vec3& toLight)
    {
        const Surface surface{.frame = {}, .hit = {}, .toEye = toEye};
        return bodyReflected(surface, shadingPointOf(surface), toLight).y;
    }
#include "shaders/layers/stretch.glsl"
};

vec3 leaning(double cosine, double yaw)
{
    const double sine = std::sqrt(std::max(0., 1. - cosine * cosine));
    return {float(sine * std::cos(yaw)), float(sine * std::sin(yaw)), float(cosine)};
}

// GGX of two widths with height-correlated Smith (Heitz 2014, Understanding the Masking-Shadowing Function, appendix A), times pi and
// the light's cosine, of a Fresnel term of 1.
double exact(dvec2 alpha, dvec3 eye, dvec3 light)
{
    const dvec3 h = normalize(eye + light);
    const double q = h.x * h.x / (alpha.x * alpha.x) + h.y * h.y / (alpha.y * alpha.y) + h.z * h.z;
    const auto lambda = [alpha](dvec3 w) {
        const double rough = (alpha.x * alpha.x * w.x * w.x + alpha.y * alpha.y * w.y * w.y) / (w.z * w.z);
        return 0.5 * (std::sqrt(1. + rough) - 1.);
    };
    const double seen = 1. / (1. + lambda(eye) + lambda(light));
    return seen / (alpha.x * alpha.y * q * q * 4. * eye.z);
}

// The mean of `lit` over light from all around.
template <class Lit> double meanOver(Lit lit)
{
    constexpr int kRings = 300, kTurns = 600;
    double sum = 0.;
    for (int ring = 0; ring < kRings; ++ring)
        for (int turn = 0; turn < kTurns; ++turn)
            sum += double(lit(leaning((ring + 0.5) / kRings, 2. * std::numbers::pi * (turn + 0.5) / kTurns)));
    return 2. * sum / (kRings * kTurns);
}

constexpr double kQuarter = 0.5 * std::numbers::pi;
} // namespace

// What is reflected more than once is a factor of what is reflected once, the same for all lights.
TEST(Stretch, HighlightsAreGgxWithTwoWidths)
{
    for (const float strength : {0.3f, 0.7f, 1.f})
        for (const float rotation : {0.f, 35.f, 90.f}) {
            Brushed metal;
            metal.anisotropyStrength = strength, metal.anisotropyRotation = rotation;
            const double alpha = 0.09, turn = double(rotation) * std::numbers::pi / 180.;
            const dvec2 alphas(alpha + (1. - alpha) * double(strength) * double(strength), alpha);
            const auto turned = [turn](vec3 w) { // into the axes of the highlight
                return dvec3(std::cos(turn) * double(w.x) + std::sin(turn) * double(w.y),
                    std::cos(turn) * double(w.y) - std::sin(turn) * double(w.x), double(w.z));
            };
            for (const double nv : {1., 0.6}) {
                const vec3 eye = leaning(nv, 0.4);
                const double factor = double(metal.lit(eye, vec3(0.f, 0.f, 1.f))) / exact(alphas, turned(eye), dvec3(0., 0., 1.));
                EXPECT_GE(factor, 1.);
                for (const double nl : {0.95, 0.7, 0.3})
                    for (double yaw = 0.; yaw < 6.2; yaw += 0.5) {
                        const vec3 light = leaning(nl, yaw);
                        const double right = factor * exact(alphas, turned(eye), turned(light));
                        EXPECT_NEAR(double(metal.lit(eye, light)), right, 1e-3 * right + 1e-5) << strength << ' ' << rotation << ' ' << nl;
                    }
            }
        }
}

TEST(Stretch, TheyAreLongAlongTheirDirectionAndAsWideAsBeforeAcross)
{
    const auto spread = [](float strength, float rotation, dvec2 along) { // the second moment of half vectors' slopes, up to a slope of 1
        Brushed metal;
        metal.anisotropyStrength = strength, metal.anisotropyRotation = rotation;
        double sum = 0., weight = 0.;
        for (double nl = 0.02; nl < 1.; nl += 0.01)
            for (double yaw = 0.; yaw < 4. * kQuarter; yaw += 0.02) {
                const vec3 light = leaning(nl, yaw), h = normalize(light + vec3(0.f, 0.f, 1.f));
                const double slope = dot(dvec2(double(h.x), double(h.y)) / double(h.z), along),
                             lit = double(metal.lit({0.f, 0.f, 1.f}, light));
                sum += lit * slope * slope, weight += lit;
            }
        return sum / weight;
    };
    const double round = spread(0.f, 0.f, {1., 0.});
    EXPECT_NEAR(spread(0.f, 0.f, {0., 1.}), round, 0.02 * round);
    EXPECT_GT(spread(0.6f, 0.f, {1., 0.}), 1.8 * spread(0.6f, 0.f, {0., 1.}));
    EXPECT_GT(spread(0.6f, 90.f, {0., 1.}), 1.8 * spread(0.6f, 90.f, {1., 0.}));
    const double diagonal = std::sqrt(0.5);
    EXPECT_GT(spread(0.6f, 45.f, {diagonal, diagonal}), 1.8 * spread(0.6f, 45.f, {-diagonal, diagonal})); // up is -v
}

TEST(Stretch, WithoutStrengthTheyAreTheShadingModels)
{
    for (const float metallic : {0.f, 1.f})
        for (const float roughness : {0.1f, 0.5f, 1.f})
            for (const double nv : {1., 0.5, 0.1}) {
                Brushed body;
                body.metallic = metallic, body.roughness = roughness;
                const Brushed::Surface surface{.frame = {}, .hit = {}, .toEye = leaning(nv, 0.3)};
                const auto point = body.shadingPointOf(surface);
                EXPECT_NEAR(body.bodyAround(surface, point).y, body.reflectedSurroundings(point).y, 1e-4f);
                for (const double yaw : {0., 2., 4.}) {
                    const vec3 light = leaning(0.6, yaw);
                    const float plain = body.reflected(point, light).y;
                    EXPECT_NEAR(body.bodyReflected(surface, point, light).y, plain, 1e-3f * plain + 1e-5f);
                }
            }
}

// Without what is reflected more than once, half of the light would be lost.
TEST(Stretch, WhiteMetalLosesLittle)
{
    for (const float roughness : {0.3f, 0.5f, 0.8f})
        for (const float strength : {0.3f, 0.6f, 0.9f})
            for (const double nv : {1., 0.7, 0.4}) {
                Brushed metal;
                metal.roughness = roughness, metal.anisotropyStrength = strength;
                double mean = 0.;
                for (const double yaw : {0., 0.5 * kQuarter, kQuarter}) {
                    const vec3 eye = leaning(nv, yaw);
                    mean += (yaw == 0.5 * kQuarter ? 2. : 1.) / 4. * meanOver([&](vec3 light) { return metal.lit(eye, light); });
                    const Brushed::Surface surface{.frame = {}, .hit = {}, .toEye = eye};
                    EXPECT_NEAR(metal.bodyAround(surface, metal.shadingPointOf(surface)).y, 1.f, 0.01f);
                }
                EXPECT_NEAR(mean, 1., 0.06) << roughness << ' ' << strength << ' ' << nv;
            }
}

// Towards the eye across the scratches: what is mirrored lies in the plane of the eye and the scratches' normal plane.
TEST(Stretch, SurroundingsAreMirroredByABentNormal)
{
    Brushed metal;
    metal.roughness = 0.1f;
    const vec3 eye = leaning(0.6, kQuarter * 0.5);
    const auto mirrored = [&](float strength, float rotation) {
        metal.anisotropyStrength = strength, metal.anisotropyRotation = rotation;
        const Brushed::Surface surface{.frame = {}, .hit = {}, .toEye = eye};
        (void)metal.bodyAround(surface, metal.shadingPointOf(surface));
        return metal.seen;
    };
    EXPECT_LT(length(mirrored(0.f, 0.f) - vec3(-eye.x, -eye.y, eye.z)), 1e-5f);
    // Nearly along the eye in the plane of u and the normal; across it as before.
    const vec3 along = mirrored(1.f, 0.f), across = mirrored(1.f, 90.f);
    EXPECT_NEAR(along.y, -eye.y, 1e-3f);
    EXPECT_NEAR(along.x, eye.x, 0.02f);
    EXPECT_NEAR(across.x, -eye.x, 1e-3f);
    EXPECT_NEAR(across.y, eye.y, 0.02f);
}

// Where UVs are degenerate there is no direction, and no NaN either.
TEST(Stretch, WithoutATextureFrameItIsFinite)
{
    Brushed metal;
    metal.anisotropyStrength = 1.f;
    Brushed::Surface surface{.frame = {{0.f, 0.f, 1.f}, vec3(0.f), vec3(0.f)}, .hit = {}, .toEye = leaning(0.5, 1.)};
    EXPECT_TRUE(std::isfinite(metal.bodyReflected(surface, metal.shadingPointOf(surface), leaning(0.5, 2.)).y));
    EXPECT_TRUE(std::isfinite(metal.bodyAround(surface, metal.shadingPointOf(surface)).y));
}
