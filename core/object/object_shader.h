// The searches of relief objects that pictures are drawn by, on the CPU: the same text as on the GPU, in single precision.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/object/object_texels.h"
#include "core/state/parameters.h"
#include <glm/vec3.hpp>
#include <string_view>

namespace relievo {

struct ObjectRayHit {
    bool found = false;
    double t = 0.; // point = origin + t * direction
    glm::dvec3 normal{0.}; // unit, outwards; of a ray that began inside: against it
    int fetches = 0;
};

// technique: a row of kTechniques for objects. texels: of the object. direction: of any length but 0. Nothing for a ray that is not finite.
ObjectRayHit searchObject(std::string_view technique, const Parameters& parameters, const ReliefObject& object, const ObjectTexels& texels,
    glm::dvec3 origin, glm::dvec3 direction);

} // namespace relievo
