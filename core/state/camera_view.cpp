// Camera mathematics: orbit angles to matrices, framing a box.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/camera_view.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace relievo {

glm::vec3 directionTo(float yaw, float pitch)
{
    const float y = glm::radians(yaw), p = glm::radians(pitch);
    return {std::cos(p) * std::sin(y), std::sin(p), std::cos(p) * std::cos(y)};
}

namespace {
// How far a shape in the box of half size `half` reaches along a unit direction: between a box and the ellipsoid in it, since most
// meshes are something between.
float reach(glm::vec3 half, glm::vec3 direction)
{
    const glm::vec3 parts = half * glm::abs(direction);
    return 0.5f * (parts.x + parts.y + parts.z + glm::length(parts));
}

// The distance at which none of the points, seen from around `target`, lies further out than camera.fill.
float fillingDistance(const CameraView& view, glm::vec3 towardsEye, glm::vec2 reachOfFill, std::span<const glm::vec3> points)
{
    float distance = 0.f;
    for (const glm::vec3& point : points) {
        const glm::vec3 from = point - view.target;
        const float aside
            = std::max(std::abs(glm::dot(from, view.right)) / reachOfFill.x, std::abs(glm::dot(from, view.up)) / reachOfFill.y);
        distance = std::max(distance, aside + glm::dot(from, towardsEye));
    }
    return distance;
}

std::array<glm::vec3, 8> corners(glm::vec3 least, glm::vec3 most)
{
    std::array<glm::vec3, 8> all;
    for (int i = 0; i < 8; ++i)
        all[std::size_t(i)] = {i & 1 ? most.x : least.x, i & 2 ? most.y : least.y, i & 4 ? most.z : least.z};
    return all;
}
} // namespace

CameraView cameraView(const Camera& camera, glm::vec3 boundsMin, glm::vec3 boundsMax, float aspect, std::span<const glm::vec3> outline)
{
    CameraView view;
    const float yaw = glm::radians(camera.yaw), pitch = glm::radians(camera.pitch), fov = glm::radians(camera.fov);
    const glm::vec3 centre = 0.5f * (boundsMin + boundsMax);
    const float radius = std::max(0.5f * glm::length(boundsMax - boundsMin), 1e-6f);

    view.target = camera.target.value_or(centre);
    // The picture's axes from the angles, not from cross products: looking straight down stays well defined.
    const glm::vec3 towardsEye = directionTo(camera.yaw, camera.pitch);
    view.right = {std::cos(yaw), 0.f, -std::sin(yaw)};
    view.up = {-std::sin(pitch) * std::sin(yaw), std::cos(pitch), -std::sin(pitch) * std::cos(yaw)};
    const glm::vec3 half = 0.5f * (boundsMax - boundsMin);
    const float height = std::tan(0.5f * fov), width = height * aspect;
    float framing = 1.27f * std::max(reach(half, view.right) / width, reach(half, view.up) / height) + 0.5f * reach(half, towardsEye);
    const auto box = corners(boundsMin, boundsMax);
    if (camera.fill > 0.f)
        framing = fillingDistance(view, towardsEye, camera.fill * glm::vec2(width, height), outline.empty() ? box : outline);
    view.distance = camera.distance.value_or(std::max(framing, 1e-6f));
    view.eye = view.target + view.distance * towardsEye;
    view.viewFromWorld = glm::mat4(glm::vec4(view.right.x, view.up.x, towardsEye.x, 0.f),
        glm::vec4(view.right.y, view.up.y, towardsEye.y, 0.f), glm::vec4(view.right.z, view.up.z, towardsEye.z, 0.f),
        glm::vec4(-glm::dot(view.right, view.eye), -glm::dot(view.up, view.eye), -glm::dot(towardsEye, view.eye), 1.f));

    const float toCentre = glm::length(view.eye - centre);
    const float far = toCentre + 2.f * radius, near = std::max(toCentre - 2.f * radius, 0.002f * std::min(view.distance, far));
    view.clipFromView = glm::perspective(fov, aspect, near, std::max(far, near * 1.001f));
    return view;
}

} // namespace relievo
