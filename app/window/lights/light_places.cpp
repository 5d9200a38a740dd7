// Lights between the picture and the world.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/lights/light_places.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace relievo {
namespace {
constexpr float kSunDistance = 1.15f; // radii
constexpr float kEdge = 0.46f; // share of the picture from its middle that handles keep to
constexpr double kDegreesPerPixel = 0.4;

float shownDistance(const Parameters& parameters, const LightMembers& light, const Around& mesh)
{
    return isNear(parameters, light) ? distanceOf(parameters, light, mesh) : kSunDistance * mesh.radius;
}

glm::vec2 shareOf(glm::vec4 clip)
{
    return {0.5f + 0.5f * clip.x / clip.w, 0.5f - 0.5f * clip.y / clip.w};
}

glm::vec4 clipOf(glm::vec3 point, const CameraView& camera)
{
    return camera.clipFromView * camera.viewFromWorld * glm::vec4(point, 1.f);
}

float wrapped(double degrees) // into [-180, 180]
{
    return float(std::remainder(degrees, 360.));
}

void setDirection(Parameters& parameters, const LightMembers& light, double turnedYaw, double pitch)
{
    const auto range = [](auto member) { return kParameters[indexOf(member)]; };
    const ParameterRow yawRow = range(light.yaw), pitchRow = range(light.pitch);
    parameters.*light.yaw = std::clamp(wrapped(turnedYaw - double(parameters.lightTurn)), yawRow.min, yawRow.max);
    parameters.*light.pitch = std::clamp(float(pitch), pitchRow.min, pitchRow.max);
}
} // namespace

LightPlace lightPlace(const Parameters& parameters, const LightMembers& light, const Around& mesh, const CameraView& camera)
{
    const glm::vec3 point = mesh.middle + directionTo(parameters, light) * shownDistance(parameters, light, mesh);
    const glm::vec4 clip = clipOf(point, camera);
    const bool isAhead = clip.w > 1e-4f * camera.distance;
    glm::vec2 from = isAhead ? shareOf(clip) - 0.5f : glm::vec2(clip.x, -clip.y); // the middle of the picture
    const float out = std::max(std::abs(from.x), std::abs(from.y));
    const bool isThere = isAhead && out <= kEdge;
    if (!isThere)
        from *= kEdge / std::max(out, 1e-6f);
    return {from + 0.5f, isThere, glm::dot(point - mesh.middle, point - camera.eye) > 0.f};
}

glm::vec2 middlePlace(const Around& mesh, const CameraView& camera)
{
    const glm::vec4 clip = clipOf(mesh.middle, camera);
    return clip.w > 0.f ? glm::clamp(shareOf(clip), glm::vec2(-1.f), glm::vec2(2.f)) : glm::vec2(0.5f);
}

void moveLight(
    Parameters& parameters, const LightMembers& light, const Around& mesh, const CameraView& camera, glm::vec2 share, bool behind)
{
    const glm::vec4 far
        = glm::inverse(camera.clipFromView * camera.viewFromWorld) * glm::vec4(2.f * share.x - 1.f, 1.f - 2.f * share.y, 1.f, 1.f);
    const glm::vec3 way = glm::normalize(glm::vec3(far) / far.w - camera.eye), toMiddle = mesh.middle - camera.eye;
    const glm::vec3 aside = (way * glm::dot(way, toMiddle) - toMiddle) / shownDistance(parameters, light, mesh); // of the ray, in radii
    float out = glm::length(aside);
    const glm::vec3 outwards = out > 0.f ? aside / out : glm::vec3(0.f);
    if (out > 1.f) {
        behind = !behind;
        out = std::max(2.f - out, 0.f);
    }
    const glm::vec3 direction = outwards * out + way * ((behind ? 1.f : -1.f) * std::sqrt(1.f - out * out));
    setDirection(parameters, light, double(glm::degrees(std::atan2(direction.x, direction.z))),
        double(glm::degrees(std::asin(std::clamp(direction.y, -1.f, 1.f)))));
}

void turnLight(Parameters& parameters, const LightMembers& light, double dx, double dy)
{
    setDirection(parameters, light, double(turnedYaw(parameters, light)) + dx * kDegreesPerPixel,
        double(parameters.*light.pitch) - dy * kDegreesPerPixel);
}

void pushLight(Parameters& parameters, const LightMembers& light, double steps)
{
    const ParameterRow& row = kParameters[indexOf(light.distance)];
    parameters.*light.distance = std::clamp(parameters.*light.distance * float(std::pow(0.875, steps)), row.min, row.max);
}

} // namespace relievo
