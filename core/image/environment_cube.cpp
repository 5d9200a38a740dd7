// Faces of a cube map, read from the panorama.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/environment_cube.h"
#include "core/image/height_field.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace relievo {
namespace {
// Direction of a cube map's texel, OpenGL's face order and orientation; a, b in [-1, 1].
glm::vec3 cubeDirection(int face, float a, float b)
{
    switch (face) {
    case 0:
        return {1.f, -b, -a};
    case 1:
        return {-1.f, -b, a};
    case 2:
        return {a, 1.f, b};
    case 3:
        return {a, -1.f, -b};
    case 4:
        return {a, -b, 1.f};
    default:
        return {-a, -b, -1.f};
    }
}

// Bilinear read of an equirectangular level (environment.h's orientation).
glm::vec3 equirect(const std::vector<glm::vec3>& level, int width, glm::vec3 direction)
{
    constexpr float pi = 3.14159265f;
    direction = glm::normalize(direction);
    const int height = width / 2;
    const float x = (std::atan2(direction.x, -direction.z) / (2.f * pi) + 0.5f) * float(width) - 0.5f;
    const float y = std::acos(std::clamp(direction.y, -1.f, 1.f)) / pi * float(height) - 0.5f;
    const float fx = x - std::floor(x), fy = y - std::floor(y);
    const auto at = [&](int i, int j) {
        return level[std::size_t(wrapIndex(j, height, Wrap::Clamp)) * std::size_t(width) + std::size_t(wrapIndex(i, width, Wrap::Repeat))];
    };
    const int i = int(std::floor(x)), j = int(std::floor(y));
    return (at(i, j) * (1.f - fx) + at(i + 1, j) * fx) * (1.f - fy) + (at(i, j + 1) * (1.f - fx) + at(i + 1, j + 1) * fx) * fy;
}
} // namespace

std::vector<glm::vec3> cubeFace(const Environment& environment, int level, int face)
{
    const int size = cubeSize(level);
    std::vector<glm::vec3> texels;
    texels.reserve(std::size_t(size) * std::size_t(size));
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const float a = 2.f * (float(x) + 0.5f) / float(size) - 1.f, b = 2.f * (float(y) + 0.5f) / float(size) - 1.f;
            texels.push_back(equirect(environment.levels[std::size_t(level)], kEnvironmentWidth >> level, cubeDirection(face, a, b)));
        }
    return texels;
}

} // namespace relievo
