// The shader texts that read the map of horizons, run on the CPU: shadows against geometry, open sky against sums over directions.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/maps.h"
#include "tests/core/maps/maps_support.h"
#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <numbers>

using namespace relievo;
using namespace relievo::test;

namespace {
using namespace glm;
constexpr double kPi = std::numbers::pi;

// A tile of one metre in the plane z = 0, u along x, v along y, and its map as a texture.
struct Tile {
    struct Frame {
        vec3 normal{0.f, 0.f, 1.f}, gradU{1.f, 0.f, 0.f}, gradV{0.f, 1.f, 0.f};
    };
    struct Hit {
        vec2 uv{0.f};
    };
    struct Surface {
        Frame frame = {};
        float depth = 0.f;
        Hit hit = {};
        float footprint = 0.f;
    };
    struct Texture {
        BakedMap map;
        Wrap wrap = Wrap::Repeat;
    };
    Texture horizonMap;
    float horizonMapLevels = 0.f;

    static float mapLevel(float) { return 0.f; }
    static ivec3 textureSize(const Texture& texture, int)
    {
        const Image& image = texture.map.levels.front();
        return {image.width, image.height / texture.map.slices, texture.map.slices};
    }
    static vec4 textureLod(const Texture& texture, vec3 at, float)
    {
        const ivec3 size = textureSize(texture, 0);
        const vec2 place = vec2(at) * vec2(size) - 0.5f, first = floor(place), share = place - first;
        vec4 sum(0.f);
        for (int i = 0; i < 4; ++i) {
            const int x = wrapIndex(int(first.x) + i % 2, size.x, texture.wrap), y = wrapIndex(int(first.y) + i / 2, size.y, texture.wrap);
            const float weight = (i % 2 ? share.x : 1.f - share.x) * (i / 2 ? share.y : 1.f - share.y);
            for (int c = 0; c < 4; ++c)
                sum[c] += weight * texture.map.levels.front().value(x, int(at.z) * size.y + y, c);
        }
        return sum;
    }
    static vec3 irradiance(vec3) { return vec3(1.f); }
};
struct Shadows : Tile {
#include "shaders/horizon/shadow_above.glsl"
};
struct OpenSky : Tile {
#include "shaders/shading/sky_bent.glsl"
};
struct Reflected : OpenSky {
#include "shaders/shading/reflected_occluded.glsl"
};

Tile::Texture horizonsOf(const HeightField& field, int azimuths)
{
    const BakedMapRow& row = *findBakedMap(azimuths == 8 ? "horizon-slopes" : "horizon-slopes-16");
    return {storedMap(row, *bakeMap(row, field, {}), row.bits), field.wrap()};
}

Tile::Surface surfaceAt(vec2 uv, float depth)
{
    return {.frame = {}, .depth = depth, .hit = {uv}, .footprint = 0.f};
}
vec2 centreOf(const HeightField& field, int x, int y)
{
    return (vec2(x, y) + 0.5f) / vec2(field.width(), field.height());
}
vec3 lightAt(float yaw, float pitch)
{
    return {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
}

// Light on a matt surface at a texel, and where it comes from (not normalised): sums over azimuths and elevations, each horizon found by
// marching.
struct Summed {
    double open = 0.;
    dvec3 towards{0.};
};
Summed summed(const HeightField& field, ivec2 texel, double depth, dvec3 normal)
{
    constexpr int kAzimuths = 96, kElevations = 400;
    const dvec2 from(centreOf(field, texel.x, texel.y));
    const double height = double(field.texel(texel.x, texel.y)), step = 0.125 / std::max(field.width(), field.height());
    Summed sum;
    for (int a = 0; a < kAzimuths; ++a) {
        const double yaw = 2. * kPi * (a + 0.5) / kAzimuths;
        const dvec2 way(std::cos(yaw), std::sin(yaw));
        double tangent = 0.;
        for (double s = step; s < 1.5; s += step)
            tangent = std::max(tangent, depth * (double(field.at(vec2(from + s * way))) - height) / s);
        for (int e = 0; e < kElevations; ++e) {
            const double elevation = 0.5 * kPi * (e + 0.5) / kElevations;
            if (std::tan(elevation) < tangent)
                continue;
            const dvec3 to(std::cos(elevation) * way, std::sin(elevation));
            const double weight = std::max(0., dot(normal, to)) * std::cos(elevation) * (2. * kPi / kAzimuths) * (0.5 * kPi / kElevations);
            sum.open += weight / kPi;
            sum.towards += weight * to;
        }
    }
    return sum;
}

dvec3 normalAt(const HeightField& field, ivec2 texel, double depth)
{
    const double du = double(field.texel(texel.x + 1, texel.y) - field.texel(texel.x - 1, texel.y)) * field.width() / 2.,
                 dv = double(field.texel(texel.x, texel.y + 1) - field.texel(texel.x, texel.y - 1)) * field.height() / 2.;
    return normalize(dvec3(-depth * du, -depth * dv, 1.));
}
} // namespace

TEST(HorizonSlopes, AreTheSinesOfAnyDepth)
{
    for (const HardField& hard : kHardFields)
        for (const auto [width, height] : {std::array{48, 32}, {1, 7}, {9, 1}}) {
            const HeightField field = hardField(hard, width, height);
            const Tile::Texture slopes = horizonsOf(field, 8);
            for (const float depth : {0.02f, 0.5f}) {
                Parameters parameters;
                parameters.depth = depth;
                const BakedMap sines = *bakeMap(*findBakedMap("horizon"), field, parameters);
                for (int i = 0; i < width * height * 2; ++i)
                    for (int c = 0; c < 4; ++c) {
                        const double share = double(slopes.map.levels[0].value(i % width, i / width, c)), s = share / (1. - share);
                        const double tangent = double(depth) * double(kHalfSlope) * s;
                        ASSERT_NEAR(tangent / std::hypot(1., tangent), double(sines.levels[0].value(i % width, i / width, c)), 1e-3)
                            << hard.name << ' ' << i << ' ' << c;
                    }
            }
        }
}

// A wall casts a shadow as long as it is high over the light's tangent, whatever the light's height and the depth, also across the
// texture's border.
TEST(HorizonShadows, EndWhereTheWallsShadowEnds)
{
    constexpr int kWidth = 256;
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp})
        for (const int wallAt : {20, 200}) { // the wall's last texel; from 200 the shadow goes over the border
            const HeightField field = fieldOf(
                kWidth, 4, [&](int x, int) { return x <= wallAt && x > wallAt - 8 ? 1.f : 0.f; }, wrap);
            for (const int azimuths : {8, 16}) {
                Shadows shadows;
                shadows.horizonMap = horizonsOf(field, azimuths);
                for (const float depth : {0.02f, 0.1f})
                    for (const float degrees : {10.f, 25.f, 45.f, 70.f}) {
                        const float pitch = radians(degrees), reach = depth / std::tan(pitch) * kWidth; // texels
                        const vec3 toLight = lightAt(float(kPi), pitch);
                        for (float x = float(wallAt) + 3.f; x < float(wallAt) + 150.f; x += 0.25f) {
                            if (wrap == Wrap::Clamp && x > kWidth - 1)
                                break;
                            const float away = x - float(wallAt);
                            if (std::abs(away - reach) < 1.f)
                                continue;
                            const vec2 uv(fract((x + 0.5f) / kWidth), 0.5f);
                            ASSERT_EQ(shadows.shareAbove(surfaceAt(uv, depth), toLight, 0.f), away > reach ? 1.f : 0.f)
                                << degrees << " deg, depth " << depth << ", " << away << " of " << reach << " texels";
                        }
                    }
            }
        }
}

// The line from a point of the ground to the light misses a round ridge or not, by its tangent to the cylinder.
TEST(HorizonShadows, EndWhereARoundRidgesShadowEnds)
{
    constexpr int kWidth = 512;
    constexpr float kRadius = 0.1f, kDepth = 0.1f; // of a half cylinder in the middle of the tile
    const HeightField field = fieldOf(kWidth, 4, [&](int x, int) {
        const float off = (float(x) + 0.5f) / kWidth - 0.5f;
        return std::sqrt(std::max(0.f, kRadius * kRadius - off * off)) / kDepth;
    });
    Shadows shadows;
    shadows.horizonMap = horizonsOf(field, 16);
    for (const float degrees : {20.f, 40.f, 60.f, 75.f}) {
        const float pitch = radians(degrees), ends = kRadius / std::sin(pitch); // from the axis
        for (float off = kRadius + 0.01f; off < 0.45f; off += 0.001f)
            if (std::abs(off - ends) > 2.f / kWidth) {
                ASSERT_EQ(
                    shadows.shareAbove(surfaceAt({0.5f + off, 0.5f}, kDepth), lightAt(float(kPi), pitch), 0.f), off > ends ? 1.f : 0.f)
                    << degrees << " deg, " << off << " of " << ends;
            }
    }
}

// Half of the disc is seen where its middle touches the horizon, all of it a radius above; in between the area of a circle's segment.
TEST(HorizonShadows, SoftOnesAreTheShareOfTheDisc)
{
    const HeightField field = fieldOf(64, 4, [](int x, int) { return x < 8 ? 1.f : 0.f; });
    Shadows shadows;
    shadows.horizonMap = horizonsOf(field, 16);
    const auto surface = surfaceAt(centreOf(field, 20, 1), 0.1f);
    const float edge = std::atan2(0.1f, 13.f / 64.f), radius = 0.05f;
    for (const float above : {-1.5f, -1.f, -0.6f, 0.f, 0.3f, 1.f, 2.f}) {
        double inside = 0., all = 0.;
        for (int i = 0; i < 400 * 400; ++i) {
            const double x = (i % 400 + 0.5) / 200. - 1., y = (i / 400 + 0.5) / 200. - 1.;
            if (x * x + y * y < 1.)
                all += 1., inside += y + double(above) > 0.;
        }
        EXPECT_NEAR(double(shadows.shareAbove(surface, lightAt(float(kPi), edge + above * radius), radius)), inside / all, 0.01) << above;
    }
    EXPECT_EQ(shadows.shareAbove(surfaceAt({0.5f, 0.5f}, 0.1f), {0.f, 0.f, 1.f}, 0.f), 1.f);
    EXPECT_EQ(shadows.shareAbove(surfaceAt({0.5f, 0.5f}, 0.1f), lightAt(1.f, -0.2f), 0.f), 0.f) << "from below";
}

// In a V between two planes that rise by the angle a to either side the mean of cos^2 e over all azimuths, tan e = tan a |cos|, is cos a.
TEST(OpenSky, AtTheBottomOfAVIsTheCosineOfItsWalls)
{
    const HeightField field = fieldOf(129, 8, [](int x, int) { return std::abs(2.f * (float(x) + 0.5f) / 129.f - 1.f); });
    for (const int azimuths : {8, 16}) {
        OpenSky sky;
        sky.horizonMap = horizonsOf(field, azimuths);
        for (const float depth : {0.05f, 0.2f, 0.5f, 1.f}) {
            const auto seen = sky.openSky(surfaceAt(centreOf(field, 64, 3), depth), {0.f, 0.f, 1.f});
            EXPECT_NEAR(double(seen.open), 1. / std::hypot(1., 2. * double(depth)), azimuths == 8 ? 0.02 : 0.004) << depth;
            EXPECT_NEAR(double(seen.toOpen.z), 1., 1e-4) << "it looks straight up";
        }
    }
}

TEST(OpenSky, IsTheSumOverAllDirections)
{
    for (const char* name : {"one wave", "waves", "low domes", "bowl", "rough hills"}) {
        const HeightField field
            = hardField(*std::ranges::find_if(kHardFields, [&](auto& hard) { return name == std::string(hard.name); }), 64, 64);
        OpenSky sky;
        sky.horizonMap = horizonsOf(field, 16);
        double most = 0., sum = 0., turned = 0.;
        int count = 0;
        for (const double depth : {0.05, 0.3})
            for (const bool lit : {false, true}) // by the mesh's normal, and by the relief's
                for (int n = 5; n < 64 * 64; n += 311, ++count) {
                    const ivec2 texel(n % 64, n / 64);
                    const dvec3 normal = lit ? normalAt(field, texel, depth) : dvec3(0., 0., 1.);
                    const Summed exact = summed(field, texel, depth, normal);
                    const auto seen = sky.openSky(surfaceAt(centreOf(field, texel.x, texel.y), float(depth)), vec3(normal));
                    most = std::max(most, std::abs(double(seen.open) - exact.open));
                    sum += std::abs(double(seen.open) - exact.open);
                    turned = std::max(turned, std::acos(std::min(1., dot(dvec3(seen.toOpen), normalize(exact.towards)))));
                }
        EXPECT_LT(sum / count, 0.01) << name;
        EXPECT_LT(most, 0.1) << name;
        EXPECT_LT(turned, 0.1) << name << ": the bent normal, radians";
    }
}

// A level field hides nothing; nor does it where the texture is stretched and skewed.
TEST(OpenSky, IsWholeWhereNothingStands)
{
    OpenSky sky;
    sky.horizonMap = horizonsOf(fieldOf(8, 8, [](int, int) { return 0.5f; }), 16);
    auto surface = surfaceAt({0.3f, 0.6f}, 0.3f);
    surface.frame.gradU = {2.f, 0.7f, 0.f}, surface.frame.gradV = {0.1f, 0.5f, 0.f};
    const auto seen = sky.openSky(surface, surface.frame.normal);
    EXPECT_NEAR(seen.open, 1.f, 1e-6f);
    EXPECT_NEAR(seen.toOpen.z, 1.f, 1e-6f);
    surface.frame.gradU = {0.f, 0.f, 0.f}; // no texture at all
    EXPECT_EQ(sky.openSky(surface, surface.frame.normal).open, 1.f);
}

// The same relief on a texture that is stretched tells the same.
TEST(OpenSky, FollowsAStretchedTexture)
{
    const auto heights = [](float u, float v) { return 0.5f + 0.3f * std::sin(6.2831853f * u) * std::cos(6.2831853f * v); };
    const HeightField once = fieldOf(64, 64, [&](int x, int y) { return heights((float(x) + 0.5f) / 64.f, (float(y) + 0.5f) / 64.f); });
    const HeightField twice = fieldOf(64, 64, [&](int x, int y) { return heights((float(x) + 0.5f) / 32.f, (float(y) + 0.5f) / 64.f); });
    OpenSky plain, stretched;
    plain.horizonMap = horizonsOf(once, 16), stretched.horizonMap = horizonsOf(twice, 16);
    for (const vec2 uv : {vec2(0.2f, 0.3f), vec2(0.75f, 0.5f), vec2(0.9f, 0.1f)}) {
        auto wide = surfaceAt({0.5f * uv.x, uv.y}, 0.3f);
        wide.frame.gradU.x = 0.5f; // the tile is two metres long
        const auto a = plain.openSky(surfaceAt(uv, 0.3f), {0.f, 0.f, 1.f}), b = stretched.openSky(wide, {0.f, 0.f, 1.f});
        EXPECT_NEAR(a.open, b.open, 0.01f);
        EXPECT_GT(dot(a.toOpen, b.toOpen), 0.999f);
    }
}

TEST(SpecularOcclusion, NeverBrightensAndLeavesWhatIsOpen)
{
    Reflected sky;
    for (const float rough : {0.f, 0.045f, 0.2f, 0.5f, 1.f})
        for (const float nv : {0.001f, 0.1f, 0.5f, 1.f}) {
            EXPECT_EQ(sky.reflectedShare({1.f, {0.f, 0.f, 1.f}}, nv, rough), 1.f) << rough << ' ' << nv;
            float before = 1.f;
            for (int i = 20; i >= 0; --i) {
                const float open = float(i) / 20.f;
                const float share = sky.reflectedShare({open, {0.f, 0.f, 1.f}}, nv, rough);
                EXPECT_LE(share, before) << rough << ' ' << nv << ' ' << open;
                EXPECT_GE(share, 0.f);
                before = share;
            }
            EXPECT_EQ(before, 0.f);
        }
    EXPECT_NEAR(sky.reflectedShare({0.6f, {0.f, 0.f, 1.f}}, 0.5f, 1.f), 0.6f, 1e-4f) << "rough: as a matt surface";
}
