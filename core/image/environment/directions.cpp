// Directions and texels of cubes.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/environment/directions.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

namespace relievo {

glm::vec3 cubeDirection(CubePlace place)
{
    const float a = place.a, b = place.b;
    switch (place.face) {
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

CubePlace cubePlace(glm::vec3 d)
{
    const float x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    if (x >= y && x >= z) {
        const float scale = 1.f / x;
        return d.x > 0.f ? CubePlace{0, -d.z * scale, -d.y * scale} : CubePlace{1, d.z * scale, -d.y * scale};
    }
    const float scale = 1.f / std::max(y, z);
    if (y >= z)
        return d.y > 0.f ? CubePlace{2, d.x * scale, d.z * scale} : CubePlace{3, d.x * scale, -d.z * scale};
    return d.z > 0.f ? CubePlace{4, d.x * scale, -d.y * scale} : CubePlace{5, -d.x * scale, -d.y * scale};
}

float texelShare(float a, float b)
{
    const float square = 1.f + a * a + b * b;
    return 1.f / (square * std::sqrt(square));
}

Cube cubeOf(int side, const std::function<glm::vec3(glm::vec3)>& radiance)
{
    Cube cube{side, std::vector<glm::vec3>(6 * std::size_t(side) * std::size_t(side))};
    tbb::parallel_for(0, 6 * side, [&](int row) {
        glm::vec3* texels = &cube.texels[std::size_t(row) * std::size_t(side)];
        for (int x = 0; x < side; ++x)
            texels[x] = radiance(glm::normalize(cubeDirection({row / side, texelPlace(x, side), texelPlace(row % side, side)})));
    });
    return cube;
}

std::size_t texelIndex(int side, glm::vec3 direction)
{
    const CubePlace place = cubePlace(direction);
    const float half = 0.5f * float(side);
    const int x = std::min(int((place.a + 1.f) * half), side - 1), y = std::min(int((place.b + 1.f) * half), side - 1);
    return std::size_t((place.face * side + y) * side + x);
}

const glm::vec3& texelAt(const Cube& cube, glm::vec3 direction)
{
    return cube.texels[texelIndex(cube.side, direction)];
}

Cube halved(const Cube& cube)
{
    const int side = cube.side / 2;
    Cube half{side, std::vector<glm::vec3>(6 * std::size_t(side) * std::size_t(side))};
    tbb::parallel_for(0, 6 * side, [&](int row) {
        const glm::vec3* above = &cube.texels[std::size_t(2 * row) * std::size_t(cube.side)];
        const glm::vec3* below = above + cube.side;
        const float b[] = {texelPlace(2 * (row % side), cube.side), texelPlace(2 * (row % side) + 1, cube.side)};
        for (int x = 0; x < side; ++x) {
            const float a[] = {texelPlace(2 * x, cube.side), texelPlace(2 * x + 1, cube.side)};
            const float shares[] = {texelShare(a[0], b[0]), texelShare(a[1], b[0]), texelShare(a[0], b[1]), texelShare(a[1], b[1])};
            half.texels[std::size_t(row) * std::size_t(side) + std::size_t(x)]
                = (shares[0] * above[2 * x] + shares[1] * above[2 * x + 1] + shares[2] * below[2 * x] + shares[3] * below[2 * x + 1])
                / (shares[0] + shares[1] + shares[2] + shares[3]);
        }
    });
    return half;
}

glm::vec3 meanOf(const Cube& cube)
{
    glm::dvec3 sum(0.);
    double area = 0.;
    for (int row = 0; row < 6 * cube.side; ++row)
        for (int x = 0; x < cube.side; ++x) {
            const float share = texelShare(texelPlace(x, cube.side), texelPlace(row % cube.side, cube.side));
            sum += glm::dvec3(cube.texels[std::size_t(row) * std::size_t(cube.side) + std::size_t(x)]) * double(share);
            area += double(share);
        }
    return glm::vec3(sum / area);
}

SmoothCube::SmoothCube(const Cube& cube) : m_side(cube.side), m_texels(6 * std::size_t(cube.side + 2) * std::size_t(cube.side + 2))
{
    tbb::parallel_for(0, 6 * (m_side + 2), [&](int row) {
        const int face = row / (m_side + 2), y = row % (m_side + 2) - 1;
        glm::vec3* texels = &m_texels[std::size_t(row) * std::size_t(m_side + 2)];
        for (int x = -1; x <= m_side; ++x) {
            texels[x + 1] = texelAt(cube, cubeDirection({face, texelPlace(x, m_side), texelPlace(y, m_side)}));
        }
    });
}

glm::vec3 SmoothCube::at(glm::vec3 direction) const
{
    const CubePlace place = cubePlace(direction);
    const float x = (place.a + 1.f) * 0.5f * float(m_side) + 0.5f, y = (place.b + 1.f) * 0.5f * float(m_side) + 0.5f;
    const int i = std::min(int(x), m_side), j = std::min(int(y), m_side);
    const float fx = x - float(i), fy = y - float(j);
    const glm::vec3* above = &m_texels[std::size_t(place.face * (m_side + 2) + j) * std::size_t(m_side + 2) + std::size_t(i)];
    const glm::vec3* below = above + m_side + 2;
    return (1.f - fy) * ((1.f - fx) * above[0] + fx * above[1]) + fy * ((1.f - fx) * below[0] + fx * below[1]);
}

} // namespace relievo
