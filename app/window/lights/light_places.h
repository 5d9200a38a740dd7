// Where lights are seen in a picture, and where a hand in the picture brings them: functions of values.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/state/camera_view.h"
#include "core/state/lights.h"
#include <glm/vec2.hpp>

namespace relievo {

struct LightPlace {
    glm::vec2 share{0.f}; // of the picture from its upper left corner, within it
    bool isThere = true; // else it lies outside and is shown at the edge towards it
    bool isBehind = false; // on the far side of its sphere
};
// A directional light is shown a little outside of the mesh.
LightPlace lightPlace(const Parameters& parameters, const LightMembers& light, const Around& mesh, const CameraView& camera);
glm::vec2 middlePlace(const Around& mesh, const CameraView& camera); // of what lights shine on

// The light comes to where the hand is, on the sphere of its distance, on the side where it was; a hand that leaves the sphere brings it
// round to the other side.
void moveLight(
    Parameters& parameters, const LightMembers& light, const Around& mesh, const CameraView& camera, glm::vec2 share, bool behind);
void turnLight(Parameters& parameters, const LightMembers& light, double dx, double dy); // px of the hand, to the right and down
void pushLight(Parameters& parameters, const LightMembers& light, double steps); // of the wheel, an eighth closer each

} // namespace relievo
