// The first hit of a ray with a relief object, in double precision: what faster searches are measured against.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/relief_object.h"
#include <optional>

namespace relievo {

// What of the object a ray met: the front or back of an interval, a wall where it ends sideways, or a face of the box. Inside: it began
// within the solid.
enum class HitOn { Front, Back, Wall, Box, Inside };

struct ObjectHit {
    double t = 0.; // point = origin + t * direction
    glm::dvec3 point{0.}, normal{0.}; // m; unit, outwards; of a ray that began inside: against it
    int axis = 0, layer = 0; // whose map it is on; of a face of the box the axis that the face stands across
    HitOn on = HitOn::Front;
};

// The smallest t in [0, end] at which origin + t * direction is inside (isInside). direction: of any length but 0. Nothing for a ray that
// is not finite. Walks the quarters of cells along each axis that is given; on each the depths along the ray are quadratics, solved in
// closed form.
std::optional<ObjectHit> firstHit(const ReliefObject& object, glm::dvec3 origin, glm::dvec3 direction, double end = 1e300);

} // namespace relievo
