// The box of a mesh with its sides along x, y and z, and where points lie on the maps of its axes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/mesh/mesh.h"
#include "core/object/relief_object.h"

namespace relievo {

struct ObjectBox {
    glm::dvec3 center{0.}, half{0.5}; // m

    // u, v and depth of a point on an axis' maps, in 0..1 within the box.
    glm::dvec3 onAxis(std::size_t axis, glm::dvec3 point) const
    {
        const glm::dvec3 p = (point - center) / half;
        const AxisFrame& frame = kAxisFrames[axis];
        return 0.5 + 0.5 * glm::dvec3(glm::dot(p, frame.u), glm::dot(p, frame.v), glm::dot(p, frame.depth));
    }
};

// The bounds of the mesh's triangles; where it is flat a thousandth of its largest size. An error for a mesh without extent.
Expected<ObjectBox> boxOf(const Mesh& mesh);

} // namespace relievo
