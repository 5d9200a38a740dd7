// An environment as the faces of a cube map.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "core/image/environment.h"

namespace relievo {

// Texels of a face's side at a level of the environment.
constexpr int cubeSize(int level)
{
    return kEnvironmentWidth / 4 >> level;
}

// cubeSize x cubeSize linear radiances; faces in OpenGL's order (+x -x +y -y +z -z) and orientation.
std::vector<glm::vec3> cubeFace(const Environment& environment, int level, int face);

} // namespace relievo
