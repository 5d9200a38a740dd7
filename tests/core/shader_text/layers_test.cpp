// The layers' text, run on the CPU: what they reflect of light from all around, by integrals over the hemisphere.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace {
using namespace glm;
struct Frame {
    vec3 normal;
};
struct Surface {
    Frame frame;
    vec3 toEye;
};
struct Sky { };
struct ShadingPoint {
    vec3 normal, toEye;
    float nv;
    Sky sky = {};
};
struct Surroundings {
    vec3 skyLight(Sky) { return vec3(1.f); }
    vec3 reflection(vec3, float) { return vec3(1.f); }
};
struct Coat : Surroundings {
    float clearcoat = 1.f, clearcoatRoughness = 0.f;
#include "shaders/layers/coat.glsl"
};
struct Sheen : Surroundings {
    float sheen = 1.f, sheenRoughness = 0.5f;
    vec3 sheenColor = vec3(1.f);
#include "shaders/layers/sheen.glsl"
};

vec3 eyeAt(float cosine)
{
    return {std::sqrt(1.f - cosine * cosine), 0.f, cosine};
}

// The mean of `reflected` (a share, of light whose irradiance over pi is 1, from one direction) over light from everywhere.
template <class Reflected> double albedo(Reflected reflected)
{
    constexpr int kRings = 400, kSectors = 400;
    double sum = 0.;
    for (int i = 0; i < kRings; ++i)
        for (int k = 0; k < kSectors; ++k) {
            const double polar = (i + 0.5) * 0.5 * std::numbers::pi / kRings, around = (k + 0.5) * 2. * std::numbers::pi / kSectors;
            const vec3 toLight(
                float(std::sin(polar) * std::cos(around)), float(std::sin(polar) * std::sin(around)), float(std::cos(polar)));
            sum += double(reflected(toLight)) * std::sin(polar);
        }
    return sum * (0.5 * std::numbers::pi / kRings) * (2. * std::numbers::pi / kSectors) / std::numbers::pi;
}
} // namespace

// So that coat and body together reflect no more than they receive: the body gets what the coat's share leaves.
TEST(Layers, TheCoatReflectsNoMoreThanItsShare)
{
    for (const float rough : {0.2f, 0.5f, 1.f})
        for (const float cosine : {0.3f, 0.7f, 1.f}) {
            Coat coat;
            coat.clearcoatRoughness = rough;
            const Surface surface{{{0.f, 0.f, 1.f}}, eyeAt(cosine)};
            EXPECT_LE(albedo([&](vec3 toLight) { return coat.coatReflected(surface, toLight).x; }), 1.01) << rough << ' ' << cosine;
            EXPECT_LE(coat.coatShare(surface), 1.f);
            if (cosine == 1.f) {
                EXPECT_NEAR(coat.coatShare(surface), 0.04f, 1e-6f); // Fresnel's of 1.5, seen from above
            }
        }
}

TEST(Layers, SheenTakesFromTheBodyWhatItReflects)
{
    for (const float rough : {0.3f, 0.5f, 0.8f, 1.f})
        for (const float cosine : {0.2f, 0.5f, 1.f}) {
            Sheen cloth;
            cloth.sheenRoughness = rough;
            const ShadingPoint point{{0.f, 0.f, 1.f}, eyeAt(cosine), cosine};
            const double reflected = albedo([&](vec3 toLight) { return cloth.sheenReflected(point, toLight).x; });
            EXPECT_NEAR(double(cloth.sheenAlbedo(cosine)), reflected, 0.03) << rough << ' ' << cosine;
            EXPECT_LE(double(cloth.belowSheen(point, 1.f)) + reflected, 1.03) << rough << ' ' << cosine;
        }
}
