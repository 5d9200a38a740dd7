// The sRGB transfer function (IEC 61966-2-1).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <cmath>

namespace relievo {

inline float linearOf(float srgb)
{
    return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

// Clamps to [0, 1]; white stays white.
inline float srgbOf(float linear)
{
    const float v = std::clamp(linear, 0.f, 1.f);
    return v >= 1.f ? 1.f : v <= 0.0031308f ? v * 12.92f : 1.055f * std::pow(v, 1.f / 2.4f) - 0.055f;
}

} // namespace relievo
