// The built-in environments by formula.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/environment/directions.h"
#include "core/image/environment/environment.h"
#include "core/image/environment/prefilter.h"
#include "core/image/environment/sky.h"
#include "core/state/environments.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace relievo {

namespace {
float smooth(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.f, 1.f);
    return t * t * (3.f - 2.f * t);
}

// A lamp or window with soft edges: a rectangle in the plane at distance 1 along `axis`, half-sizes as tangents.
struct SoftBox {
    SoftBox(glm::vec3 towards, float width, float height, float soft, glm::vec3 emitted)
        : axis(glm::normalize(towards))
        , right(glm::normalize(glm::cross(axis, glm::vec3(0.f, 1.f, 0.f))))
        , up(glm::cross(right, axis))
        , radiance(emitted)
        , halfWidth(width)
        , halfHeight(height)
        , softness(soft)
    {
    }
    glm::vec3 light(glm::vec3 direction) const
    {
        const float along = glm::dot(direction, axis);
        if (along <= 0.05f)
            return glm::vec3(0.f);
        const float x = std::abs(glm::dot(direction, right)) / along, y = std::abs(glm::dot(direction, up)) / along;
        if (x >= halfWidth || y >= halfHeight)
            return glm::vec3(0.f);
        const float inside = smooth(halfWidth, halfWidth - softness, x) * smooth(halfHeight, halfHeight - softness, y);
        return radiance * inside * (1.f - 0.35f * std::min((x * x + y * y) / (halfWidth * halfWidth + halfHeight * halfHeight), 1.f));
    }
    glm::vec3 axis, right, up, radiance;
    float halfWidth, halfHeight, softness;
};

// The camera looks from +z: left is -x, behind the camera is +z.
const std::array<SoftBox, 4> kStudioLamps = {{
    {{-0.75f, 0.85f, 0.45f}, 0.62f, 0.5f, 0.1f, {7.2f, 6.75f, 6.1f}}, // key, warm, above left
    {{0.9f, 0.25f, 0.6f}, 0.42f, 0.75f, 0.3f, {1.5f, 1.75f, 2.1f}}, // fill, cool, right
    {{0.55f, 0.45f, -0.8f}, 0.14f, 0.8f, 0.07f, {6.2f, 6.4f, 6.8f}}, // rim strip, behind right
    {{-0.8f, 0.12f, -0.75f}, 0.1f, 0.6f, 0.07f, {2.6f, 2.4f, 2.2f}}, // faint strip, behind left
}};

// A photographer's studio: a large soft key box above left, a cool fill, a rim strip, a soft grey floor and wall.
glm::vec3 studio(glm::vec3 direction)
{
    const glm::vec3 floor(0.42f, 0.405f, 0.39f), wall(0.62f, 0.63f, 0.645f), ceiling(0.85f, 0.86f, 0.88f);
    glm::vec3 light = glm::mix(floor, wall, smooth(-0.35f, 0.15f, direction.y));
    light = glm::mix(light, ceiling, smooth(0.2f, 0.95f, direction.y));
    light *= 0.75f + 0.25f * smooth(-0.9f, 0.5f, -direction.x * 0.6f + direction.z * 0.5f); // brighter beside the key
    light *= 1.f - 0.35f * smooth(-0.5f, -1.f, direction.y); // darker under the object
    for (const SoftBox& lamp : kStudioLamps)
        light += lamp.light(direction);
    return light;
}

// What the ground gives back, and where it begins.
glm::vec3 aboveGround(glm::vec3 sky, glm::vec3 ground, float height)
{
    return glm::mix(ground, sky, smooth(-0.02f, 0.02f, height));
}

// Moon and Spencer 1942 (the standard overcast sky of the CIE): three times as bright above as at the horizon.
glm::vec3 overcast(glm::vec3 direction)
{
    const float bright = (1.f + 2.f * std::max(direction.y, 0.f)) / 3.f;
    const float clouds = 1.f + 0.06f * std::sin(5.f * direction.x + 3.f * direction.z) * std::sin(4.f * direction.z - 2.f * direction.x);
    return aboveGround(bright * clouds * glm::vec3(0.95f, 0.99f, 1.04f), glm::vec3(0.17f, 0.165f, 0.155f), direction.y);
}

// The light by which a State is lit unless told otherwise comes from there (lightYaw, lightPitch).
glm::vec3 sunAt(float pitch)
{
    const float yaw = glm::radians(-50.f), up = glm::radians(pitch);
    return {std::cos(up) * std::sin(yaw), std::sin(up), std::cos(up) * std::cos(yaw)};
}

// A sun that is larger and weaker than the real one, so that a cube's texels hold it.
glm::vec3 sunDisc(glm::vec3 direction, glm::vec3 sun, float radius, glm::vec3 radiance)
{
    const float angle = std::acos(std::clamp(glm::dot(direction, sun), -1.f, 1.f));
    return radiance * smooth(glm::radians(1.25f * radius), glm::radians(0.75f * radius), angle);
}

glm::vec3 clearSky(glm::vec3 direction)
{
    static const glm::vec3 sun = sunAt(40.f);
    static const PreethamSky sky(sun, 2.6f);
    const glm::vec3 above = sky.radiance(direction) + sunDisc(direction, sun, 2.5f, glm::vec3(700.f, 660.f, 590.f));
    return aboveGround(above, glm::vec3(0.68f, 0.64f, 0.56f), direction.y);
}

glm::vec3 sunset(glm::vec3 direction)
{
    static const glm::vec3 sun = sunAt(5.f);
    static const PreethamSky sky(sun, 3.2f);
    const float towards
        = 0.5f + 0.5f * glm::dot(glm::normalize(glm::vec3(direction.x, 0.f, direction.z) + 1e-6f), glm::vec3(sun.x, 0.f, sun.z));
    const float low = std::exp(-9.f * std::max(direction.y, 0.f));
    const glm::vec3 red(1.f, 0.42f, 0.16f);
    const glm::vec3 above = sky.radiance(direction) * glm::mix(glm::vec3(0.62f, 0.6f, 0.78f), red + 0.25f, low)
        + red * (3.f * low * towards * towards) + sunDisc(direction, sun, 2.5f, glm::vec3(420.f, 170.f, 45.f));
    return aboveGround(above, glm::vec3(0.2f, 0.15f, 0.13f), direction.y);
}

const std::array<SoftBox, 4> kNightLamps = {{
    {{-0.6f, 0.9f, 0.5f}, 0.2f, 0.2f, 0.1f, {60.f, 40.f, 21.f}}, // hanging lamp
    {{1.f, 0.05f, 0.35f}, 0.1f, 0.16f, 0.05f, {34.f, 20.f, 9.f}}, // table lamp, right
    {{-0.9f, 0.2f, -0.7f}, 0.34f, 0.5f, 0.03f, {0.28f, 0.46f, 0.95f}}, // window, the night outside
    {{0.5f, -0.02f, 1.f}, 0.22f, 0.13f, 0.02f, {1.6f, 2.6f, 4.2f}}, // screen, behind the camera
}};

// A living room after dark: a warm lamp that hangs, one on a table, a window, a screen.
glm::vec3 nightInterior(glm::vec3 direction)
{
    const glm::vec3 floor(0.1f, 0.062f, 0.036f), wall(0.2f, 0.145f, 0.1f), ceiling(0.42f, 0.32f, 0.22f);
    glm::vec3 light = glm::mix(floor, wall, smooth(-0.45f, -0.35f, direction.y));
    light = glm::mix(light, ceiling, smooth(0.5f, 0.62f, direction.y));
    const float nearLamp = glm::dot(direction, kNightLamps[0].axis), nearTable = glm::dot(direction, kNightLamps[1].axis);
    light *= 0.5f + 1.6f * smooth(-0.4f, 1.f, nearLamp) + 1.9f * smooth(0.5f, 1.f, nearTable);
    for (const SoftBox& lamp : kNightLamps)
        light += lamp.light(direction);
    return light;
}

glm::vec3 grey(glm::vec3)
{
    return glm::vec3(1.f);
}

// In the order of kEnvironments.
using Formula = glm::vec3 (*)(glm::vec3);
constexpr std::array<Formula, kEnvironments.size()> kFormulas = {studio, overcast, clearSky, sunset, nightInterior, grey};
constexpr int kSide = 256;
} // namespace

glm::vec3 builtInRadiance(std::string_view key, glm::vec3 direction)
{
    const auto row = std::ranges::find(kEnvironments, key, &EnvironmentRow::key);
    return row == kEnvironments.end() ? glm::vec3(0.f) : kFormulas[std::size_t(row - kEnvironments.begin())](direction);
}

Environment builtInEnvironment(std::string_view key)
{
    const auto row = std::ranges::find(kEnvironments, key, &EnvironmentRow::key);
    Cube cube = cubeOf(kSide, [key](glm::vec3 direction) { return builtInRadiance(key, direction); });
    const glm::vec3 mean = meanOf(cube);
    const float scale = 3.f / std::max(mean.x + mean.y + mean.z, 1e-6f);
    for (glm::vec3& texel : cube.texels)
        texel *= scale;
    return {std::string(row == kEnvironments.end() ? key : row->label), prefiltered(std::move(cube))};
}

} // namespace relievo
