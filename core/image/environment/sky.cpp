// Preetham's sky: appendix A.2 of the paper.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/environment/sky.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

namespace relievo {

namespace {
// CIE XYZ to linear sRGB, by column.
const glm::mat3 kRgbFromXyz(3.2406f, -0.9689f, 0.0557f, -1.5372f, 1.8758f, -0.204f, -0.4986f, 0.0415f, 1.057f);
} // namespace

float PreethamSky::Perez::at(float cosZenith, float angle) const
{
    const float cosine = std::cos(angle);
    return (1.f + a * std::exp(b / std::max(cosZenith, 0.01f))) * (1.f + c * std::exp(d * angle) + e * cosine * cosine);
}

PreethamSky::PreethamSky(glm::vec3 sun, float turbidity) : m_sun(sun)
{
    const float t = turbidity, zenith = std::acos(std::clamp(sun.y, 0.f, 1.f));
    const glm::vec4 powers(zenith * zenith * zenith, zenith * zenith, zenith, 1.f);
    const auto chromaticity = [&](glm::vec4 squared, glm::vec4 once, glm::vec4 alone) {
        return t * t * glm::dot(squared, powers) + t * glm::dot(once, powers) + glm::dot(alone, powers);
    };
    m_luminance
        = {0.1787f * t - 1.463f, -0.3554f * t + 0.4275f, -0.0227f * t + 5.3251f, 0.1206f * t - 2.5771f, -0.067f * t + 0.3703f, 1.f, 1.f};
    m_x = {-0.0193f * t - 0.2592f, -0.0665f * t + 0.0008f, -0.0004f * t + 0.2125f, -0.0641f * t - 0.8989f, -0.0033f * t + 0.0452f,
        chromaticity(
            {0.00166f, -0.00375f, 0.00209f, 0.f}, {-0.02903f, 0.06377f, -0.03202f, 0.00394f}, {0.11693f, -0.21196f, 0.06052f, 0.25886f}),
        1.f};
    m_y = {-0.0167f * t - 0.2608f, -0.095f * t + 0.0092f, -0.0079f * t + 0.2102f, -0.0441f * t - 1.6537f, -0.0109f * t + 0.0529f,
        chromaticity(
            {0.00275f, -0.0061f, 0.00317f, 0.f}, {-0.04214f, 0.0897f, -0.04153f, 0.00516f}, {0.15346f, -0.26756f, 0.0667f, 0.26688f}),
        1.f};
    for (Perez* perez : {&m_luminance, &m_x, &m_y})
        perez->scale = perez->zenith / perez->at(1.f, zenith);
}

glm::vec3 PreethamSky::radiance(glm::vec3 direction) const
{
    const float angle = std::acos(std::clamp(glm::dot(direction, m_sun), -1.f, 1.f)), up = std::max(direction.y, 0.f);
    const float luminance = m_luminance.scale * m_luminance.at(up, angle);
    const float x = m_x.scale * m_x.at(up, angle), y = std::max(m_y.scale * m_y.at(up, angle), 0.05f);
    return glm::max(kRgbFromXyz * (luminance * glm::vec3(x / y, 1.f, (1.f - x - y) / y)), glm::vec3(0.f));
}

} // namespace relievo
