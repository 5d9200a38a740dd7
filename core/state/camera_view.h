// From the camera's angles to matrices: framing, eye and projection.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/state.h"
#include <glm/mat4x4.hpp>
#include <span>

namespace relievo {

struct CameraView {
    glm::vec3 eye, target; // m
    float distance; // m, eye to target
    glm::vec3 right, up; // unit, of the picture
    glm::mat4 viewFromWorld;
    glm::mat4 clipFromView; // OpenGL clip space, near and far fitted to the bounds
};

// What the camera sees of a box; aspect = width / height. Missing distance or target frame the box. What camera.fill speaks of are the
// points of `outline`; without any, the box's corners.
CameraView cameraView(
    const Camera& camera, glm::vec3 boundsMin, glm::vec3 boundsMax, float aspect, std::span<const glm::vec3> outline = {});

// Unit vector towards the light from its yaw and pitch (degrees; yaw 0 is +z, 90 is +x).
glm::vec3 directionTo(float yaw, float pitch);

} // namespace relievo
