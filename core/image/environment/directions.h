// Directions on the faces of a cube, and reading it by them.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/environment/cube.h"
#include <functional>
#include <numbers>

namespace relievo {

inline constexpr float kPi = std::numbers::pi_v<float>;

// A place on a face: a to the right and b down, both in [-1, 1] on the face itself.
struct CubePlace {
    int face;
    float a, b;
};
glm::vec3 cubeDirection(CubePlace place); // not normalised
CubePlace cubePlace(glm::vec3 direction);
constexpr float texelPlace(int i, int side) // of the centre of texel i
{
    return 2.f * (float(i) + 0.5f) / float(side) - 1.f;
}
// Solid angle of a texel, up to a factor that is the same for all of a cube.
float texelShare(float a, float b);

// `radiance` asked once for the centre of each texel, in many threads; the direction is a unit vector.
Cube cubeOf(int side, const std::function<glm::vec3(glm::vec3 direction)>& radiance);
std::size_t texelIndex(int side, glm::vec3 direction); // of the nearest texel; the direction may have any length
const glm::vec3& texelAt(const Cube& cube, glm::vec3 direction);
Cube halved(const Cube& cube); // by solid angle; side must be even
glm::vec3 meanOf(const Cube& cube); // over the sphere

// Bilinear, also across the edges of faces: a cube with a border of one texel around each face.
class SmoothCube {
public:
    explicit SmoothCube(const Cube& cube);
    glm::vec3 at(glm::vec3 direction) const;
    int side() const { return m_side; }

private:
    int m_side;
    std::vector<glm::vec3> m_texels;
};

} // namespace relievo
