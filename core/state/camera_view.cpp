// Camera mathematics: orbit angles to matrices, framing a box.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/camera_view.h"
#include <algorithm>
#include <cmath>
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

CameraView cameraView(const Camera& camera, glm::vec3 boundsMin, glm::vec3 boundsMax, float aspect)
{
    CameraView view;
    const float yaw = glm::radians(camera.yaw), pitch = glm::radians(camera.pitch), fov = glm::radians(camera.fov);
    const glm::vec3 centre = 0.5f * (boundsMin + boundsMax);
    const float radius = std::max(0.5f * glm::length(boundsMax - boundsMin), 1e-6f);
    const float halfAngle = std::min(0.5f * fov, std::atan(std::tan(0.5f * fov) * aspect)); // the narrower side frames

    view.target = camera.target.value_or(centre);
    view.distance = camera.distance.value_or(0.78f * radius / std::sin(halfAngle));
    // The picture's axes from the angles, not from cross products: looking straight down stays well defined.
    const glm::vec3 towardsEye = directionTo(camera.yaw, camera.pitch);
    view.right = {std::cos(yaw), 0.f, -std::sin(yaw)};
    view.up = {-std::sin(pitch) * std::sin(yaw), std::cos(pitch), -std::sin(pitch) * std::cos(yaw)};
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
