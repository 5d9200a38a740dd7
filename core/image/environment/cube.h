// A picture of all directions on the faces of a cube.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace relievo {

// side x side linear RGB radiances a face; faces in OpenGL's order (+x -x +y -y +z -z) and orientation.
struct Cube {
    int side = 0;
    std::vector<glm::vec3> texels;

    std::span<const glm::vec3> face(int face) const
    {
        const std::size_t count = std::size_t(side) * std::size_t(side);
        return std::span(texels).subspan(std::size_t(face) * count, count);
    }
};

} // namespace relievo
