// The clear sky of Preetham, Shirley and Smits 1999, A Practical Analytic Model for Daylight.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <glm/vec3.hpp>

namespace relievo {

class PreethamSky {
public:
    // sun: unit, towards it, above the horizon. turbidity: 2 (very clear) to 10 (haze).
    PreethamSky(glm::vec3 sun, float turbidity);
    // Of a direction above the horizon (others as at it): linear RGB, the zenith's luminance is 1. Without the disc of the sun.
    glm::vec3 radiance(glm::vec3 direction) const;

private:
    struct Perez { // appendix A.2: coefficients of luminance or chromaticity, its value at the zenith and the formula's value there
        float a, b, c, d, e, zenith, scale;
        float at(float cosZenith, float angle) const;
    };
    glm::vec3 m_sun;
    Perez m_luminance, m_x, m_y;
};

} // namespace relievo
