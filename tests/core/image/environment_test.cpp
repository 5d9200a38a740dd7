// Environments: sizes, energy and directions of the built-in ones, pictures brought to the same form, and prefiltering against integrals.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/environment/directions.h"
#include "core/image/environment/environment.h"
#include "core/image/environment/prefilter.h"
#include "core/image/environment/sky.h"
#include "core/image/files/image_file.h"
#include "core/state/camera_view.h"
#include "core/state/environments.h"
#include "core/state/parameters.h"
#include <cmath>
#include <filesystem>
#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <unistd.h>

using namespace relievo;
namespace fs = std::filesystem;

namespace {
// The shader's way into the levels.
struct Text {
    struct Sampler {
        const Environment* environment;
    };
    Sampler environmentMap;
    glm::vec2 environmentTurn{1.f, 0.f};
    using vec2 = glm::vec2;
    struct vec3 : glm::vec3 {
        using glm::vec3::vec3;
        vec3(const glm::vec3& v) : glm::vec3(v) { }
    };
    struct Texel {
        glm::vec3 rgb;
    };
    static glm::ivec2 textureSize(Sampler sampler, int) { return glm::ivec2(sampler.environment->levels.front().side); }
    static float log2(float x) { return std::log2(x); }
    static Texel textureLod(Sampler sampler, glm::vec3 direction, float lod)
    {
        const auto& levels = sampler.environment->levels;
        const std::size_t level = std::min(std::size_t(lod), levels.size() - 1), next = std::min(level + 1, levels.size() - 1);
        const float share = lod - float(level);
        return {glm::mix(SmoothCube(levels[level]).at(direction), SmoothCube(levels[next]).at(direction), share)};
    }
#include "shaders/shading/environment.glsl"
};

// Texels of a cube as lights: directions and shares of the whole sphere.
template <class Visit> void forTexels(const Cube& cube, Visit visit)
{
    const auto place = [&cube](int k) { return 2.f * (float(k % cube.side) + 0.5f) / float(cube.side) - 1.f; };
    for (int i = 0; i < 6 * cube.side * cube.side; ++i) {
        const CubePlace at{i / (cube.side * cube.side), place(i), place(i / cube.side)};
        visit(glm::normalize(glm::dvec3(cubeDirection(at))), double(texelShare(at.a, at.b)), glm::dvec3(cube.texels[std::size_t(i)]));
    }
}

// The sum over all directions, in double precision: what a surface of this roughness reflects, seen from above; 0: what a matt one does.
glm::dvec3 integrated(const Cube& cube, glm::dvec3 n, double roughness)
{
    glm::dvec3 sum(0.);
    double total = 0.;
    forTexels(cube, [&](glm::dvec3 towards, double share, glm::dvec3 radiance) {
        const double cosine = glm::dot(n, towards), alpha2 = std::pow(roughness, 4.), k = 0.5 * (1. + cosine) * (alpha2 - 1.) + 1.;
        const double weight = share * std::max(cosine, 0.) * (roughness > 0. ? alpha2 / (k * k) : 1.);
        sum += weight * radiance, total += weight;
    });
    return sum / total;
}

double brightness(glm::dvec3 c)
{
    return (c.x + c.y + c.z) / 3.;
}

std::vector<glm::dvec3> someDirections()
{
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < 60; ++i) {
        const double y = 1. - 2. * (i + 0.5) / 60., turn = 2.39996 * i, r = std::sqrt(1. - y * y);
        directions.emplace_back(r * std::cos(turn), y, r * std::sin(turn));
    }
    return directions;
}

class PanoramaFiles : public testing::Test {
protected:
    void SetUp() override
    {
        std::string name = (fs::temp_directory_path() / "relievo-environment-XXXXXX").string();
        m_folder = mkdtemp(name.data());
    }
    void TearDown() override { fs::remove_all(m_folder); }
    // A picture of one value, but for those in `odd`, which stand first.
    Expected<Environment> opened(int width, int height, float value, const std::vector<float>& odd = {}, const char* file = "sky.exr")
    {
        Image image{width, height, 3, PixelType::F32, 32, true, {}};
        std::vector<float> values(image.texelCount() * 3, value);
        std::ranges::copy(odd, values.begin());
        const auto* raw = reinterpret_cast<const std::byte*>(values.data());
        image.data.assign(raw, raw + values.size() * 4);
        if (const auto written = writeImage(m_folder / file, image); !written)
            return tl::unexpected(written.error());
        return openEnvironment((m_folder / file).string());
    }
    fs::path m_folder;
};

std::vector<std::string> codesOf(const Environment& environment)
{
    std::vector<std::string> codes;
    for (const Warning& warning : environment.warnings)
        codes.push_back(warning.code);
    return codes;
}

void expectFinite(const Environment& environment)
{
    for (const Cube& level : environment.levels)
        for (const glm::vec3& c : level.texels) {
            ASSERT_TRUE(std::isfinite(c.x + c.y + c.z));
            ASSERT_TRUE(std::min({c.x, c.y, c.z}) >= 0.f && std::max({c.x, c.y, c.z}) <= 65504.f);
        }
}

TEST(Environment, EachBuiltInOneHasAllLevelsAndKeepsItsEnergy)
{
    for (const EnvironmentRow& row : kEnvironments) {
        const auto opened = openEnvironment(std::string(row.key));
        ASSERT_TRUE(opened);
        EXPECT_EQ(opened->name, row.label);
        const int side = opened->levels.front().side;
        ASSERT_EQ(opened->levels.size(), std::size_t(levelCount(side)));
        for (std::size_t k = 0; k < opened->levels.size(); ++k) {
            ASSERT_EQ(opened->levels[k].side, side >> k);
            EXPECT_NEAR(brightness(meanOf(opened->levels[k])), 1.0, 0.03) << row.key << k;
        }
        EXPECT_EQ(opened->levels[opened->levels.size() - 2].side, 16);
        expectFinite(*opened);
        EXPECT_TRUE(opened->warnings.empty());
    }
}

TEST(Environment, BuiltInOnesAreLitFromAboveAndAllDiffer)
{
    std::vector<Cube> mattOnes;
    for (const EnvironmentRow& row : kEnvironments) {
        mattOnes.push_back(builtInEnvironment(row.key).levels.back());
        const SmoothCube matt(mattOnes.back());
        const bool isGrey = row.key == "grey";
        EXPECT_EQ(brightness(matt.at({0.f, 1.f, 0.f})) > 1.2 * brightness(matt.at({0.f, -1.f, 0.f})), !isGrey) << row.key;
        for (std::size_t i = 0; i + 1 < mattOnes.size(); ++i)
            EXPECT_NE(mattOnes[i].texels, mattOnes.back().texels) << row.key << ' ' << kEnvironments[i].key;
    }
}

// Where the light comes from by default, so that the shadow that it casts is the sun's.
TEST(Environment, TheSunStandsWhereTheLightDoes)
{
    const Parameters defaults;
    const Environment sky = builtInEnvironment("clear-sky");
    glm::dvec3 brightest(0.);
    double most = 0.;
    forTexels(sky.levels.front(), [&](glm::dvec3 towards, double, glm::dvec3 radiance) {
        if (brightness(radiance) > most)
            most = brightness(radiance), brightest = towards;
    });
    EXPECT_GT(glm::dot(brightest, glm::dvec3(directionTo(defaults.lightYaw, defaults.lightPitch))), 0.998);
}

// Preetham et al. 1999, appendix A.2, worked out by hand for the zenith, where luminance is 1 and the chromaticities are those given.
TEST(Environment, TheClearSkyIsPreethams)
{
    const glm::vec3 sun = directionTo(0.f, 45.f);
    const PreethamSky sky(sun, 3.f);
    const glm::vec3 zenith = sky.radiance({0.f, 1.f, 0.f});
    const double t = 3., z = 3.14159265 / 4., z2 = z * z, z3 = z2 * z;
    const double x = t * t * (0.00166 * z3 - 0.00375 * z2 + 0.00209 * z) + t * (-0.02903 * z3 + 0.06377 * z2 - 0.03202 * z + 0.00394)
        + (0.11693 * z3 - 0.21196 * z2 + 0.06052 * z + 0.25886);
    const double luminance = 0.2126 * double(zenith.x) + 0.7152 * double(zenith.y) + 0.0722 * double(zenith.z);
    const double big = 0.4124 * double(zenith.x) + 0.3576 * double(zenith.y) + 0.1805 * double(zenith.z);
    const double whole = big + luminance + 0.0193 * double(zenith.x) + 0.1192 * double(zenith.y) + 0.9505 * double(zenith.z);
    EXPECT_NEAR(luminance, 1., 1e-3);
    EXPECT_NEAR(big / whole, x, 1e-3);
    EXPECT_GT(brightness(sky.radiance(sun)), 2. * brightness(sky.radiance({-sun.x, sun.y, -sun.z}))) << "brighter around the sun";
    EXPECT_GT(zenith.z, zenith.x) << "blue";
}

TEST(Environment, KeyLightOfTheStudioComesFromAboveLeft)
{
    const SmoothCube matt(builtInEnvironment("studio").levels.back());
    EXPECT_GT(matt.at({0.f, 1.f, 0.f}).x, matt.at({0.f, -1.f, 0.f}).x);
    EXPECT_GT(matt.at({-1.f, 0.f, 0.f}).x, matt.at({1.f, 0.f, 0.f}).x);
}

TEST(Environment, CubesHoldDirectionsAndJoinAtTheirEdges)
{
    const Cube cube = cubeOf(32, [](glm::vec3 direction) { return direction; });
    const SmoothCube smooth(cube);
    for (const glm::dvec3& direction : someDirections()) {
        const CubePlace place = cubePlace(glm::vec3(direction));
        EXPECT_LT(glm::distance(glm::normalize(cubeDirection(place)), glm::vec3(direction)), 1e-5f);
        EXPECT_LT(glm::distance(smooth.at(glm::vec3(direction)), glm::vec3(direction)), 0.01f);
    }
    for (const float along : {-0.9f, -0.3f, 0.2f, 0.8f}) // on both sides of an edge
        EXPECT_LT(glm::distance(smooth.at({1.f, along, 0.9999f}), smooth.at({0.9999f, along, 1.f})), 0.06f);
}

TEST(Environment, TheTurnIsTheShadersAndLeavesHeightsAlone)
{
    const Environment studio = builtInEnvironment("studio");
    Text text{{&studio}};
    const float turn = glm::radians(90.f);
    text.environmentTurn = {std::cos(turn), std::sin(turn)};
    const glm::vec3 turned = text.turned(Text::vec3(0.f, 0.6f, 0.8f));
    EXPECT_LT(glm::distance(turned, glm::vec3(-0.8f, 0.6f, 0.f)), 1e-6f);
}

// What pictures read, levels between those that are made included, against the integral; so resources/help/light.md says.
TEST(Environment, PrefilteringIsNearTheIntegral)
{
    for (const EnvironmentRow& row : kEnvironments) {
        const Environment environment = builtInEnvironment(row.key);
        Text text{{&environment}};
        const Cube source = halved(environment.levels.front());
        for (const auto& [roughness, allowed] : {std::pair{0.3, 0.15}, {0.5, 0.08}, {0.75, 0.1}, {1., 0.01}, {0., 0.015}}) {
            double sum = 0.;
            for (const glm::dvec3& n : someDirections()) {
                const Text::vec3 towards{glm::vec3(n)};
                const glm::dvec3 exact = integrated(roughness >= 0.7 || roughness == 0. ? halved(source) : source, n, roughness);
                const glm::dvec3 read(roughness > 0. ? text.reflection(towards, float(roughness)) : text.irradiance(towards));
                sum += std::pow(brightness(read) - brightness(exact), 2.);
            }
            const double error = std::sqrt(sum / double(someDirections().size()));
            RecordProperty(std::string(row.key) + std::to_string(roughness), std::to_string(error));
            if (std::getenv("RELIEVO_PRINT"))
                std::printf("%s %.2f %.4f\n", std::string(row.key).c_str(), roughness, error);
            EXPECT_LT(error, allowed) << row.key << ' ' << roughness;
        }
    }
}

TEST_F(PanoramaFiles, ConstantOnesStayConstant)
{
    for (const char* file : {"sky.hdr", "sky.exr"}) {
        const Expected<Environment> sky = opened(74, 37, 2.5f, {}, file);
        ASSERT_TRUE(sky) << message(sky.error());
        EXPECT_EQ(sky->name, "sky");
        EXPECT_TRUE(sky->warnings.empty());
        for (const Cube& level : sky->levels)
            for (const glm::vec3& c : level.texels)
                ASSERT_NEAR(c.y, 2.5f, 0.02f);
    }
    const Expected<Environment> missing = openEnvironment("/nowhere/sky.hdr");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().where, "/nowhere/sky.hdr");
}

TEST_F(PanoramaFiles, TheMiddleColumnLiesTowardsMinusZ)
{
    std::vector<float> rows(64 * 32 * 3, 0.f); // red towards -z, green towards +x, blue up
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            float* c = &rows[std::size_t(y * 64 + x) * 3];
            c[0] = std::abs(x - 32) < 4 ? 1.f : 0.f, c[1] = std::abs(x - 48) < 4 ? 1.f : 0.f, c[2] = y < 4 ? 1.f : 0.f;
        }
    const Expected<Environment> sky = opened(64, 32, 0.f, rows);
    ASSERT_TRUE(sky);
    const SmoothCube sharp(sky->levels.front());
    EXPECT_GT(sharp.at({0.f, 0.f, -1.f}).x, 0.9f);
    EXPECT_GT(sharp.at({1.f, 0.f, 0.f}).y, 0.9f);
    EXPECT_GT(sharp.at({0.f, 1.f, 0.f}).z, 0.9f);
    EXPECT_LT(sharp.at({0.f, 0.f, 1.f}).x, 0.1f);
}

TEST_F(PanoramaFiles, LargePanoramasKeepTheirDetailAndASmallSunItsEnergy)
{
    std::vector<float> sun(2048 * 1024 * 3, 0.f);
    for (int y = 300; y < 304; ++y)
        for (int x = 1000; x < 1004; ++x)
            for (std::size_t k = 0; k < 3; ++k)
                sun[(std::size_t(y) * 2048 + std::size_t(x)) * 3 + k] = 60000.f;
    const Expected<Environment> sky = opened(2048, 1024, 0.f, sun);
    ASSERT_TRUE(sky);
    EXPECT_EQ(sky->levels.front().side, 512);
    const double area = 16. * std::sin(3.14159265 * 302. / 1024.) * 2. * 9.8696044 / (2048. * 1024.); // of 4 pi
    const double mean = 60000. * area / (4. * 3.14159265);
    for (std::size_t level : {std::size_t(0), sky->levels.size() - 2, sky->levels.size() - 1})
        EXPECT_NEAR(brightness(meanOf(sky->levels[level])) / mean, 1., 0.1) << level;
    expectFinite(*sky);
}

TEST_F(PanoramaFiles, OddOnesAreToldAndStayFinite)
{
    using Codes = std::vector<std::string>;
    constexpr float kInf = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
    struct Case {
        int width, height;
        std::vector<float> odd;
        Codes codes;
        const char* says;
    };
    for (const Case& c :
        {Case{96, 16, {}, {"panorama-shape"}, "six faces of a cube"}, {16, 96, {}, {"panorama-shape"}, "six faces of a cube"},
            {64, 48, {}, {"panorama-shape"}, "cross"}, {48, 64, {}, {"panorama-shape"}, "cross"},
            {64, 64, {}, {"panorama-shape"}, "fish-eye"}, {90, 20, {}, {"panorama-shape"}, "twice as wide"},
            {1, 1, {}, {"panorama-tiny"}, "1 x 1"}, {64, 32, {kNan, kInf, -kInf, -3.f}, {"panorama-numbers"}, " 4 of its numbers"},
            {64, 32, {65504.f}, {}, ""}, {64, 32, {1e9f}, {"panorama-numbers"}, " 1 of its numbers"}}) {
        const auto sky = opened(c.width, c.height, 1.f, c.odd);
        ASSERT_TRUE(sky) << message(sky.error());
        EXPECT_EQ(codesOf(*sky), c.codes) << c.width << ' ' << c.height;
        EXPECT_NE((c.codes.empty() ? "" : sky->warnings.front().text).find(c.says), std::string::npos) << c.says;
        expectFinite(*sky);
    }
    const auto weak = opened(64, 32, 0.5f, {}, "sky.png");
    ASSERT_TRUE(weak) << message(weak.error());
    EXPECT_EQ(codesOf(*weak), Codes{"panorama-dim"});
}

} // namespace
